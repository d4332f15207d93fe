// Numbers as the screens write them: thousands apart by a narrow space, a true minus, units always, and no more digits
// than are true. Any thread.
#pragma once

#include <QString>

#include "core/model/verdict.h"
#include "ui/base/units.h"

namespace stillcut::ui {

// Between thousands: narrow, and no line breaks there.
inline constexpr QChar kThousandsSpace(0x202f);

// "1 713", "-235" with a true minus, "0.62", in German "0,62". Not finite: an en dash.
QString number(double value, int decimals = 0);
// Three significant digits at most: 0.062, 3.1, 31, 310, 3 100.
QString significant(double value, int digits = 2);
// "1 713 \u00b12 Hz"; the value is rounded to what the doubt allows. Without a known doubt: "about 1 713 Hz".
QString frequency(Hertz value, Hertz doubt);
QString percent(double ratio);                   // "97 %"
QString overrideText(double ratio);              // "97 %", "82.5 %": two ways to one override show one number
QString withSign(double value);                  // "+235", "-235"
QString duration(Seconds s);                     // "38 ms", "1.2 s", "2 min 05 s", "9 h 07 min"
QString lengthText(Metres m, UnitSystem units);  // "1.2 mm", "0.047 in"
double lengthIn(Metres m, UnitSystem units);     // as it is typed: mm or inches
Metres lengthFrom(double shown, UnitSystem units);
QString lengthUnit(UnitSystem units);
QString depthText(Metres m, UnitSystem units);             // "1.15 mm", "0.0453 in"
QString feedText(MetresPerSecond feed, UnitSystem units);  // "1 370 mm/min", "53.9 in/min"
QString feedUnit(UnitSystem units);
double feedIn(MetresPerSecond feed, UnitSystem units);
MetresPerSecond feedFrom(double shown, UnitSystem units);
QString cuttingSpeedText(MetresPerSecond v, UnitSystem units);  // "323 m/min", "1 060 ft/min"
double removalIn(double cubicMetresPerSecond, UnitSystem units);
QString removalUnit(UnitSystem units);
QString rpmUnit();                                                   // "rpm"; in German "1/min"
QString removalText(double cubicMetresPerSecond, UnitSystem units);  // "14.2 cm3/min" with a true superscript
QString clockTime(qint64 wallMs);                                    // "13:58:04", local time
QString stopwatch(Seconds s);                                        // "00:12:40"
QString join(const QString& value, const QString& unit);             // with a space that does not break
// A file's name that a wrapped label may break between its parts, and within a part too long for a narrow line. It
// looks the same: only breaks without a width are added.
QString breakable(const QString& name);

}  // namespace stillcut::ui
