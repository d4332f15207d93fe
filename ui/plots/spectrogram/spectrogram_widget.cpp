#include "ui/plots/spectrogram/spectrogram_widget.h"

#include <QKeyEvent>
#include <QLinearGradient>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/models/plot_state_text.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/spectrogram/level_key.h"
#include "ui/plots/touch_input.h"

namespace stillcut::ui {
namespace {

constexpr Seconds kSpan{10.0};
constexpr Hertz kFirstTop{5000.0};  // tools and spindles ring between some 100 Hz and 4 kHz
constexpr Hertz kLowestTop{625.0};

}  // namespace

SpectrogramWidget::SpectrogramWidget(QWidget* parent)
    : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)), image_(kSpan), wantedTop_(kFirstTop) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Spectrogram of the last ten seconds"));
  setToolTip(tr("X: axis in Hz, orders or rpm. Page Up, Page Down: reach of the axis."));
  TouchInput::Moves fingers;
  fingers.zoom = [this](double factor, QPointF, Qt::Orientation) { reach(visibleTop() * factor); };
  new TouchInput(this, std::move(fingers));
}

void SpectrogramWidget::setSignal(const QString& signal, const QString& unit, int teeth) {
  signal_ = signal;
  unit_ = unit;
  teeth_ = teeth;
  update();
}

void SpectrogramWidget::setSpectrumTop(Hertz top) {
  if (std::abs(top.value - top_.value) < 1e-9) return;
  top_ = top;
  updateImage();
}

Hertz SpectrogramWidget::visibleTop() const {
  return top_.value > 0 ? std::min(wantedTop_, top_) : wantedTop_;
}

void SpectrogramWidget::append(const SpectrumColumn& column, Tone alarm) {
  newest_ = column.time;
  image_.append(column, alarm);
  spindle_ = column.spindle;
  update();
}

void SpectrogramWidget::setChatter(Hertz frequency, const QString& label, Tone tone) {
  if (std::abs(frequency.value - chatter_.value) < 1e-9 && label == chatterLabel_ && tone == chatterTone_) return;
  chatter_ = frequency;
  chatterLabel_ = label;
  chatterTone_ = tone;
  setAccessibleDescription(label.isEmpty() ? tr("no chatter") : tr("chatter at %1").arg(label));
  update();
}

void SpectrogramWidget::setPlotState(PlotState plotState) {
  if (plotState == plotState_) return;
  plotState_ = plotState;
  update();
}

void SpectrogramWidget::clear() {
  image_.clear();
  update();
}

void SpectrogramWidget::setAxis(Axis axis) {
  axis_ = axis;
  update();
}

void SpectrogramWidget::applyTheme(const Theme& theme) {
  theme_ = theme;
  image_.setGapColor(theme_.colors.gap.rgb());
  updateImage();
}

QSize SpectrogramWidget::minimumSizeHint() const {
  return {theme_.px(360), theme_.px(104)};
}

QSize SpectrogramWidget::sizeHint() const {
  return {theme_.px(640), theme_.px(240)};
}

QRect SpectrogramWidget::plotRect() const {
  return rect().adjusted(theme_.px(72), theme_.px(36), -theme_.px(96), -theme_.px(27));
}

void SpectrogramWidget::updateImage() {
  image_.setAxis(static_cast<int>(plotRect().height() * devicePixelRatioF()), visibleTop(), top_);
  update();
}

void SpectrogramWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  updateImage();
}

void SpectrogramWidget::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_X:
      setAxis(axis_ == Axis::Hertz ? Axis::Order : axis_ == Axis::Order ? Axis::Rpm : Axis::Hertz);
      return;
    case Qt::Key_PageUp:
      return reach(visibleTop() * 2.0);
    case Qt::Key_PageDown:
      return reach(visibleTop() * 0.5);
    default:
      QWidget::keyPressEvent(event);
  }
}

void SpectrogramWidget::reach(Hertz top) {
  wantedTop_ = std::clamp(top, kLowestTop, std::max(top_.value > 0 ? top_ : kFirstTop, kLowestTop));
  updateImage();
}

double SpectrogramWidget::yOf(Hertz f) const {
  const QRect plot = plotRect();
  return plot.bottom() + 1 - f / visibleTop() * plot.height();
}

