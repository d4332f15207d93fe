#include "ui/models/time_text.h"

#include <QDateTime>
#include <QRegularExpression>
#include <cmath>

namespace stillcut::ui {

std::optional<Instant> momentFrom(const QString& text, const SessionInfo& info, Instant newest) {
  const QString clean = text.trimmed();
  static const QRegularExpression kClock(QStringLiteral("^(\\d{1,2}):(\\d{2})(?::(\\d{2})(?:[.,](\\d{1,3}))?)?$"));
  static const QRegularExpression kBack(QStringLiteral("^[-\u2212](\\d+(?:[.,]\\d+)?)\\s*s?$"));
  if (const auto back = kBack.match(clean); back.hasMatch()) {
    return newest - toDuration(Seconds(back.captured(1).replace(u',', u'.').toDouble()));
  }
  const auto clock = kClock.match(clean);
  if (!clock.hasMatch()) return std::nullopt;
  const QTime time(clock.captured(1).toInt(), clock.captured(2).toInt(), clock.captured(3).toInt(),
                   clock.captured(4).leftJustified(3, u'0').toInt());
  if (!time.isValid()) return std::nullopt;
  const QDateTime now = QDateTime::fromMSecsSinceEpoch(info.wallMs(newest));
  qint64 wanted = QDateTime(now.date(), time).toMSecsSinceEpoch();
  // At five past midnight 23:58 is yesterday's; what is only just ahead is a slip of the finger.
  constexpr qint64 kHour = 3'600'000;
  if (wanted > now.toMSecsSinceEpoch() + kHour) wanted = QDateTime(now.date().addDays(-1), time).toMSecsSinceEpoch();
  return newest + std::chrono::milliseconds(wanted - info.wallMs(newest));
}

}  // namespace stillcut::ui
