#include "ui/plots/lobe_chart.h"

#include <QAreaSeries>
#include <QChart>
#include <QGraphicsLayout>
#include <QKeyEvent>
#include <QLineSeries>
#include <QMouseEvent>
#include <QScatterSeries>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "ui/models/format.h"
#include "ui/plots/nice_ticks.h"

namespace stillcut::ui {
namespace {

constexpr double kInch = 0.0254;

QImage triangleMarker(int size, const QColor& color) {
  QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter p(&image);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  p.setBrush(color);
  p.drawPolygon(QPolygonF{{size / 2.0, 0.0}, {double(size), double(size)}, {0.0, double(size)}});
  return image;
}

// A new range with round numbers. The old distance of ticks must not meet the new range: Qt would lay out every one.
void setRound(QValueAxis& axis, double from, double to, int most) {
  axis.setTickType(QValueAxis::TicksFixed);
  axis.setRange(from, to);
  const std::vector<double> ticks = niceTicks(from, to, most);
  if (ticks.size() < 2) return;
  const double step = ticks[1] - ticks[0];
  axis.setTickAnchor(ticks[0]);
  axis.setTickInterval(step);
  axis.setLabelFormat(QStringLiteral("%.%1f").arg(decimalsFor(step)));
  axis.setTickType(QValueAxis::TicksDynamic);
}

}  // namespace

LobeChart::LobeChart(QWidget* parent)
    : QChartView(parent),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      speed_(new QValueAxis(this)),
      depth_(new QValueAxis(this)),
      limit_(new QLineSeries(this)),
      floor_(new QLineSeries(this)),
      quiet_(new QAreaSeries(limit_, floor_)),
      trail_(new QLineSeries(this)),
      metStable_(new QScatterSeries(this)),
      metUnstable_(new QScatterSeries(this)) {
  setRenderHint(QPainter::Antialiasing);
  setFocusPolicy(Qt::StrongFocus);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Stability diagram"));
  setToolTip(tr("Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth?"));
  chart()->legend()->hide();
  chart()->setMargins({0, 0, 0, 0});
  chart()->setBackgroundRoundness(0);
  chart()->layout()->setContentsMargins(0, 0, 0, 0);
  chart()->addAxis(speed_, Qt::AlignBottom);
  chart()->addAxis(depth_, Qt::AlignLeft);
  for (QAbstractSeries* series :
       std::initializer_list<QAbstractSeries*>{quiet_, limit_, trail_, metStable_, metUnstable_}) {
    chart()->addSeries(series);
    series->attachAxis(speed_);
    series->attachAxis(depth_);
  }
  showFrame();
}

double LobeChart::shown(Metres depth) const {
  return units_ == UnitSystem::Inch ? depth.value / kInch : depth.value * 1e3;
}

Metres LobeChart::depthOf(double value) const {
  return Metres(units_ == UnitSystem::Inch ? value * kInch : value * 1e-3);
}

void LobeChart::setUnits(UnitSystem units) {
  if (units == units_) return;
  units_ = units;
  showFrame();
}

void LobeChart::showFrame() {
  const double lowest = frame_.lowest.value, highest = std::max(frame_.highest.value, lowest + 1.0);
  setRound(*speed_, lowest, highest, 6);
  setRound(*depth_, 0.0, std::max(shown(frame_.maxDepth), 1e-6), 5);
  speed_->setTitleText(tr("spindle speed [rpm]"));
  depth_->setTitleText(units_ == UnitSystem::Inch ? tr("depth of cut [in]") : tr("depth of cut [mm]"));
}

void LobeChart::setDiagram(const LobeDiagram* diagram, const LobeFrame& frame) {
  frame_ = frame;
  showFrame();
  QList<QPointF> limit, floor;
  if (diagram != nullptr) {
    for (const LobeLimit& l : diagram->limits) {
      limit << QPointF(l.speed.value, std::min(shown(l.depth), depth_->max()));
      floor << QPointF(l.speed.value, 0.0);
    }
  }
  limit_->replace(limit);
  floor_->replace(floor);
  islands_.clear();
  if (diagram == nullptr) return;
  const auto& limits = diagram->limits;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const Rpm left = k > 0 ? (limits[k - 1].speed + limits[k].speed) * 0.5 : limits[k].speed;
    const Rpm right = k + 1 < limits.size() ? (limits[k + 1].speed + limits[k].speed) * 0.5 : limits[k].speed;
    for (const DepthSpan& span : limits[k].islands) islands_.push_back({left, right, span});
  }
}

void LobeChart::setWork(std::optional<SpeedDepth> now, const std::vector<MetPoint>& met) {
  QList<QPointF> trail, stable, unstable;
  for (const MetPoint& point : met) {
    const QPointF at(point.speed.value, shown(point.depth));
    trail << at;
    (point.unstable ? unstable : stable) << at;
  }
  if (now) trail << QPointF(now->speed.value, shown(now->depth));
  if (trail == trail_->points()) return;  // a chart is dear to draw
  trail_->replace(trail);
  metStable_->replace(stable);
  metUnstable_->replace(unstable);
  now_ = now;
  viewport()->update();
}

void LobeChart::setAdvice(std::optional<Rpm> target) {
  if (target == advice_) return;
  viewport()->update();
  advice_ = target;
}

void LobeChart::setHandle(SpeedDepth handle) {
  handle_ = handle;
  viewport()->update();
}

QPointF LobeChart::onChart(SpeedDepth point) const {
  return chart()->mapToPosition(QPointF(point.speed.value, shown(point.depth)), limit_);
}

QPoint LobeChart::place(SpeedDepth point) const {
  return mapFromScene(chart()->mapToScene(onChart(point)));
}

