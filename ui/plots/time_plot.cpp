#include "ui/plots/time_plot.h"

#include <QDateTime>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/models/plot_state_text.h"
#include "ui/plots/axis_painter.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/touch_input.h"

namespace stillcut::ui {
namespace {

constexpr double kWheelStep = 0.8;
constexpr double kDragFrom = 6.0;  // px: a touch that moves less is a click

QString clockText(qint64 wallMs, int decimals) {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(wallMs);
  QString whole = time.toString(QStringLiteral("HH:mm:ss"));
  if (decimals < 1) return whole;
  return whole + u'.' + QStringLiteral("%1").arg(time.time().msec(), 3, 10, QChar(u'0')).left(decimals);
}

}  // namespace

TimePlot::TimePlot(AnalyseView& view, const QString& title, QWidget* parent)
    : QWidget(parent), view_(view), title_(title), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);  // what lies behind would be painted with every picture
  setAccessibleName(title);
  connect(&view, &AnalyseView::changed, this, qOverload<>(&QWidget::update));
  TouchInput::Moves fingers;
  fingers.pan = [this](QPointF by) { moveBy(by); };
  fingers.zoom = [this](double factor, QPointF around, Qt::Orientation along) {
    along == Qt::Horizontal ? zoomRight(factor, around.x()) : zoomUp(factor, around.y());
  };
  fingers.flings = true;
  new TouchInput(this, std::move(fingers));
}

void TimePlot::setElapsed(bool elapsed) {
  elapsed_ = elapsed;
  update();
}

void TimePlot::setTimesShown(bool shown) {
  timesShown_ = shown;
  update();
}

void TimePlot::setPlotState(PlotState plotState) {
  if (plotState == plotState_) return;
  plotState_ = plotState;
  update();
}

void TimePlot::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QRect TimePlot::plotRect() const {
  return rect().adjusted(theme_.px(74), theme_.px(26), -theme_.px(46), lowerAxis() ? -theme_.px(26) : -theme_.px(6));
}

Instant TimePlot::timeAt(double x) const {
  const QRect plot = plotRect();
  return view_.from() + toDuration(view_.options().span * ((x - plot.left()) / std::max(plot.width(), 1)));
}

double TimePlot::xOf(Instant t) const {
  const QRect plot = plotRect();
  return plot.left() + secondsBetween(view_.from(), t) / view_.options().span * plot.width();
}

void TimePlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), theme_.colors.panel);
  p.setRenderHint(QPainter::Antialiasing);
  const QRect plot = plotRect();
  if (plot.height() < 10 || plot.width() < 40) return;
  p.setFont(theme_.font(type_size::kLabel, true));
  p.setPen(theme_.colors.secondary);
  const QString title = plotStateTitle(title_, plotState_);
  p.drawText(QRect(theme_.px(12), 0, width() - theme_.px(24), theme_.px(26)), Qt::AlignVCenter | Qt::AlignLeft, title);
  const int after = theme_.px(12 + 14) + p.fontMetrics().horizontalAdvance(title);
  p.setFont(theme_.font(type_size::kTick));
  if (p.fontMetrics().horizontalAdvance(legend_) < width() - after - theme_.px(12)) {
    p.drawText(QRect(after, 0, width() - after, theme_.px(26)), Qt::AlignVCenter | Qt::AlignLeft, legend_);
  }
  p.fillRect(plot, theme_.colors.track);
  const bool stale = plotState_ == PlotState::Stale;
  if (stale) p.setOpacity(0.4);
  drawPlot(p, plot);
  p.setOpacity(1.0);
  drawTimes(p, plot);
  drawCursors(p, plot);
  if (boxing_ && pressed_) {
    QColor wash = theme_.colors.advice;
    wash.setAlpha(60);
    p.fillRect(QRectF(QPointF(pressed_->x(), plot.top()), QPointF(last_.x(), plot.bottom() + 1)).normalized(), wash);
  }
  if (stale) {
    p.setFont(theme_.font(type_size::kValue, true));
    p.setPen(theme_.colors.text);
    p.drawText(plot, Qt::AlignCenter, tr("STALE: nothing new arrives"));
  }
  if (hasFocus()) {
    p.setPen(QPen(theme_.colors.text, theme_.px(1.5), Qt::DotLine));
    p.setBrush(Qt::NoBrush);
    p.drawRect(plot.adjusted(0, 0, -1, -1));
  }
}

void TimePlot::drawTimes(QPainter& p, const QRect& plot) const {
  if (!timesShown_ || (!wallMs_ && !elapsed_)) return;
  const double from = elapsed_ ? sinceEpoch(view_.from()).value : static_cast<double>(wallMs_(view_.from())) * 1e-3;
  const std::vector<double> ticks =
      niceTicks(0.0, view_.options().span.value + 1.0, std::max(plot.width() / theme_.px(120), 1));
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  p.setFont(theme_.font(type_size::kTick));
  p.setPen(theme_.colors.secondary);
  const QFontMetrics metrics = p.fontMetrics();
  for (double wall = std::ceil(from / step) * step;; wall += step) {
    const double x = plot.left() + (wall - from) / view_.options().span.value * plot.width();
    if (x > plot.right() + 1) break;
    p.drawLine(QPointF(x, plot.bottom() + 1), QPointF(x, plot.bottom() + theme_.px(5)));
    const int decimals = decimalsFor(step);
    const QString text =
        elapsed_ ? join(number(wall, decimals), QStringLiteral("s")) : clockText(std::llround(wall * 1e3), decimals);
    const int w = metrics.horizontalAdvance(text);
    p.drawText(QPointF(std::clamp<double>(x - w / 2.0, 2.0, width() - w - 2.0),
                       plot.bottom() + theme_.px(8) + metrics.ascent()),
               text);
  }
}

