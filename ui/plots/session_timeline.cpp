#include "ui/plots/session_timeline.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/models/session_models.h"
#include "ui/plots/recording_curve.h"
#include "ui/plots/touch_input.h"

namespace stillcut::ui {
namespace {

constexpr double kDrag = 6;         // pixels below which a press is a click
constexpr double kLeastView = 0.2;  // s

}  // namespace

SessionTimeline::SessionTimeline(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(false);
  setAccessibleName(tr("Recording over time"));
  TouchInput::Moves fingers;  // one selects, as the mouse does
  fingers.pan = [this](QPointF by) { moveBy(by.x()); };
  fingers.zoom = [this](double factor, QPointF around, Qt::Orientation along) {
    if (along == Qt::Horizontal) zoom(factor, timeAt(around.x()));
  };
  new TouchInput(this, std::move(fingers));
}

void SessionTimeline::setSummary(std::shared_ptr<const SessionSummary> summary) {
  if (summary == summary_) return;
  const bool same = summary && summary_ && summary->file == summary_->file;
  const bool all = viewFrom_ <= 0.0 && viewTo_ >= axisEnd();
  summary_ = std::move(summary);
  recorded_.clear();
  tracks_.clear();
  marks_.clear();
  if (!same) from_ = to_ = 0.0;
  if (!same || all) {
    viewFrom_ = 0.0;
    viewTo_ = axisEnd();
  }
  if (summary_) recorded_ = recordedAlarms(*summary_);
  update();
}

void SessionTimeline::setBeside(std::shared_ptr<const SessionSummary> beside) {
  if (beside == beside_) return;
  beside_ = std::move(beside);
  besideAlarms_ = beside_ ? recordedAlarms(*beside_) : std::vector<AlarmSpan>{};
  viewFrom_ = 0.0;
  viewTo_ = axisEnd();
  updateGeometry();
  update();
}

bool SessionTimeline::besideShown() const {
  return beside_ && summary_ && beside_->file != summary_->file;
}

void SessionTimeline::setTracks(const std::vector<DetectorTrack>& tracks) {
  tracks_ = tracks;
  updateGeometry();
  update();
}

void SessionTimeline::setMarks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  update();
}

void SessionTimeline::setReplay(const ReplayState& state) {
  replay_ = state;
  // What plays stays in the picture.
  const double width = viewTo_ - viewFrom_;
  if (state.playing && width < 0.99 * length() &&
      (state.position.value > viewTo_ || state.position.value < viewFrom_)) {
    viewFrom_ = std::clamp(state.position.value - 0.1 * width, 0.0, length() - width);
    viewTo_ = viewFrom_ + width;
  }
  update();
}

void SessionTimeline::select(Seconds from, Seconds to) {
  from_ = std::clamp(from.value, 0.0, length());
  to_ = std::clamp(to.value, 0.0, length());
  emit selected();
  update();
}

double SessionTimeline::length() const {
  return summary_ ? std::max(summary_->length.value, 1e-3) : 1.0;
}

double SessionTimeline::axisEnd() const {
  return besideShown() ? std::max(length(), beside_->length.value) : length();
}

QRectF SessionTimeline::plot() const {
  return QRectF(rect()).adjusted(theme_.px(kNames), theme_.px(6), -theme_.px(34), -theme_.px(kAxis));
}

double SessionTimeline::xOf(double seconds) const {
  const QRectF box = plot();
  return box.left() + (seconds - viewFrom_) / std::max(viewTo_ - viewFrom_, 1e-9) * box.width();
}

double SessionTimeline::timeAt(double x) const {
  const QRectF box = plot();
  return std::clamp(viewFrom_ + (x - box.left()) / box.width() * (viewTo_ - viewFrom_), 0.0, length());
}

void SessionTimeline::zoom(double factor, double around) {
  const double width = std::clamp((viewTo_ - viewFrom_) * factor, std::min(kLeastView, axisEnd()), axisEnd());
  const double share = (around - viewFrom_) / std::max(viewTo_ - viewFrom_, 1e-9);
  viewFrom_ = std::clamp(around - share * width, 0.0, axisEnd() - width);
  viewTo_ = viewFrom_ + width;
  update();
}

void SessionTimeline::moveBy(double right) {
  const double width = viewTo_ - viewFrom_;
  viewFrom_ = std::clamp(viewFrom_ - right / std::max(plot().width(), 1.0) * width, 0.0, axisEnd() - width);
  viewTo_ = viewFrom_ + width;
  update();
}

void SessionTimeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !summary_) return;
  pressed_ = event->position().x();
}

void SessionTimeline::mouseMoveEvent(QMouseEvent* event) {
  if (pressed_ < 0.0 || std::abs(event->position().x() - pressed_) < kDrag) return;
  from_ = timeAt(pressed_);
  to_ = timeAt(event->position().x());
  update();
}

void SessionTimeline::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || pressed_ < 0.0) return;
  const bool dragged = std::abs(event->position().x() - pressed_) >= kDrag;
  pressed_ = -1.0;
  if (!dragged) {
    emit wentTo(timeAt(event->position().x()));
    return;
  }
  to_ = timeAt(event->position().x());
  emit selected();
  update();
}

void SessionTimeline::wheelEvent(QWheelEvent* event) {
  if (event->angleDelta().y() == 0) return;
  zoom(event->angleDelta().y() > 0 ? 0.8 : 1.25, timeAt(event->position().x()));
}

void SessionTimeline::keyPressEvent(QKeyEvent* event) {
  const double step = (viewTo_ - viewFrom_) / 50.0;
  switch (event->key()) {
    case Qt::Key_Left:
      emit wentTo(std::max(replay_.position.value - step, 0.0));
      break;
    case Qt::Key_Right:
      emit wentTo(std::min(replay_.position.value + step, length()));
      break;
    case Qt::Key_Home:
      emit wentTo(0.0);
      break;
    case Qt::Key_End:
      emit wentTo(length());
      break;
    case Qt::Key_Plus:
      zoom(0.5, replay_.position.value);
      break;
    case Qt::Key_Minus:
      zoom(2.0, replay_.position.value);
      break;
    case Qt::Key_BracketLeft:
      select(replay_.position, Seconds(hasSelection() ? selectedTo().value : length()));
      break;
    case Qt::Key_BracketRight:
      select(Seconds(hasSelection() ? selectedFrom().value : 0.0), replay_.position);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

void SessionTimeline::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize SessionTimeline::sizeHint() const {
  return {theme_.px(500), theme_.px(150 + kRow * 4 + kAxis)};
}

QSize SessionTimeline::minimumSizeHint() const {
  const double rows =
      2.0 + static_cast<double>(tracks_.size()) + (besideShown() ? 1.0 : 0.0) + (speedRange().second > 0.0 ? 1.0 : 0.0);
  return {theme_.px(320), theme_.px(60 + kRow * rows + kAxis)};
}

}  // namespace stillcut::ui