// Order: multiples of the spindle's frequency. Rpm: the speed at which one tooth passes per vibration.
double SpectrogramWidget::unitsPerHertz() const {
  switch (axis_) {
    case Axis::Hertz:
      return 1.0;
    case Axis::Order:
      return spindle_.value > 0 ? 1.0 / spindle_.value : 0.0;
    case Axis::Rpm:
      return teeth_ > 0 ? 60.0 / teeth_ : 0.0;
  }
  return 1.0;
}

void SpectrogramWidget::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QRect plot = plotRect();
  if (plot.height() < 20 || plot.width() < 40) return;
  drawHeader(p, plot);
  drawColumns(p, plot);
  drawAxes(p, plot);
  drawTeeth(p, plot);
  drawChatter(p, plot);
}

void SpectrogramWidget::drawHeader(QPainter& p, const QRect& plot) const {
  const QRect line(plot.left(), 0, plot.width(), plot.top());
  p.setFont(theme_.font(type_size::kLabel, true));
  p.setPen(theme_.colors.secondary);
  const QString name = tr("SPECTROGRAM");
  const QString title = plotStateTitle(name, plotState_);
  p.drawText(QRect(theme_.px(16), 0, plot.right(), line.height()), Qt::AlignVCenter | Qt::AlignLeft, title);
  const int titleEnd = theme_.px(16) + p.fontMetrics().horizontalAdvance(title) + theme_.px(14);
  p.setFont(theme_.font(type_size::kLabel));
  // The palette with its two ends.
  const QString low = number(image_.range().low());
  const QString high = join(number(image_.range().high()), unit_.isEmpty() ? tr("dB") : tr("dB re 1 %1").arg(unit_));
  const QRect key(0, 0, width() - theme_.px(16), line.height());
  const int x = drawLevelKey(p, key, LevelKeyKind::Colors, low, high, theme_), gap = theme_.px(8);
  const QFontMetrics metrics = p.fontMetrics();

  const QString signal = tr("%1, last 10 s").arg(signal_);
  const QRect room(titleEnd, 0, x - gap - titleEnd, line.height());
  p.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, metrics.elidedText(signal, Qt::ElideRight, room.width()));
}

void SpectrogramWidget::drawColumns(QPainter& p, const QRect& plot) const {
  const bool stale = plotState_ == PlotState::Stale;
  p.fillRect(plot, theme_.colors.track);
  if (!image_.image().isNull()) {
    p.save();
    p.setClipRect(plot);
    if (stale) p.setOpacity(0.35);
    p.setRenderHint(QPainter::SmoothPixmapTransform);
    p.drawImage(plot, image_.image());
    p.restore();
    drawGaps(p, plot);
  }
  if (!stale && !image_.cells().empty()) return;
  p.setFont(theme_.font(type_size::kValue, true));
  p.setPen(theme_.colors.text);
  p.drawText(plot, Qt::AlignCenter, stale ? tr("STALE: nothing new arrives") : tr("Waiting for the first samples"));
}

// Hatches what is missing, and draws the time in chatter as a strip along the upper edge.
void SpectrogramWidget::drawGaps(QPainter& p, const QRect& plot) const {
  const auto& cells = image_.cells();
  const double width = static_cast<double>(plot.width()) / image_.capacity();
  double x = plot.right() + 1 - width * static_cast<double>(cells.size());
  p.setPen(Qt::NoPen);
  for (const SpectrogramImage::Cell& cell : cells) {
    const QRectF column(x, plot.top(), width + 0.5, plot.height());
    if (!cell.present && cell.afterGap) {
      p.fillRect(column, theme_.colors.gap);
      p.fillRect(column, QBrush(theme_.colors.hatch, Qt::BDiagPattern));
    } else if (cell.present && cell.afterGap) {
      p.fillRect(QRectF(x, plot.top(), std::max(1.5, width * 0.5), plot.height()),
                 QBrush(theme_.colors.hatch, Qt::Dense3Pattern));
    }
    if (cell.alarm != Tone::Normal) {
      p.fillRect(QRectF(x, plot.top() - theme_.px(6), width + 0.5, theme_.px(4)), theme_.back(cell.alarm));
    }
    x += width;
  }
}

