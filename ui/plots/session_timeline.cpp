#include "ui/plots/session_timeline.h"

#include <QFileInfo>
#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/models/format.h"
#include "ui/models/session_models.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/recording_curve.h"

namespace stillcut::ui {
namespace {

constexpr double kNames = 132;  // width of the rows' names
constexpr double kAxis = 24;
constexpr double kRow = 22;
constexpr double kDrag = 6;         // pixels below which a press is a click
constexpr double kLeastView = 0.2;  // s

}  // namespace

SessionTimeline::SessionTimeline(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(false);
  setAccessibleName(tr("Recording over time"));
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
  const double rows = 2.0 + static_cast<double>(tracks_.size()) + (besideShown() ? 1.0 : 0.0);
  return {theme_.px(320), theme_.px(60 + kRow * rows + kAxis)};
}

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
  const double bands = (1.0 + (besideShown() ? 1.0 : 0.0) + static_cast<double>(tracks_.size())) * row;
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
    paintLegend(p, {double(theme_.px(4)), box.bottom(), double(theme_.px(kNames - 10)), double(theme_.px(kAxis))});
  }
  if (hasFocus()) {
    p.setPen(QPen(theme_.colors.advice, theme_.px(2)));
    p.setBrush(Qt::NoBrush);
    p.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
}

}  // namespace stillcut::ui
