// How a SessionTimeline looks.
#include <QFileInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/models/session_models.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/recording_curve.h"
#include "ui/plots/session_timeline.h"

namespace stillcut::ui {

double SessionTimeline::scaleTop() const {
  return std::max(loudest(*summary_), besideShown() ? loudest(*beside_) : 0.0);
}

// The other recording over this one, from its first sample on, in the same scale.
void SessionTimeline::paintBeside(QPainter& p, const QRectF& box) const {
  const double top = scaleTop();
  if (!(top > 0.0)) return;
  QPolygonF line;
  for (const SummaryPoint& point : beside_->curve)
    line << QPointF(xOf(point.time.value), box.bottom() - point.vibration / top * (box.height() - 2));
  p.setPen(QPen(theme_.colors.advice, theme_.px(1.5), Qt::DashLine));
  p.setBrush(Qt::NoBrush);
  p.drawPolyline(line);
}

// Which half of a detector's row is which, in the corner below the names.
void SessionTimeline::paintLegend(QPainter& p, const QRectF& box) {
  const std::array<std::pair<QString, QColor>, 2> entries{
      {{tr("before"), theme_.colors.fill}, {tr("after"), theme_.colors.onset}}};
  const double half = box.height() / 2.0, square = theme_.px(10);
  p.setFont(theme_.font(type_size::kTick - 3));
  clipped_ = false;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto& [text, color] = entries[k];
    const QRectF row(box.left(), box.top() + half * static_cast<double>(k), box.width(), half);
    p.fillRect(QRectF(row.right() - square, row.center().y() - square / 4, square, square / 2), color);
    const QRectF room = row.adjusted(0, 0, -square - theme_.px(4), 0);
    clipped_ = clipped_ || QFontMetricsF(p.font()).horizontalAdvance(text) > room.width();
    p.setPen(theme_.colors.secondary);
    p.drawText(room, Qt::AlignVCenter | Qt::AlignRight, text);
  }
}

void SessionTimeline::paintCurve(QPainter& p, const QRectF& box) const {
  const double top = scaleTop();
  if (!(top > 0.0)) return;
  QPainterPath path;
  path.moveTo(xOf(0.0), box.bottom());
  for (const SummaryPoint& point : summary_->curve) {
    path.lineTo(xOf(point.time.value), box.bottom() - point.vibration / top * (box.height() - 2));
  }
  path.lineTo(xOf(length()), box.bottom());
  p.setPen(Qt::NoPen);
  p.setBrush(theme_.colors.fill);
  p.drawPath(path);
  // The points of a session lie a step apart, further only where samples are missing: from the end of the step before
  // to the begin of the next one nothing is known for certain.
  const auto& curve = summary_->curve;
  double step = length();
  for (std::size_t k = 1; k < curve.size(); ++k) {
    step = std::min(step, curve[k].time.value - curve[k - 1].time.value);
  }
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (!curve[k].gap) continue;
    const double from = k > 0 ? curve[k - 1].time.value + 0.5 * step : 0.0;
    const double to = k + 1 < curve.size() ? curve[k + 1].time.value - 0.5 * step : length();
    p.fillRect(QRectF(xOf(from), box.top(), std::max(2.0, xOf(to) - xOf(from)), box.height()), theme_.colors.gap);
  }
}

// From the slowest to the fastest of the recording, so that every move is seen; the row's name says which those are.
void SessionTimeline::paintSpeed(QPainter& p, const QRectF& box) const {
  p.fillRect(box, theme_.colors.track);
  const auto [slowest, fastest] = speedRange();
  const double width = std::max(fastest - slowest, 0.02 * fastest);
  QPolygonF line;
  const auto draw = [&] {
    p.setPen(QPen(theme_.colors.text, theme_.px(1.5)));
    p.drawPolyline(line);
    line.clear();
  };
  for (const SummaryPoint& point : summary_->curve) {
    if (!(point.speed.value > 0.0) || point.gap) {
      draw();
      continue;
    }
    line << QPointF(xOf(point.time.value),
                    box.bottom() - 1.0 - (point.speed.value - slowest) / width * (box.height() - 2.0));
  }
  draw();
}

