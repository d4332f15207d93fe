#include "ui/plots/session_timeline.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/models/format.h"
#include "ui/models/session_models.h"
#include "ui/plots/nice_ticks.h"

namespace stillcut::ui {
namespace {

constexpr double kNames = 132;  // width of the rows' names
constexpr double kAxis = 24;
constexpr double kRow = 22;
constexpr double kDrag = 6;         // pixels below which a press is a click
constexpr double kLeastView = 0.2;  // s

bool alarming(const SummaryPoint& point) {
  return point.valid && (point.state == CutState::Onset || point.state == CutState::Chatter);
}

}  // namespace

SessionTimeline::SessionTimeline(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(false);
  setAccessibleName(tr("Recording over time"));
}

void SessionTimeline::setSummary(std::shared_ptr<const SessionSummary> summary) {
  if (summary == summary_) return;
  const bool same = summary && summary_ && summary->file == summary_->file;
  const bool all = viewFrom_ <= 0.0 && viewTo_ >= length();
  summary_ = std::move(summary);
  recorded_.clear();
  tracks_.clear();
  marks_.clear();
  if (!same) from_ = to_ = 0.0;
  if (!same || all) {
    viewFrom_ = 0.0;
    viewTo_ = length();
  }
  if (summary_) {
    const auto& curve = summary_->curve;
    for (std::size_t k = 0; k < curve.size(); ++k) {
      if (!alarming(curve[k])) continue;
      const Seconds step(curve.size() > 1 ? curve[1].time.value - curve[0].time.value : 0.1);
      if (k == 0 || !alarming(curve[k - 1])) recorded_.push_back({curve[k].time, curve[k].time});
      recorded_.back().end = curve[k].time + step;
    }
  }
  update();
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
  const double width = std::clamp((viewTo_ - viewFrom_) * factor, std::min(kLeastView, length()), length());
  const double share = (around - viewFrom_) / std::max(viewTo_ - viewFrom_, 1e-9);
  viewFrom_ = std::clamp(around - share * width, 0.0, length() - width);
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
  const double rows = 2.0 + static_cast<double>(tracks_.size());
  return {theme_.px(320), theme_.px(60 + kRow * rows + kAxis)};
}

void SessionTimeline::paintCurve(QPainter& p, const QRectF& box) const {
  double top = 0.0;
  for (const SummaryPoint& point : summary_->curve) top = std::max(top, point.vibration);
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
  for (const SummaryPoint& point : summary_->curve) {
    if (!point.gap) continue;
    p.fillRect(QRectF(xOf(point.time.value), box.top(), 2, box.height()), theme_.colors.gap);
  }
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

void SessionTimeline::paintAxis(QPainter& p, const QRectF& box) const {
  p.setFont(theme_.font(type_size::kTick));
  p.setPen(theme_.colors.secondary);
  for (const double tick : niceTicks(viewFrom_, viewTo_, std::max(2, static_cast<int>(box.width() / theme_.px(110))))) {
    const double x = xOf(tick);
    p.drawLine(QPointF(x, box.bottom()), QPointF(x, box.bottom() + theme_.px(4)));
    p.drawText(QRectF(x - theme_.px(50), box.bottom() + theme_.px(4), theme_.px(100), theme_.px(18)), Qt::AlignCenter,
               timeText(Seconds(tick)));
  }
}

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
  const double bands = (1.0 + static_cast<double>(tracks_.size())) * row;
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
  double y = curve.bottom() + theme_.px(6);
  paintBand(p, QRectF(box.left(), y, box.width(), row - theme_.px(6)), recorded_, theme_.colors.chatter);
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
  y = curve.bottom() + theme_.px(6);
  name(y, row - theme_.px(6), tr("as recorded"));
  for (const DetectorTrack& track : tracks_) {
    y += row;
    name(y, row - theme_.px(6), track.detector);
  }
  paintAxis(p, box);
  if (hasFocus()) {
    p.setPen(QPen(theme_.colors.advice, theme_.px(2)));
    p.setBrush(Qt::NoBrush);
    p.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
}

}  // namespace stillcut::ui
