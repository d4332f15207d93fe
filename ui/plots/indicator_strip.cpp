#include "ui/plots/indicator_strip.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"

namespace stillcut::ui {
namespace {

constexpr double kAboveLimit = 2.5;  // of the limit: what lies higher is an alarm anyway

}  // namespace

IndicatorStrip::IndicatorStrip(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void IndicatorStrip::add(const Point& point) {
  if (!points_.empty() && point.time <= points_.back().time) {
    if (point.time == points_.back().time) return;
    points_.clear();  // a replay was set back
  }
  points_.push_back(point);
  while (secondsBetween(points_.front().time, point.time) > kShown) points_.pop_front();
}

void IndicatorStrip::clear() {
  points_.clear();
  update();
}

void IndicatorStrip::display(const QString& name, qint64 wallMs) {
  name_ = name;
  wallMs_ = wallMs;
  setAccessibleName(name);
  if (!points_.empty()) {
    setAccessibleDescription(
        tr("%1, limit %2").arg(significant(points_.back().value), significant(points_.back().limit)));
  }
  update();
}

double IndicatorStrip::fullScale() const {
  double full = 0.0;
  for (const Point& point : points_) {
    if (std::isfinite(point.limit)) full = std::max(full, kAboveLimit * point.limit);
  }
  for (const Point& point : points_) {
    if (!(full > 0.0) && std::isfinite(point.value)) full = std::max(full, point.value);
  }
  return full > 0.0 ? full : 1.0;
}

void IndicatorStrip::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double head = theme_.px(24), foot = theme_.px(22), side = theme_.px(96);
  const QRectF plot(theme_.px(4), head, width() - side - theme_.px(4), height() - head - foot);
  p.setFont(theme_.font(type_size::kLabel, true));
  p.setPen(theme_.colors.secondary);
  p.drawText(QRectF(plot.left(), 0, width() - plot.left(), head), Qt::AlignVCenter | Qt::AlignLeft, name_);
  p.fillRect(plot, theme_.colors.track);
  if (points_.empty() || plot.height() < 10) return;
  const Instant end = points_.back().time;
  const double full = fullScale();
  const auto xOf = [&](Instant t) { return plot.right() - secondsBetween(t, end) / kShown * plot.width(); };
  const auto yOf = [&](double value) { return plot.bottom() - std::clamp(value / full, 0.0, 1.0) * plot.height(); };
  p.save();
  p.setClipRect(plot.adjusted(0, -1, 0, 1));
  QPolygonF line, limit;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Point& point = points_[k];
    const double x = xOf(point.time), next = k + 1 < points_.size() ? xOf(points_[k + 1].time) : plot.right();
    const bool alarms = point.state == CutState::Onset || point.state == CutState::Chatter;
    if (alarms && std::isfinite(point.value)) {
      QColor wash = theme_.back(point.state == CutState::Chatter ? Tone::Chatter : Tone::Onset);
      wash.setAlpha(70);
      p.fillRect(QRectF(x, plot.top(), next - x, plot.height()), wash);
    }
    if (std::isfinite(point.value)) line << QPointF(x, yOf(point.value));
    if (!std::isfinite(point.value) && !line.isEmpty()) {
      p.setPen(QPen(theme_.colors.text, theme_.px(1.5)));
      p.drawPolyline(line);
      line.clear();
    }
    if (std::isfinite(point.limit)) limit << QPointF(x, yOf(point.limit));
  }
  p.setPen(QPen(theme_.colors.text, theme_.px(1.5)));
  p.drawPolyline(line);
  p.setPen(QPen(theme_.colors.onsetText, theme_.px(2), Qt::DashLine));
  p.drawPolyline(limit);
  p.restore();
  const Point& now = points_.back();
  p.setFont(theme_.font(type_size::kTick, true));
  if (std::isfinite(now.limit)) {
    p.setPen(theme_.colors.onsetText);
    p.drawText(QRectF(plot.right() + theme_.px(6), yOf(now.limit) - theme_.px(10), side, theme_.px(20)),
               Qt::AlignVCenter | Qt::AlignLeft, tr("limit %1").arg(significant(now.limit)));
  }
  paintTimes(p, plot);
}

void IndicatorStrip::paintTimes(QPainter& p, const QRectF& plot) const {
  constexpr double kEvery = 5.0;  // s
  p.setFont(theme_.font(type_size::kTick));
  p.setPen(theme_.colors.secondary);
  const double end = static_cast<double>(wallMs_ + toNs(points_.back().time) / 1'000'000) * 1e-3;
  for (double t = std::ceil((end - kShown.value) / kEvery) * kEvery; t <= end; t += kEvery) {
    const double x = plot.right() - (end - t) / kShown.value * plot.width();
    const QRectF place(x - theme_.px(40), plot.bottom() + theme_.px(2), theme_.px(80), theme_.px(18));
    if (place.left() < 0 || place.right() > width()) continue;
    p.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + theme_.px(3)));
    p.drawText(place, Qt::AlignCenter, clockTime(std::llround(t * 1e3)));
  }
}

void IndicatorStrip::applyTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

QSize IndicatorStrip::minimumSizeHint() const {
  return {theme_.px(300), theme_.px(96)};
}

}  // namespace stillcut::ui
