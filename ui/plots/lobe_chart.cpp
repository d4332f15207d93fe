#include "ui/plots/lobe_chart.h"

#include <QAreaSeries>
#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineSeries>
#include <QMouseEvent>
#include <QScatterSeries>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/conversions.h"
#include "ui/base/format.h"
#include "ui/models/learned_view.h"
#include "ui/plots/lobe_marks.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/touch_input.h"

namespace stillcut::ui {
namespace {

constexpr double kWheelStep = 0.8;
constexpr double kClosest = 0.02;  // of the whole that can be told apart

QImage marker(int size, int corners, const QColor& color) {
  QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter p(&image);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  p.setBrush(color);
  p.drawPolygon(cornered({size / 2.0, size / 2.0}, size / 2.0, corners));
  return image;
}

// A new range with labels at round numbers, written as everywhere else.
void setRound(QCategoryAxis& axis, double from, double to, int most) {
  for (const QString& label : axis.categoriesLabels()) axis.remove(label);
  axis.setRange(from, to);
  axis.setStartValue(from);
  const std::vector<double> ticks = niceTicks(from, to, most);
  const int decimals = ticks.size() > 1 ? decimalsFor(ticks[1] - ticks[0]) : 0;
  constexpr double kEdge = 0.03;  // a label there would be cut off
  for (const double tick : ticks) {
    if (tick <= to - kEdge * (to - from)) axis.append(number(tick, decimals), tick);
  }
}

}  // namespace

LobeChart::LobeChart(QWidget* parent)
    : QChartView(parent),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      speed_(new QCategoryAxis(this)),
      depth_(new QCategoryAxis(this)),
      limit_(new QLineSeries(this)),
      floor_(new QLineSeries(this)),
      quiet_(new QAreaSeries(limit_, floor_)),
      trail_(new QLineSeries(this)),
      metStable_(new QScatterSeries(this)),
      metOnset_(new QScatterSeries(this)),
      metChatter_(new QScatterSeries(this)) {
  setRenderHint(QPainter::Antialiasing);
  setFocusPolicy(Qt::StrongFocus);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Stability diagram"));
  for (QCategoryAxis* axis : {speed_, depth_}) axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  setToolTip(
      tr("Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth? Two fingers, the "
         "wheel or plus and minus zoom, zero shows the whole."));
  TouchInput::Moves fingers;  // one drags the ring, as the mouse does
  fingers.pan = [this](QPointF by) { moveBy(by.x()); };
  fingers.zoom = [this](double factor, QPointF around, Qt::Orientation along) {
    zoom(factor, fromView(around), along);
  };
  new TouchInput(viewport(), std::move(fingers));
  chart()->legend()->hide();
  chart()->setMargins({0, 0, 0, 0});
  chart()->setBackgroundRoundness(0);
  chart()->layout()->setContentsMargins(0, 0, 0, 0);
  chart()->addAxis(speed_, Qt::AlignBottom);
  chart()->addAxis(depth_, Qt::AlignLeft);
  for (QAbstractSeries* series :
       std::initializer_list<QAbstractSeries*>{quiet_, limit_, trail_, metStable_, metOnset_, metChatter_}) {
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
  setRound(*speed_, from_.value, std::max(to_.value, from_.value + 1.0), 6);
  setRound(*depth_, 0.0, std::max(shown(deepest_), 1e-6), 5);
  speed_->setTitleText(tr("spindle speed [rpm]"));
  depth_->setTitleText(units_ == UnitSystem::Inch ? tr("depth of cut [in]") : tr("depth of cut [mm]"));
}

void LobeChart::showWhole() {
  from_ = frame_.lowest;
  to_ = frame_.highest;
  deepest_ = frame_.maxAxialDepth;
  showFrame();
  viewport()->update();
}

// Speeds keep `around` where it is and stay within the frame; depths begin at the surface.
void LobeChart::zoom(double factor, const QPointF& around, Qt::Orientation along) {
  const Rpm whole = frame_.highest - frame_.lowest;
  if (!(whole.value > 0.0) || !std::isfinite(factor) || !(factor > 0.0)) return;
  if (along == Qt::Vertical) {
    deepest_ = std::clamp(deepest_ * factor, frame_.maxAxialDepth * kClosest, frame_.maxAxialDepth);
  } else {
    const Rpm width = std::clamp((to_ - from_) * factor, whole * kClosest, whole);
    const Rpm at(chart()->mapToValue(around, limit_).x());
    from_ = std::clamp(at - (at - from_) * (width / (to_ - from_)), frame_.lowest,
                       std::max(frame_.lowest, frame_.highest - width));
    to_ = from_ + width;
  }
  showFrame();
  viewport()->update();
}

void LobeChart::moveBy(double right) {
  const Rpm width = to_ - from_;
  from_ = std::clamp(from_ - width * (right / std::max(chart()->plotArea().width(), 1.0)), frame_.lowest,
                     std::max(frame_.lowest, frame_.highest - width));
  to_ = from_ + width;
  showFrame();
  viewport()->update();
}

void LobeChart::setDiagram(const LobeDiagram* diagram, const LobeFrame& frame) {
  const bool other =
      frame.lowest != frame_.lowest || frame.highest != frame_.highest || frame.maxAxialDepth != frame_.maxAxialDepth;
  frame_ = frame;
  if (other) showWhole();
  showFrame();
  QList<QPointF> limit, floor;
  if (diagram != nullptr) {
    for (const LobeLimit& l : diagram->limits) {
      limit << QPointF(l.speed.value, std::min(shown(l.depth), shown(frame_.maxAxialDepth)));
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
  QList<QPointF> trail, stable, onset, chatter;
  for (const MetPoint& point : met) {
    const QPointF at(point.speed.value, shown(point.depth));
    trail << at;
    (point.state == CutState::Chatter ? chatter : point.state == CutState::Onset ? onset : stable) << at;
  }
  if (now) trail << QPointF(now->speed.value, shown(now->depth));
  if (trail == trail_->points()) return;  // a chart is dear to draw
  trail_->replace(trail);
  metStable_->replace(stable);
  metOnset_->replace(onset);
  metChatter_->replace(chatter);
  now_ = now;
  viewport()->update();
}

void LobeChart::setAdvice(std::optional<Rpm> target) {
  if (target == advice_) return;
  viewport()->update();
  advice_ = target;
}

void LobeChart::setLearned(std::shared_ptr<const LearnedLobes> learned) {
  learned_.set(std::move(learned));
  viewport()->update();
}

const LearnedCut* LobeChart::cutAt(const QPoint& at) const {
  return learned_.cutAt(fromView(at), [this](SpeedDepth point) { return onChart(point); });
}

// A judged cut under the mouse says what it was.
bool LobeChart::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const LearnedCut* cut = cutAt(help->pos())) {
      QToolTip::showText(help->globalPos(), evidenceText(*cut, units_), this);
      return true;
    }
  }
  return QChartView::viewportEvent(event);
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
  for (QCategoryAxis* axis : {speed_, depth_}) {
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
  const auto shaped = [size](QScatterSeries& series, int corners, const QColor& color) {
    series.setMarkerShape(QScatterSeries::MarkerShapeRectangle);
    series.setMarkerSize(size);
    series.setPen(Qt::NoPen);
    series.setBrush(QBrush(marker(size, corners, color)));
  };
  shaped(*metOnset_, 3, theme.back(Tone::Onset));
  shaped(*metChatter_, 8, theme.back(Tone::Chatter));
  learned_.applyTheme(theme);
  chart()->setMargins({0, theme.px(kLobeLegend), 0, 0});
  viewport()->update();
}

QSize LobeChart::minimumSizeHint() const {
  return {theme_.px(480), theme_.px(300)};
}

void LobeChart::drawForeground(QPainter* p, const QRectF&) {
  p->save();
  p->setRenderHint(QPainter::Antialiasing);
  p->save();
  p->setClipRect(chart()->plotArea());
  learned_.draw(*p, [this](SpeedDepth point) { return onChart(point); });
  drawIslands(*p);
  const LobeMarks marks(*p, theme_, chart()->plotArea());
  marks.ring(onChart(handle_));
  if (now_) {
    marks.cross(onChart(*now_));
    if (advice_) marks.advice(onChart(*now_), onChart({*advice_, now_->depth}).x(), *advice_);
  }
  p->restore();
  clipped_ = !marks.legend();
  p->restore();
}

// Quiet again above the limit: as the quiet ground below it, with an edge of its own.
void LobeChart::drawIslands(QPainter& p) const {
  for (const Island& island : islands_) {
    const QRectF box(onChart({island.left, island.span.to}), onChart({island.right, island.span.from}));
    p.fillRect(box, theme_.colors.panel);
    p.fillRect(QRectF(box.left(), box.top(), box.width(), theme_.px(1.5)), theme_.colors.text);
    p.fillRect(QRectF(box.left(), box.bottom() - theme_.px(1.5), box.width(), theme_.px(1.5)), theme_.colors.text);
  }
}

void LobeChart::moveHandle(SpeedDepth to) {
  handle_.speed = std::clamp(to.speed, frame_.lowest, std::max(frame_.lowest, frame_.highest));
  handle_.depth = std::clamp(to.depth, Metres(1e-6), std::max(frame_.maxAxialDepth, Metres(1e-6)));
  viewport()->update();
  emit handleMoved();
}

QPointF LobeChart::fromView(const QPointF& at) const {
  return chart()->mapFromScene(mapToScene(at.toPoint()));
}

void LobeChart::moveHandleTo(const QPoint& at) {
  const QPointF value = chart()->mapToValue(fromView(at), limit_);
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

void LobeChart::wheelEvent(QWheelEvent* event) {
  const bool depth = event->modifiers() & Qt::ControlModifier || event->position().x() < chart()->plotArea().left();
  zoom(std::pow(kWheelStep, event->angleDelta().y() / 120.0), fromView(event->position()),
       depth ? Qt::Vertical : Qt::Horizontal);
  event->accept();
}

void LobeChart::keyPressEvent(QKeyEvent* event) {
  const double factor = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  const Rpm speed = (frame_.highest - frame_.lowest) * (0.002 * factor);
  const Metres depth = frame_.maxAxialDepth * (0.005 * factor);
  switch (event->key()) {
    case Qt::Key_Left:
      return moveHandle({handle_.speed - speed, handle_.depth});
    case Qt::Key_Right:
      return moveHandle({handle_.speed + speed, handle_.depth});
    case Qt::Key_Up:
      return moveHandle({handle_.speed, handle_.depth + depth});
    case Qt::Key_Down:
      return moveHandle({handle_.speed, handle_.depth - depth});
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kWheelStep, onChart(handle_), Qt::Horizontal);
    case Qt::Key_Minus:
      return zoom(1.0 / kWheelStep, onChart(handle_), Qt::Horizontal);
    case Qt::Key_0:
      return showWhole();
    default:
      QChartView::keyPressEvent(event);
  }
}

}  // namespace stillcut::ui
