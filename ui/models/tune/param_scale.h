// Where a parameter's value lies on a slider, and what the next value up or down is. Ranges over more than two decades
// are logarithmic; whole numbers and choices go by ones. Pure functions, any thread.
#pragma once

#include <QString>
#include <optional>

#include "core/config/param.h"

namespace stillcut::ui {

// 0 .. 1; automatic: where the default would be, the middle where there is none.
double fractionOf(const config::ParamDecl& decl, double value);
// Rounded to three significant digits, and legal.
double valueAt(const config::ParamDecl& decl, double fraction);
// One step of the keys and of the buttons beside the value: 1, 2, 5 on a logarithmic range, a fiftieth of a linear one.
double stepFrom(const config::ParamDecl& decl, double value, int direction);

// "0.2", "12", "on", "auto"; without the unit.
QString valueText(const config::ParamDecl& decl, double value);
// What a person typed, comma or point; empty: it is no legal value.
std::optional<double> valueFrom(const config::ParamDecl& decl, const QString& text);
// "0.01 to 1", with the unit.
QString rangeText(const config::ParamDecl& decl);

}  // namespace stillcut::ui
