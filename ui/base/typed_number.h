// Numbers as people type them. Any thread.
#pragma once

#include <QString>

namespace stillcut::ui {

// A speed or a feed: "9000", "9 000", "9,000", "9'000", "8500.5", "8500,5". A comma before exactly three digits parts
// thousands: nobody types thousandths of a revolution. Not a number: 0 and `isNumber` false.
double typedSpeed(QString text, bool* isNumber = nullptr);
// The same as text that every reader of numbers takes.
QString plainSpeed(QString text);

}  // namespace stillcut::ui
