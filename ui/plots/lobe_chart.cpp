#include "ui/plots/lobe_chart.h"

#include <QAreaSeries>
#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QKeyEvent>
#include <QLineSeries>
#include <QMouseEvent>
#include <QScatterSeries>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "ui/models/format.h"
#include "ui/plots/nice_ticks.h"

namespace stillcut::ui {
namespace {

constexpr double kInch = 0.0254;
// Of what stands around the working point, before scaling: each leaves the one inside it in sight.
constexpr double kArmFrom = 8.0, kArmTo = 15.0, kRing = 20.0;
constexpr double kLegend = 26.0;  // height of the row above the plot

// Points of a regular shape of this many corners, one of them or an edge up.
QPolygonF shape(const QPointF& centre, double radius, int corners) {
  QPolygonF out;
  const double turn = corners == 3 ? 0.0 : kTwoPi / (2.0 * corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = kTwoPi * k / corners + turn;
    out << centre + QPointF(radius * std::sin(angle), -radius * std::cos(angle));
  }
  return out;
}

QImage marker(int size, int corners, const QColor& color) {
  QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter p(&image);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  p.setBrush(color);
  p.drawPolygon(shape({size / 2.0, size / 2.0}, size / 2.0, corners));
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
  setToolTip(tr("Drag the ring, or use the arrow keys: what if the cut ran at this speed and depth?"));
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
  chart()->setMargins({0, theme.px(kLegend), 0, 0});
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
  drawIslands(*p);
  drawRing(*p, onChart(handle_));
  if (now_) {
    drawNow(*p, onChart(*now_));
    if (advice_) drawAdvice(*p, onChart(*now_));
  }
  p->restore();
  drawLegend(*p);
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

// Four arms around the place: what was met there stays in sight between them, and all of it inside the ring.
void LobeChart::drawNow(QPainter& p, const QPointF& at) const {
  p.setPen(QPen(theme_.colors.text, theme_.px(3), Qt::SolidLine, Qt::FlatCap));
  const double from = theme_.px(kArmFrom), to = theme_.px(kArmTo);
  for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
    p.drawLine(at + way * from, at + way * to);
}

void LobeChart::drawRing(QPainter& p, const QPointF& at) const {
  const double radius = theme_.px(kRing);
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(theme_.colors.panel, theme_.px(6)));
  p.drawEllipse(at, radius, radius);
  p.setPen(QPen(theme_.colors.text, theme_.px(3)));
  p.drawEllipse(at, radius, radius);
}

// Above what it starts from and with a stem down to where it leads; however short the move, the arrow is not.
void LobeChart::drawAdvice(QPainter& p, const QPointF& at) const {
  const double target = onChart({*advice_, now_->depth}).x();
  if (std::abs(target - at.x()) < theme_.px(3)) return;  // it is there
  const QRectF plot = chart()->plotArea();
  const double lift = theme_.px(kRing + 14), head = theme_.px(14);
  const double y = at.y() - lift > plot.top() + theme_.px(24) ? at.y() - lift : at.y() + lift;
  const double back = target < at.x() ? 1.0 : -1.0;
  const double length = std::max(std::abs(target - at.x()), 3.0 * head);
  const QPointF tip(target, y);
  p.setPen(QPen(theme_.colors.advice, theme_.px(1.5), Qt::DashLine));
  p.drawLine(tip, QPointF(target, at.y()));
  p.setPen(QPen(theme_.colors.advice, theme_.px(4), Qt::SolidLine, Qt::FlatCap));
  p.drawLine(tip + QPointF(back * length, 0), tip + QPointF(back * head * 0.8, 0));
  p.setPen(Qt::NoPen);
  p.setBrush(theme_.colors.advice);
  p.drawPolygon(QPolygonF{tip, tip + QPointF(back * head, -head * 0.6), tip + QPointF(back * head, head * 0.6)});
  p.setFont(theme_.font(type_size::kLabel, true));
  p.setPen(theme_.colors.advice);
  const QString text = join(number(advice_->value), QStringLiteral("rpm"));
  const double wide = p.fontMetrics().horizontalAdvance(text);
  const double left = std::clamp(target - wide / 2.0, plot.left() + 2.0, plot.right() - wide - 2.0);
  p.drawText(QPointF(left, y + (y < at.y() ? -theme_.px(12) : theme_.px(12) + p.fontMetrics().ascent())), text);
}

// Every sign with its word, in one row above the plot.
void LobeChart::drawLegend(QPainter& p) {
  const ThemeColors& c = theme_.colors;
  struct Entry {
    QString text;
    std::function<void(const QPointF&)> draw;
  };
  const double r = theme_.px(6);
  const auto solid = [&](int corners, const QColor& color) {
    return [&p, r, corners, color](const QPointF& at) {
      p.setPen(Qt::NoPen);
      p.setBrush(color);
      p.drawPolygon(shape(at, r, corners));
    };
  };
  const auto circle = [&](double radius, double pen) {
    return [this, &p, radius, pen](const QPointF& at) {
      p.setPen(QPen(theme_.colors.text, theme_.px(pen)));
      p.setBrush(Qt::NoBrush);
      p.drawEllipse(at, radius, radius);
    };
  };
  const std::array<Entry, 6> entries{
      {{tr("now"),
        [&](const QPointF& at) {
          p.setPen(QPen(c.text, theme_.px(3), Qt::SolidLine, Qt::FlatCap));
          p.drawLine(at - QPointF(r, 0), at + QPointF(r, 0));
          p.drawLine(at - QPointF(0, r), at + QPointF(0, r));
        }},
       {tr("advised"),
        [&](const QPointF& at) {
          p.setPen(QPen(c.advice, theme_.px(3), Qt::SolidLine, Qt::FlatCap));
          p.drawLine(at - QPointF(r, 0), at);
          p.setPen(Qt::NoPen);
          p.setBrush(c.advice);
          p.drawPolygon(QPolygonF{at + QPointF(r, 0), at + QPointF(-1, -r), at + QPointF(-1, r)});
        }},
       {tr("what if"), circle(r, 2.5)},
       {tr("was stable"), circle(theme_.px(4.5), 1.5)},
       {tr("onset"), solid(3, theme_.back(Tone::Onset))},
       {tr("chatter"), solid(8, theme_.back(Tone::Chatter))}}};
  const QRectF plot = chart()->plotArea();
  const double sign = 2.0 * r + theme_.px(5), apart = theme_.px(14);
  double needed = 0.0;
  QFont font = theme_.font(type_size::kTick);
  for (int halves = static_cast<int>(2.0 * type_size::kTick); halves >= 18; --halves) {
    font = theme_.font(0.5 * halves);
    needed = -apart;
    for (const Entry& entry : entries) needed += sign + QFontMetricsF(font).horizontalAdvance(entry.text) + apart;
    if (needed <= plot.width()) break;
  }
  clipped_ = needed > plot.width();
  double x = plot.left();
  const double y = plot.top() - theme_.px(kLegend) / 2.0;
  p.setFont(font);
  const QFontMetricsF metrics(font);
  for (const Entry& entry : entries) {
    entry.draw({x + r, y});
    p.setPen(c.secondary);
    p.drawText(QPointF(x + sign, y + metrics.capHeight() / 2.0), entry.text);
    x += sign + metrics.horizontalAdvance(entry.text) + apart;
  }
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