void SpectrogramWidget::drawAxes(QPainter& p, const QRect& plot) const {
  p.setFont(theme_.font(type_size::kTick));
  const QFontMetrics metrics = p.fontMetrics();
  const int half = metrics.capHeight() / 2;
  const double perHertz = unitsPerHertz();
  const QString unit = axis_ == Axis::Hertz ? tr("Hz") : axis_ == Axis::Order ? tr("order") : rpmUnit();
  p.setPen(theme_.colors.secondary);
  const int most = std::max(plot.height() / theme_.px(30), 2);
  for (const double value :
       perHertz > 0 ? niceTicks(0.0, visibleTop().value * perHertz, most) : std::vector<double>{}) {
    const int y = static_cast<int>(std::lround(yOf(Hertz(value / perHertz))));
    p.drawLine(plot.left() - theme_.px(5), y, plot.left() - 1, y);
    const QString label = value > 0 ? number(value) : join(number(0), unit);
    p.drawText(plot.left() - theme_.px(9) - metrics.horizontalAdvance(label), y + half, label);
  }
  drawTimes(p, plot);
}

// By the clock, so that what is seen here is found again elsewhere; without one, back from now.
void SpectrogramWidget::drawTimes(QPainter& p, const QRect& plot) const {
  constexpr double kSpan = 10.0, kEvery = 2.0;  // s
  const QFontMetrics metrics = p.fontMetrics();
  const auto tick = [&](double ago, const QString& label) {
    const int x = plot.right() + 1 - static_cast<int>(std::lround(plot.width() * ago / kSpan));
    p.drawLine(x, plot.bottom() + 1, x, plot.bottom() + theme_.px(5));
    const int w = metrics.horizontalAdvance(label);
    p.drawText(std::clamp(x - w / 2, 0, width() - w), plot.bottom() + theme_.px(8) + metrics.ascent(), label);
  };
  if (!wallMsAtStreamZero_ || newest_ == Instant{}) {
    for (double s = 0.0; s <= kSpan; s += kEvery) tick(s, s > 0.0 ? join(number(-s), tr("s")) : tr("now"));
    return;
  }
  const double end = static_cast<double>(*wallMsAtStreamZero_ + toNs(newest_) / 1'000'000) * 1e-3;
  for (double t = std::ceil((end - kSpan) / kEvery) * kEvery; t <= end; t += kEvery) {
    tick(end - t, clockTime(std::llround(t * 1e3)));
  }
}

void SpectrogramWidget::drawTeeth(QPainter& p, const QRect& plot) const {
  if (teeth_ < 1 || !(spindle_.value > 0)) return;
  const Hertz passing = spindle_ * static_cast<double>(teeth_);
  p.setFont(theme_.font(type_size::kTick));
  const QFontMetrics metrics = p.fontMetrics();
  const int half = metrics.capHeight() / 2;
  double lastLabel = plot.bottom() + theme_.px(40);
  for (int k = 1; passing * static_cast<double>(k) < visibleTop(); ++k) {
    const double y = yOf(passing * static_cast<double>(k));
    p.setPen(QPen(theme_.colors.text, theme_.px(1.4)));
    p.drawLine(QPointF(plot.right() + 2, y), QPointF(plot.right() + theme_.px(9), y));
    const bool covered = chatter_.value > 0 && std::abs(y - yOf(chatter_)) < theme_.px(22);
    if (covered || lastLabel - y < theme_.px(18)) continue;
    p.setPen(theme_.colors.secondary);
    p.drawText(QPointF(plot.right() + theme_.px(13), y + half), k == 1 ? tr("1\u00d7 tooth") : tr("%1\u00d7").arg(k));
    lastLabel = y;
  }
}

void SpectrogramWidget::drawChatter(QPainter& p, const QRect& plot) const {
  if (!(chatter_.value > 0) || chatter_ > visibleTop()) return;
  if (plotState_ == PlotState::Stale || plotState_ == PlotState::Ended) return;
  p.setFont(theme_.font(type_size::kLabel, true));
  const QFontMetrics metrics = p.fontMetrics();
  const double y = yOf(chatter_);
  const int height = theme_.px(24), tip = theme_.px(9);
  const double left = plot.right() + 2;
  const QRectF tag(left + tip, y - height / 2.0, width() - theme_.px(6) - left - tip, height);
  QPolygonF pointer;
  pointer << QPointF(left, y) << QPointF(tag.left(), tag.top()) << tag.topRight() << tag.bottomRight()
          << QPointF(tag.left(), tag.bottom());
  p.setPen(Qt::NoPen);
  p.setBrush(theme_.back(chatterTone_));
  p.drawPolygon(pointer);
  p.setPen(theme_.front(chatterTone_));
  p.drawText(QPointF(tag.left() + theme_.px(3), y + metrics.capHeight() / 2.0), chatterLabel_);
}

}  // namespace stillcut::ui
