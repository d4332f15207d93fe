#include "ui/plots/touch_input.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTouchEvent>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace stillcut::ui {
namespace {

constexpr double kSlop = 10.0;         // [px] a finger in a glove does not lie still
constexpr double kLeastSpread = 24.0;  // [px] between two fingers, along one axis
constexpr qint64 kLately_ms = 100;     // what a fling is judged by
constexpr qint64 kShortest_ms = 8;
constexpr double kFastest = 4000.0, kSlowest = 20.0, kLeastFling = 60.0;  // [px/s]
constexpr double kRest_s = 0.325;                                         // a fling slows down by e in this time
constexpr int kTick_ms = 16;

double length(const QPointF& p) {
  return std::hypot(p.x(), p.y());
}

// Clicks give the focus as the mouse's do.
void focusOn(QWidget* widget) {
  for (; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget()) {
    if (!widget->isEnabled() || (widget->focusPolicy() & Qt::ClickFocus) == 0) continue;
    widget->setFocus(Qt::MouseFocusReason);
    return;
  }
}

}  // namespace

TouchInput::TouchInput(QWidget* surface, Moves moves)
    : QObject(surface), surface_(surface), moves_(std::move(moves)), clock_([this] { return time_.elapsed(); }) {
  time_.start();
  surface_->setAttribute(Qt::WA_AcceptTouchEvents);
  surface_->installEventFilter(this);
  timer_.setInterval(kTick_ms);
  connect(&timer_, &QTimer::timeout, this, &TouchInput::runOn);
}

void TouchInput::scroll(QAbstractScrollArea& area) {
  if (auto* view = qobject_cast<QAbstractItemView*>(&area)) {
    view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  }
  const auto moves = [](const QScrollBar* bar) { return bar->maximum() > bar->minimum(); };
  Moves how;
  how.pans = [&area, moves](QPointF by) {
    return moves(std::abs(by.y()) >= std::abs(by.x()) ? area.verticalScrollBar() : area.horizontalScrollBar());
  };
  // Bars count whole pixels; what is left over of one move goes into the next.
  how.pan = [&area, rest = std::make_shared<QPointF>()](QPointF by) {
    const QPointF whole = (*rest + by).toPoint();
    *rest += by - whole;
    area.horizontalScrollBar()->setValue(area.horizontalScrollBar()->value() - static_cast<int>(whole.x()));
    area.verticalScrollBar()->setValue(area.verticalScrollBar()->value() - static_cast<int>(whole.y()));
  };
  new TouchInput(area.viewport(), std::move(how));
}

bool TouchInput::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
      touched(*static_cast<QTouchEvent*>(event));
      event->accept();
      return true;
    case QEvent::TouchCancel:
      if (does_ == Does::Press) mouse(QEvent::MouseButtonRelease, last_);
      does_ = Does::Nothing;
      pair_.reset();
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::Wheel:
    case QEvent::Hide:
      if (!sending_) timer_.stop();
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void TouchInput::touched(const QTouchEvent& event) {
  std::vector<QPointF> down;
  for (const QEventPoint& point : event.points()) {
    if (point.state() != QEventPoint::Released) down.push_back(point.position());
  }
  if (event.type() == QEvent::TouchBegin) {
    timer_.stop();
    does_ = Does::Nothing;
    begin_ = last_ = event.points().front().position();
    seen_ = {{clock_(), begin_}};
    pair_.reset();
    pressed_ = surface_->childAt(begin_.toPoint());
    if (pressed_ == nullptr) pressed_ = surface_;
  }
  if (down.size() >= 2) {
    if (does_ == Does::Press) mouse(QEvent::MouseButtonRelease, last_);
    does_ = Does::Pinch;
    pinch({down[0], down[1]});
  } else if (down.size() == 1) {
    pair_.reset();
    if (does_ != Does::Pinch) moveOne(down.front());
  } else {
    if (does_ != Does::Pinch) liftOne(event.points().front().position());
    does_ = Does::Nothing;
    pair_.reset();
  }
}