void LobeChart::applyTheme(const Theme& theme) {
  theme_ = theme;
  const ThemeColors& c = theme.colors;
  setBackgroundBrush(c.panel);
  chart()->setBackgroundBrush(c.panel);
  chart()->setPlotAreaBackgroundBrush(c.track);
  chart()->setPlotAreaBackgroundVisible(true);
  for (QValueAxis* axis : {speed_, depth_}) {
    axis->setLabelsColor(c.secondary);
    axis->setLabelsFont(theme.font(type_size::kTick));
    axis->setTitleFont(theme.font(type_size::kLabel, true));
    axis->setTitleBrush(c.secondary);
    axis->setGridLineColor(c.border);
    axis->setLinePenColor(c.secondary);
  }
  quiet_->setPen(Qt::NoPen);
  quiet_->setBrush(c.panel);
  limit_->setPen(QPen(c.text, theme.px(2.5)));
  trail_->setPen(QPen(c.faint, theme.px(1.5), Qt::DotLine));
  const int size = theme.px(11);
  metStable_->setMarkerShape(QScatterSeries::MarkerShapeCircle);
  metStable_->setMarkerSize(size);
  metStable_->setBrush(Qt::NoBrush);
  metStable_->setPen(QPen(c.text, theme.px(1.5)));
  metUnstable_->setMarkerShape(QScatterSeries::MarkerShapeRectangle);
  metUnstable_->setMarkerSize(size);
  metUnstable_->setPen(Qt::NoPen);
  metUnstable_->setBrush(QBrush(triangleMarker(size, theme.back(Tone::Chatter))));
  viewport()->update();
}

QSize LobeChart::minimumSizeHint() const {
  return {theme_.px(480), theme_.px(300)};
}

// The working point as a cross, the advice as an arrow from it, the handle as a ring.
void LobeChart::drawForeground(QPainter* p, const QRectF&) {
  p->save();
  p->setRenderHint(QPainter::Antialiasing);
  p->setClipRect(chart()->plotArea());
  // Quiet again above the limit: as the quiet ground below it, with an edge of its own.
  p->setPen(Qt::NoPen);
  for (const Island& island : islands_) {
    const QRectF box(onChart({island.left, island.span.to}), onChart({island.right, island.span.from}));
    p->fillRect(box, theme_.colors.panel);
    p->fillRect(QRectF(box.left(), box.top(), box.width(), theme_.px(1.5)), theme_.colors.text);
    p->fillRect(QRectF(box.left(), box.bottom() - theme_.px(1.5), box.width(), theme_.px(1.5)), theme_.colors.text);
  }
  const double arm = theme_.px(11);
  if (now_) {
    const QPointF at = onChart(*now_);
    p->setPen(QPen(theme_.colors.text, theme_.px(3)));
    p->drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
    p->drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
    if (advice_) {
      const QPointF to = onChart({*advice_, now_->depth});
      const double way = to.x() < at.x() ? 1.0 : -1.0, head = theme_.px(14);
      p->setPen(QPen(theme_.colors.advice, theme_.px(4)));
      p->drawLine(at, to + QPointF(way * head * 0.8, 0));
      p->setPen(Qt::NoPen);
      p->setBrush(theme_.colors.advice);
      p->drawPolygon(QPolygonF{to, to + QPointF(way * head, -head * 0.6), to + QPointF(way * head, head * 0.6)});
      p->setFont(theme_.font(type_size::kLabel, true));
      p->setPen(theme_.colors.advice);
      p->drawText(to + QPointF(-theme_.px(40), -theme_.px(14)), join(number(advice_->value), QStringLiteral("rpm")));
    }
  }
  const QPointF ring = onChart(handle_);
  p->setBrush(Qt::NoBrush);
  p->setPen(QPen(theme_.colors.panel, theme_.px(6)));
  p->drawEllipse(ring, theme_.px(14), theme_.px(14));
  p->setPen(QPen(theme_.colors.text, theme_.px(3)));
  p->drawEllipse(ring, theme_.px(14), theme_.px(14));
  p->restore();
}

void LobeChart::moveHandle(SpeedDepth to) {
  handle_.speed = std::clamp(to.speed, frame_.lowest, std::max(frame_.lowest, frame_.highest));
  handle_.depth = std::clamp(to.depth, Metres(1e-6), std::max(frame_.maxDepth, Metres(1e-6)));
  viewport()->update();
  emit handleMoved();
}

void LobeChart::moveHandleTo(const QPoint& at) {
  const QPointF value = chart()->mapToValue(chart()->mapFromScene(mapToScene(at)), limit_);
  moveHandle({Rpm(value.x()), depthOf(value.y())});
}

void LobeChart::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  dragging_ = true;
  moveHandleTo(event->pos());
}

void LobeChart::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_) moveHandleTo(event->pos());
}

void LobeChart::mouseReleaseEvent(QMouseEvent*) {
  dragging_ = false;
}

void LobeChart::keyPressEvent(QKeyEvent* event) {
  const double factor = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  const Rpm speed = (frame_.highest - frame_.lowest) * (0.002 * factor);
  const Metres depth = frame_.maxDepth * (0.005 * factor);
  switch (event->key()) {
    case Qt::Key_Left:
      return moveHandle({handle_.speed - speed, handle_.depth});
    case Qt::Key_Right:
      return moveHandle({handle_.speed + speed, handle_.depth});
    case Qt::Key_Up:
      return moveHandle({handle_.speed, handle_.depth + depth});
    case Qt::Key_Down:
      return moveHandle({handle_.speed, handle_.depth - depth});
    default:
      QChartView::keyPressEvent(event);
  }
}

}  // namespace stillcut::ui