// Each cursor has its letter, so that colour does not speak alone.
void TimePlot::drawCursors(QPainter& p, const QRect& plot) const {
  p.setFont(theme_.font(type_size::kTick, true));
  for (const AnalyseView::Cursor c : {AnalyseView::A, AnalyseView::B}) {
    const auto t = view_.cursor(c);
    if (!t) continue;
    const double x = xOf(*t);
    if (x < plot.left() || x > plot.right() + 1) continue;
    const QColor color = c == AnalyseView::A ? theme_.colors.advice : theme_.colors.text;
    p.setPen(QPen(color, theme_.px(1.5), c == AnalyseView::A ? Qt::SolidLine : Qt::DashLine));
    p.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    const QRectF flag(x - theme_.px(9), plot.top() - theme_.px(16), theme_.px(18), theme_.px(16));
    p.fillRect(flag, color);
    p.setPen(theme_.colors.panel);
    p.drawText(flag, Qt::AlignCenter, c == AnalyseView::A ? QStringLiteral("A") : QStringLiteral("B"));
  }
}

void TimePlot::drawReading(QPainter& p, const QRectF& row, Instant t, const QString& text) const {
  p.setFont(theme_.font(type_size::kTick, true));
  const double wide = p.fontMetrics().horizontalAdvance(text) + theme_.px(6), x = xOf(t);
  const double apart = theme_.px(10);  // beside the flag, where the row is at its height
  const double left = x + apart + wide < row.right() ? x + apart : x - apart - wide;
  const QRectF patch(left, row.top(), wide, std::min<double>(row.height(), theme_.px(17)));
  p.fillRect(patch, theme_.colors.panel);
  p.setPen(theme_.colors.text);
  p.drawText(patch, Qt::AlignCenter, text);
}

void TimePlot::panRight(double share) {
  view_.pan(view_.options().span * -share);
}

void TimePlot::zoomRight(double factor, double x) {
  view_.zoomTime(factor, timeAt(x));
}

void TimePlot::showBetween(double left, double right) {
  view_.showTimes(timeAt(left), timeAt(right));
}

void TimePlot::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  const double factor = std::pow(kWheelStep, notches);
  const bool second = event->modifiers() & Qt::ControlModifier || event->position().x() < plotRect().left();
  if (second) {
    zoomUp(factor, event->position().y());
  } else {
    zoomRight(factor, event->position().x());
  }
  event->accept();
}

void TimePlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = last_ = event->position();
  dragged_ = false;
  boxing_ = event->modifiers() & Qt::ControlModifier;
}

void TimePlot::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  const QPointF now = event->position(), by = now - last_;
  if (!dragged_ && std::hypot(now.x() - pressed_->x(), now.y() - pressed_->y()) < kDragFrom) return;
  dragged_ = true;
  last_ = now;
  if (boxing_) {
    update();
    return;
  }
  moveBy(by);
}

void TimePlot::moveBy(const QPointF& by) {
  const QRect plot = plotRect();
  if (std::abs(by.x()) > 0) panRight(by.x() / std::max(plot.width(), 1));
  if (std::abs(by.y()) > 0) panUp(by.y() / std::max(plot.height(), 1));
}

void TimePlot::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_) return;
  const QPointF from = *pressed_;
  pressed_.reset();
  const bool box = boxing_ && dragged_;
  boxing_ = false;
  if (box) {
    const double one = from.x(), other = event->position().x();
    showBetween(std::min(one, other), std::max(one, other));
  } else if (!dragged_ && plotRect().contains(event->position().toPoint())) {
    clicked(event->position(), event->modifiers());
  }
  update();
}

void TimePlot::mouseDoubleClickEvent(QMouseEvent*) {
  view_.follow();
}

void TimePlot::clicked(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  view_.setCursor(modifiers & Qt::ShiftModifier ? AnalyseView::B : AnalyseView::A, timeAt(at.x()));
}

void TimePlot::keyPressEvent(QKeyEvent* event) {
  const Instant middle = view_.to() - toDuration(view_.options().span * 0.5);
  switch (event->key()) {
    case Qt::Key_Left:
      return panRight(0.1);
    case Qt::Key_Right:
      return panRight(-0.1);
    case Qt::Key_Up:
      return panUp(0.1);
    case Qt::Key_Down:
      return panUp(-0.1);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoomRight(kWheelStep, plotRect().center().x());
    case Qt::Key_Minus:
      return zoomRight(1.0 / kWheelStep, plotRect().center().x());
    case Qt::Key_PageUp:
      return zoomUp(1.0 / kWheelStep, plotRect().bottom());
    case Qt::Key_PageDown:
      return zoomUp(kWheelStep, plotRect().bottom());
    case Qt::Key_Home:
      return view_.goTo(view_.first());
    case Qt::Key_End:
      return view_.follow();
    case Qt::Key_A:
      return view_.setCursor(AnalyseView::A, middle);
    case Qt::Key_B:
      return view_.setCursor(AnalyseView::B, middle);
    case Qt::Key_Delete:
      view_.setCursor(AnalyseView::A, {});
      view_.setCursor(AnalyseView::B, {});
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace stillcut::ui