std::pair<double, double> SessionTimeline::speedRange() const {
  std::pair<double, double> range{0.0, 0.0};
  if (!summary_) return range;
  for (const SummaryPoint& point : summary_->curve) {
    const double speed = point.speed.value;
    if (!(speed > 0.0)) continue;
    range.first = range.second > 0.0 ? std::min(range.first, speed) : speed;
    range.second = std::max(range.second, speed);
  }
  return range;
}

void SessionTimeline::paintBand(QPainter& p, const QRectF& box, const std::vector<AlarmSpan>& spans,
                                const QColor& color) const {
  p.fillRect(box, theme_.colors.track);
  for (const AlarmSpan& span : spans) {
    const double left = xOf(span.begin.value);
    p.fillRect(QRectF(left, box.top(), std::max(xOf(span.end.value) - left, 2.0), box.height()), color);
  }
}

void SessionTimeline::paintMarks(QPainter& p, const QRectF& box) const {
  p.setFont(theme_.font(type_size::kTick, true));
  for (const Mark& mark : marks_) {
    const QColor color = theme_.onPanel(mark.tone);
    const double left = xOf(mark.begin.value), right = xOf(mark.end.value);
    if (right > left + 1) {
      QColor wash = color;
      wash.setAlpha(40);
      p.fillRect(QRectF(left, box.top(), right - left, box.height()), wash);
    }
    p.setPen(QPen(color, theme_.px(2)));
    p.drawLine(QPointF(left, box.top()), QPointF(left, box.bottom()));
    const QPointF flag(left, box.top());
    p.setBrush(color);
    p.drawPolygon(QPolygonF() << flag << flag + QPointF(theme_.px(9), theme_.px(5))
                              << flag + QPointF(0, theme_.px(10)));
    // On a patch of its own: the curve may run behind it.
    const QFontMetricsF metrics(p.font());
    const QString text = metrics.elidedText(mark.text, Qt::ElideRight, theme_.px(160));
    const QRectF patch(left + theme_.px(11), box.top(), metrics.horizontalAdvance(text) + theme_.px(6), theme_.px(17));
    p.fillRect(patch, theme_.colors.panel);
    p.drawText(patch, Qt::AlignCenter, text);
  }
}

// The recording's own time of day, where it is told; else the time since its beginning.
QString SessionTimeline::tickText(double seconds, double step) const {
  if (summary_->started_ns <= 0) return timeText(Seconds(seconds));
  const qint64 wallMs = summary_->started_ns / 1'000'000 + std::llround(seconds * 1e3);
  if (step >= 1.0) return clockTime(wallMs);
  return QStringLiteral("%1.%2").arg(clockTime(wallMs)).arg(wallMs % 1000 / 10, 2, 10, QChar(u'0'));
}

void SessionTimeline::paintAxis(QPainter& p, const QRectF& box) const {
  p.setFont(theme_.font(type_size::kTick));
  p.setPen(theme_.colors.secondary);
  const auto ticks = niceTicks(viewFrom_, viewTo_, std::max(2, static_cast<int>(box.width() / theme_.px(110))));
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  for (const double tick : ticks) {
    const double x = xOf(tick);
    p.drawLine(QPointF(x, box.bottom()), QPointF(x, box.bottom() + theme_.px(4)));
    p.drawText(QRectF(x - theme_.px(50), box.bottom() + theme_.px(4), theme_.px(100), theme_.px(18)), Qt::AlignCenter,
               tickText(tick, step));
  }
}

