#include "ui/plots/spectrum_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/models/plot_state_text.h"
#include "ui/plots/touch_input.h"

namespace stillcut::ui {
namespace {

constexpr double kStep_dB = 10.0;

}  // namespace

SpectrumPlot::SpectrumPlot(AnalyseView& view, QWidget* parent)
    : QWidget(parent), view_(view), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);  // what lies behind would be painted with every picture
  setAccessibleName(tr("Spectrum"));
  setToolTip(tr("Click: harmonic cursor. H: on the strongest line. Drag: move. Wheel: zoom."));
  connect(&view, &AnalyseView::changed, this, qOverload<>(&QWidget::update));
  TouchInput::Moves fingers;
  fingers.pan = [this](QPointF by) { moveBy(by.x()); };
  fingers.zoom = [this](double factor, QPointF around, Qt::Orientation along) {
    if (along == Qt::Horizontal) view_.zoomFrequency(factor, std::max(frequencyAt(around.x()), Hertz()));
  };
  fingers.flings = true;
  new TouchInput(this, std::move(fingers));
}

void SpectrumPlot::display(const SpectrumView& spectrum) {
  spectrum_ = spectrum;
  setAccessibleDescription(spectrum.reading);
  if (!spectrum.known) return;
  const float loud = *std::max_element(spectrum.level_dB.begin(), spectrum.level_dB.end());
  // The scale moves in whole steps and seldom, as the palette of the spectrogram does.
  if (std::isfinite(loud) && (loud > high_dB_ || loud < high_dB_ - 3 * kStep_dB)) {
    high_dB_ = std::ceil(loud / kStep_dB) * kStep_dB;
    low_dB_ = high_dB_ - 80.0;
  }
  update();
}

void SpectrumPlot::toggleReference() {
  if (reference_) {
    reference_.reset();
  } else if (spectrum_.known) {
    reference_ = spectrum_.level_dB;
  }
  update();
}

void SpectrumPlot::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize SpectrumPlot::minimumSizeHint() const {
  return {theme_.px(300), theme_.px(180)};
}

QRect SpectrumPlot::plotRect() const {
  return rect().adjusted(theme_.px(66), theme_.px(52), -theme_.px(14), -theme_.px(26));
}

Hertz SpectrumPlot::frequencyAt(double x) const {
  const QRect plot = plotRect();
  const AnalyseOptions& o = view_.options();
  return o.low + (o.high - o.low) * ((x - plot.left()) / std::max(plot.width(), 1));
}

double SpectrumPlot::xOf(Hertz f) const {
  const QRect plot = plotRect();
  const AnalyseOptions& o = view_.options();
  return plot.left() + (f - o.low) / (o.high - o.low) * plot.width();
}

AxisRange SpectrumPlot::levels() const {
  if (view_.options().level == LevelScale::Linear) return {0.0, amplitudeOf(high_dB_)};
  return {low_dB_, high_dB_};
}

void SpectrumPlot::drawCurve(QPainter& p, const Levels& level_dB, const QPen& pen) const {
  const QRect plot = plotRect();
  const AxisRange range = levels();
  const bool linear = view_.options().level == LevelScale::Linear;
  const double width = spectrum_.top.value / kSpectrumBins;
  QPolygonF line;
  for (int b = 0; b < kSpectrumBins; ++b) {
    const double x = xOf(Hertz((b + 0.5) * width));
    if (x < plot.left() - 20 || x > plot.right() + 20) continue;
    const double level = level_dB[static_cast<std::size_t>(b)];
    const double place = std::isfinite(level) ? range.place(linear ? amplitudeOf(level) : level) : 0.0;
    line << QPointF(x, plot.bottom() + 1 - std::clamp(place, -0.05, 1.05) * plot.height());
  }
  // Lines of one pixel are drawn directly, thicker ones as polygons at ten times the price: thick is two thin ones.
  p.setPen(pen);
  p.setBrush(Qt::NoBrush);
  p.drawPolyline(line);
  if (pen.style() == Qt::SolidLine) p.drawPolyline(line.translated(0.0, 1.0));
}

void SpectrumPlot::setPlotState(PlotState plotState) {
  if (plotState == plotState_) return;
  plotState_ = plotState;
  update();
}

void SpectrumPlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), theme_.colors.panel);
  p.setRenderHint(QPainter::Antialiasing);
  const QRect plot = plotRect();
  if (plot.width() < 40 || plot.height() < 20) return;
  p.setPen(theme_.colors.secondary);
  p.setFont(theme_.font(type_size::kLabel, true));
  const bool old = plotState_ == PlotState::Stale && !spectrum_.atCursor;
  const QString title = !spectrum_.known                 ? tr("SPECTRUM")
                        : spectrum_.atCursor             ? tr("SPECTRUM AT A, %1").arg(spectrum_.time)
                        : old                            ? tr("SPECTRUM, STALE: nothing new arrives")
                        : plotState_ == PlotState::Moves ? tr("SPECTRUM, NEWEST")
                                                         : plotStateTitle(tr("SPECTRUM"), plotState_);
  if (old) p.setPen(theme_.colors.onsetText);
  p.drawText(QRect(theme_.px(12), 0, width() - theme_.px(24), theme_.px(26)), Qt::AlignVCenter | Qt::AlignLeft, title);
  const QString unit =
      view_.options().level == LevelScale::Linear ? rmsUnit(spectrum_.unit) : decibelUnit(spectrum_.unit);
  p.setFont(theme_.font(type_size::kLabel));
  if (spectrum_.known)
    p.drawText(QRect(0, 0, plot.right() + 1, theme_.px(26)), Qt::AlignVCenter | Qt::AlignRight, unit);
  p.setFont(theme_.font(type_size::kLabel, true));
  p.setPen(theme_.colors.text);
  p.drawText(QRect(theme_.px(12), theme_.px(22), width() - theme_.px(24), theme_.px(20)),
             Qt::AlignVCenter | Qt::AlignLeft,
             spectrum_.reading.isEmpty() ? QString() : tr("cursor: %1").arg(spectrum_.reading));
  p.fillRect(plot, theme_.colors.track);
  const bool order = view_.options().axis == FrequencyAxis::Order && spectrum_.spindle.value > 0;
  const double per = order ? 1.0 / spectrum_.spindle.value : 1.0;
  const AnalyseOptions& o = view_.options();
  drawBottomAxis(p, plot, {o.low.value * per, o.high.value * per}, order ? tr("order") : QStringLiteral("Hz"), theme_);
  drawLeftAxis(p, plot, levels(), o.level == LevelScale::Linear ? QString() : QStringLiteral("dB"), theme_);
  if (spectrum_.known) {
    p.save();
    p.setClipRect(plot);
    if (old) p.setOpacity(0.4);
    if (reference_) drawCurve(p, *reference_, QPen(theme_.colors.advice, 1, Qt::DashLine));
    if (spectrum_.hold) drawCurve(p, *spectrum_.hold, QPen(theme_.colors.faint, 1));
    drawCurve(p, spectrum_.level_dB, QPen(theme_.colors.text, 1));
    p.restore();
    drawMarks(p);
  }
  if (hasFocus()) {
    p.setPen(QPen(theme_.colors.text, theme_.px(1.5), Qt::DotLine));
    p.setBrush(Qt::NoBrush);
    p.drawRect(plot.adjusted(0, 0, -1, -1));
  }
}

void SpectrumPlot::drawMarks(QPainter& p) const {
  const QRect plot = plotRect();
  const auto inside = [&](double x) { return x >= plot.left() && x <= plot.right() + 1; };
  p.setPen(QPen(theme_.colors.text, theme_.px(1.4)));
  for (const Hertz f : spectrum_.toothPassing) {
    const double x = xOf(f);
    if (inside(x)) p.drawLine(QPointF(x, plot.top() - theme_.px(6)), QPointF(x, plot.top()));
  }
  p.setPen(QPen(theme_.colors.onsetText, theme_.px(1.2), Qt::DashLine));
  for (const Hertz f : spectrum_.harmonics) {
    const double x = xOf(f);
    if (inside(x)) p.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
  }
  const double x = xOf(spectrum_.chatter);
  if (!(spectrum_.chatter.value > 0) || !inside(x)) return;
  p.setFont(theme_.font(type_size::kTick, true));
  const QString label = tr("chatter %1").arg(join(number(spectrum_.chatter.value), QStringLiteral("Hz")));
  const double w = p.fontMetrics().horizontalAdvance(label) + theme_.px(10);
  const QRectF tag(std::clamp(x - w / 2, double(plot.left()), plot.right() - w), plot.top() + theme_.px(2), w,
                   theme_.px(19));
  p.setPen(QPen(theme_.colors.chatterText, theme_.px(1.5)));
  p.drawLine(QPointF(x, tag.bottom()), QPointF(x, plot.bottom()));
  p.fillRect(tag, theme_.back(Tone::Chatter));
  p.setPen(theme_.front(Tone::Chatter));
  p.drawText(tag, Qt::AlignCenter, label);
}

void SpectrumPlot::wheelEvent(QWheelEvent* event) {
  view_.zoomFrequency(std::pow(0.8, event->angleDelta().y() / 120.0),
                      std::max(frequencyAt(event->position().x()), Hertz()));
  event->accept();
}

void SpectrumPlot::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  dragged_ = false;
}

void SpectrumPlot::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  if (!dragged_ && std::abs(event->position().x() - pressed_->x()) < 6.0) return;
  dragged_ = true;
  const double by = event->position().x() - last_.x();
  last_ = event->position();
  moveBy(by);
}

void SpectrumPlot::moveBy(double right) {
  view_.panFrequency((view_.options().high - view_.options().low) * (-right / std::max(plotRect().width(), 1)));
}

void SpectrumPlot::mouseReleaseEvent(QMouseEvent* event) {
  const bool click = pressed_ && !dragged_;
  pressed_.reset();
  const Hertz f = frequencyAt(event->position().x());
  if (click && f.value > 0.0) view_.setHarmonic(f);
}

void SpectrumPlot::keyPressEvent(QKeyEvent* event) {
  const AnalyseOptions& o = view_.options();
  const Hertz step = (o.high - o.low) * 0.005;
  switch (event->key()) {
    case Qt::Key_H:
      if (const auto line = strongestLine(spectrum_.level_dB, spectrum_.top, o.low, o.high)) view_.setHarmonic(*line);
      return;
    case Qt::Key_Left:
    case Qt::Key_Right: {
      const Hertz from = view_.harmonic().value_or((o.low + o.high) * 0.5);
      view_.setHarmonic(std::max(from + (event->key() == Qt::Key_Left ? -step : step), step));
      return;
    }
    case Qt::Key_Delete:
      view_.setHarmonic({});
      return;
    case Qt::Key_PageUp:
      view_.zoomFrequency(1.25, o.low);
      return;
    case Qt::Key_PageDown:
      view_.zoomFrequency(0.8, o.low);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace stillcut::ui