void TouchInput::moveOne(const QPointF& to) {
  if (does_ == Does::Nothing) {
    if (length(to - begin_) < kSlop) return;
    does_ = moves_.pans && moves_.pans(to - begin_) ? Does::Pan : Does::Press;
    if (does_ == Does::Press) press(QEvent::MouseButtonPress);
  }
  if (does_ == Does::Pan) {
    moves_.pan(to - last_);
  } else {
    mouse(QEvent::MouseMove, to);
  }
  last_ = to;
  seen_.push_back({clock_(), to});
}

void TouchInput::liftOne(const QPointF& at) {
  if (does_ == Does::Nothing) return tap();
  if (does_ == Does::Press) mouse(QEvent::MouseButtonRelease, at);
  if (does_ == Does::Pan || moves_.flings) fling();
}

void TouchInput::tap() {
  const qint64 now = clock_();
  const bool twice =
      tapped_ && now - tapped_->ms <= QApplication::doubleClickInterval() && length(begin_ - tapped_->at) < 2.0 * kSlop;
  tapped_ = twice ? std::nullopt : std::optional(Seen{now, begin_});
  press(twice ? QEvent::MouseButtonDblClick : QEvent::MouseButtonPress);
  mouse(QEvent::MouseButtonRelease, begin_);
}

void TouchInput::press(QEvent::Type how) {
  focusOn(pressed_);
  mouse(how, begin_);
}

void TouchInput::mouse(QEvent::Type type, const QPointF& at) {
  if (pressed_ == nullptr) return;  // it has gone meanwhile
  const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
  const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
  QMouseEvent event(type, pressed_->mapFrom(surface_, at), surface_->mapToGlobal(at), button, held, Qt::NoModifier);
  sending_ = true;
  QCoreApplication::sendEvent(pressed_, &event);
  sending_ = false;
}

// The middle of both goes where the fingers take it, and stays there while they spread.
void TouchInput::pinch(const Pair& now) {
  const auto before = std::exchange(pair_, now);
  if (!before) return;
  const QPointF middle = (now.a + now.b) / 2.0, by = middle - (before->a + before->b) / 2.0;
  if (moves_.pan && !by.isNull()) moves_.pan(by);
  if (!moves_.zoom) return;
  const QPointF apart = now.b - now.a, were = before->b - before->a;
  const bool across = std::abs(apart.x()) >= std::abs(apart.y());
  const double spread = across ? std::abs(apart.x()) : std::abs(apart.y());
  const double spreadBefore = across ? std::abs(were.x()) : std::abs(were.y());
  moves_.zoom(std::max(spreadBefore, kLeastSpread) / std::max(spread, kLeastSpread), middle,
              across ? Qt::Horizontal : Qt::Vertical);
}

// Only a finger that was still moving when it left has flung anything.
void TouchInput::fling() {
  const qint64 now = clock_();
  const auto from = std::find_if(seen_.begin(), seen_.end(), [now](const Seen& s) { return now - s.ms <= kLately_ms; });
  if (!moves_.pan || from == seen_.end()) return;
  velocity_ = (last_ - from->at) * (1e3 / static_cast<double>(std::max(now - from->ms, kShortest_ms)));
  const double speed = length(velocity_);
  if (speed < kLeastFling) return;
  velocity_ *= std::min(1.0, kFastest / speed);
  ran_ms_ = now;
  timer_.start();
}

void TouchInput::runOn() {
  const qint64 now = clock_();
  const double left = std::exp(-static_cast<double>(now - ran_ms_) * 1e-3 / kRest_s);
  ran_ms_ = now;
  moves_.pan(velocity_ * (kRest_s * (1.0 - left)));
  velocity_ *= left;
  if (length(velocity_) < kSlowest) timer_.stop();
}

}  // namespace stillcut::ui