// Longer than a screen: one layer after the other, in the order in which they cover each other
void SessionTimeline::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setFont(theme_.font(type_size::kBody));
  if (!summary_) {
    p.setPen(theme_.colors.secondary);
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("Choose a recording on the left"));
    return;
  }
  const QRectF box = plot();
  const double row = theme_.px(kRow);
  const auto [slowest, fastest] = speedRange();
  const bool speedKnown = fastest > 0.0;
  const double bands =
      (1.0 + (speedKnown ? 1.0 : 0.0) + (besideShown() ? 1.0 : 0.0) + static_cast<double>(tracks_.size())) * row;
  const QRectF curve(box.left(), box.top(), box.width(), std::max(box.height() - bands - theme_.px(6), 10.0));
  p.save();
  p.setClipRect(box.adjusted(-1, 0, 1, 1));
  if (hasSelection()) {
    QColor wash = theme_.colors.advice;
    wash.setAlpha(46);
    p.fillRect(
        QRectF(xOf(selectedFrom().value), box.top(), xOf(selectedTo().value) - xOf(selectedFrom().value), box.height()),
        wash);
  }
  paintCurve(p, curve);
  if (besideShown()) paintBeside(p, curve);
  double y = curve.bottom() + theme_.px(6);
  if (speedKnown) {
    paintSpeed(p, QRectF(box.left(), y, box.width(), row - theme_.px(6)));
    y += row;
  }
  paintBand(p, QRectF(box.left(), y, box.width(), row - theme_.px(6)), recorded_, theme_.colors.chatter);
  if (besideShown()) {
    y += row;
    paintBand(p, QRectF(box.left(), y, box.width(), row - theme_.px(6)), besideAlarms_, theme_.colors.advice);
  }
  for (const DetectorTrack& track : tracks_) {
    y += row;
    const double half = (row - theme_.px(6)) / 2.0;
    paintBand(p, QRectF(box.left(), y, box.width(), half), track.before, theme_.colors.fill);
    paintBand(p, QRectF(box.left(), y + half, box.width(), half), track.after, theme_.colors.onset);
  }
  paintMarks(p, curve);
  const double now = xOf(replay_.position.value);
  p.setPen(QPen(theme_.colors.advice, theme_.px(2)));
  p.drawLine(QPointF(now, box.top()), QPointF(now, box.bottom()));
  p.restore();

  p.setPen(theme_.colors.secondary);
  p.setFont(theme_.font(type_size::kLabel));
  const auto name = [&](double top, double height, const QString& text) {
    const QRectF place(theme_.px(4), top, theme_.px(kNames) - theme_.px(10), height);
    const QString fitted = QFontMetricsF(p.font()).elidedText(text, Qt::ElideRight, place.width());
    p.drawText(place, Qt::AlignVCenter | Qt::AlignRight, fitted);
  };
  name(curve.top(), curve.height(), tr("vibration"));
  if (const double top = scaleTop(); top > 0.0 && curve.height() > theme_.px(54)) {
    name(curve.top(), theme_.px(18), join(significant(top), vibrationUnit(*summary_)));
    name(curve.bottom() - theme_.px(18), theme_.px(18), QStringLiteral("0"));
  }
  y = curve.bottom() + theme_.px(6);
  if (speedKnown) {
    const bool moved = fastest - slowest > 0.005 * fastest;
    name(y, row - theme_.px(6),
         join(moved ? QStringLiteral("%1\u2013%2").arg(number(slowest), number(fastest)) : number(fastest), rpmUnit()));
    y += row;
  }
  name(y, row - theme_.px(6), tr("as recorded"));
  if (besideShown()) {
    y += row;
    name(y, row - theme_.px(6), QFileInfo(QString::fromStdString(beside_->file)).completeBaseName());
  }
  for (const DetectorTrack& track : tracks_) {
    y += row;
    name(y, row - theme_.px(6), track.detector);
  }
  paintAxis(p, box);
  if (std::ranges::any_of(tracks_, &DetectorTrack::compared)) {
    paintLegend(p,
                {double(theme_.px(4)), box.bottom(), double(theme_.px(kNames - kFirstTime)), double(theme_.px(kAxis))});
  }
  if (hasFocus()) {
    p.setPen(QPen(theme_.colors.advice, theme_.px(2)));
    p.setBrush(Qt::NoBrush);
    p.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
}

}  // namespace stillcut::ui
