#include "ui/base/format.h"

#include <QDateTime>
#include <algorithm>
#include <cmath>

#include "core/base/conversions.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr QChar kNoBreakSpace(0x00a0);
constexpr QChar kMinus(0x2212);
constexpr QChar kUnknown(0x2013);
constexpr QChar kBreakHere(0x200b);

}  // namespace

QString number(double value, int decimals) {
  if (!std::isfinite(value)) return kUnknown;
  QString digits = QString::number(std::abs(value), 'f', decimals);
  const bool isZero = std::all_of(digits.cbegin(), digits.cend(), [](QChar c) { return c == u'0' || c == u'.'; });
  const qsizetype dot = digits.indexOf(u'.');
  if (dot >= 0) digits.replace(dot, 1, say("."));  // the decimal mark of the language
  for (qsizetype i = (dot < 0 ? digits.size() : dot) - 3; i > 0; i -= 3) digits.insert(i, kThousandsSpace);
  return value < 0 && !isZero ? kMinus + digits : digits;
}

QString significant(double value, int digits) {
  if (!std::isfinite(value)) return kUnknown;
  if (std::abs(value) < 1e-12) return QStringLiteral("0");
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  return number(value, std::clamp(digits - before, 0, 6));
}

QString join(const QString& value, const QString& unit) {
  return unit.isEmpty() ? value : value + kNoBreakSpace + unit;
}

QString frequency(Hertz value, Hertz doubt) {
  if (!(value.value > 0)) return {};
  const bool known = std::isfinite(doubt.value) && doubt.value > 0;
  if (!known) return say("about %1").arg(join(number(value.value), QStringLiteral("Hz")));
  const double step = doubt.value >= 100 ? 100 : doubt.value >= 20 ? 10 : 1;
  const double shown = std::round(value.value / step) * step;
  const double sd = std::max(std::ceil(doubt.value / step) * step, 1.0);
  return join(number(shown) + kNoBreakSpace + QChar(0x00b1) + number(sd), QStringLiteral("Hz"));
}

QString percent(double ratio) {
  return join(number(ratio * 100.0), QStringLiteral("%"));
}

QString overrideText(double ratio) {
  const double shown = std::round(ratio * 1e3) / 10.0;
  return join(number(shown, shown == std::round(shown) ? 0 : 1), QStringLiteral("%"));
}

QString withSign(double value) {
  return value > 0 ? u'+' + number(value) : number(value);
}

QString duration(Seconds s) {
  if (!std::isfinite(s.value)) return kUnknown;
  if (s.value < 0.9995) return join(number(s.value * 1e3), QStringLiteral("ms"));
  if (s.value < 60) return join(number(s.value, s.value < 9.95 ? 1 : 0), QStringLiteral("s"));
  const auto whole = static_cast<qint64>(s.value);
  const QString seconds = QStringLiteral("%1").arg(whole % 60, 2, 10, QChar(u'0'));
  const qint64 minutes = whole / 60;
  if (minutes >= 60) {
    const QString rest = QStringLiteral("%1").arg(minutes % 60, 2, 10, QChar(u'0'));
    const qint64 hours = minutes / 60;
    return join(number(static_cast<double>(hours)), QStringLiteral("h")) + kNoBreakSpace +
           join(rest, QStringLiteral("min"));
  }
  return join(number(static_cast<double>(minutes)), QStringLiteral("min")) + kNoBreakSpace +
         join(seconds, QStringLiteral("s"));
}

QString lengthText(Metres m, UnitSystem units) {
  if (units == UnitSystem::Inch) {
    const double inch = m.value / kInch;
    return join(number(inch, inch < 9.9995 ? 3 : 1), QStringLiteral("in"));
  }
  const double mm = m.value * 1e3;
  return join(number(mm, mm < 99.95 ? 1 : 0), QStringLiteral("mm"));
}

double lengthIn(Metres m, UnitSystem units) {
  return units == UnitSystem::Inch ? m.value / kInch : m.value * 1e3;
}

Metres lengthFrom(double shown, UnitSystem units) {
  return Metres(units == UnitSystem::Inch ? shown * kInch : shown * 1e-3);
}

QString lengthUnit(UnitSystem units) {
  return units == UnitSystem::Inch ? QStringLiteral("in") : QStringLiteral("mm");
}

QString depthText(Metres m, UnitSystem units) {
  if (units == UnitSystem::Inch) return join(number(m.value / kInch, 4), QStringLiteral("in"));
  return join(number(m.value * 1e3, 2), QStringLiteral("mm"));
}

double feedIn(MetresPerSecond feed, UnitSystem units) {
  return units == UnitSystem::Inch ? feed.value * 60.0 / kInch : toMmPerMin(feed);
}

MetresPerSecond feedFrom(double shown, UnitSystem units) {
  return units == UnitSystem::Inch ? MetresPerSecond(shown * kInch / 60.0) : fromMmPerMin(shown);
}

QString feedUnit(UnitSystem units) {
  return units == UnitSystem::Inch ? QStringLiteral("in/min") : QStringLiteral("mm/min");
}

QString feedText(MetresPerSecond feed, UnitSystem units) {
  return join(number(feedIn(feed, units), units == UnitSystem::Inch ? 1 : 0), feedUnit(units));
}

QString rpmUnit() {
  return say("rpm");
}

QString cuttingSpeedText(MetresPerSecond v, UnitSystem units) {
  if (units == UnitSystem::Inch) return join(number(v.value * 60.0 / (12.0 * kInch)), QStringLiteral("ft/min"));
  return join(number(v.value * 60.0), QStringLiteral("m/min"));
}

double removalIn(double cubicMetresPerSecond, UnitSystem units) {
  return cubicMetresPerSecond * 60.0 / (units == UnitSystem::Inch ? kInch * kInch * kInch : 1e-6);
}

QString removalUnit(UnitSystem units) {
  return units == UnitSystem::Inch ? QStringLiteral("in\u00b3/min") : QStringLiteral("cm\u00b3/min");
}

QString removalText(double cubicMetresPerSecond, UnitSystem units) {
  return join(significant(removalIn(cubicMetresPerSecond, units), 3), removalUnit(units));
}

QString clockTime(qint64 wallMs) {
  return QDateTime::fromMSecsSinceEpoch(wallMs).toString(QStringLiteral("HH:mm:ss"));
}

QString stopwatch(Seconds s) {
  const auto whole = static_cast<qint64>(std::max(s.value, 0.0));
  const QChar zero(u'0');
  return QStringLiteral("%1:%2:%3")
      .arg(whole / 3600, 2, 10, zero)
      .arg(whole / 60 % 60, 2, 10, zero)
      .arg(whole % 60, 2, 10, zero);
}

QString breakable(const QString& name) {
  constexpr int kLongestPart = 16;  // characters: fits the narrowest column in the largest type of a title
  QString out;
  int whole = 0;
  for (const QChar c : name) {
    out += c;
    const bool joins = !c.isLetterOrNumber() && !c.isSurrogate();
    whole = joins ? 0 : whole + 1;
    if ((joins && !c.isSpace()) || (whole >= kLongestPart && !c.isHighSurrogate())) {
      out += kBreakHere;
      whole = 0;
    }
  }
  return out;
}

}  // namespace stillcut::ui
