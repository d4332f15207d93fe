#include "ui/plots/tap/frf_plot.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/plots/axis_painter.h"

namespace stillcut::ui {
namespace {

constexpr double kTells = 0.8;  // coherence below which the measurement says little
constexpr double kDegrees = 360.0 / kTwoPi;
constexpr double kMicro = 1e6;  // micrometre over newton
constexpr double kSpan_dB = 60.0;

double decibel(std::complex<double> value) {
  return 20.0 * std::log10(std::max(std::abs(value) * kMicro, 1e-300));
}

}  // namespace

FrfPlot::FrfPlot(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Frequency response at the tip"));
}

void FrfPlot::display(const TapResponse& response) {
  if (response.version == shown_.version) return;
  shown_ = response;
  update();
}

void FrfPlot::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QPen FrfPlot::pen(const QColor& color, Qt::PenStyle style) const {
  return QPen(color, theme_.px(1.6), style);
}

double FrfPlot::across(double frequency, const QRect& box) const {
  return box.left() + frequency / shown_.frequency.back() * box.width();
}

void FrfPlot::drawCurve(QPainter& p, const Box& box, const QPen& pen,
                        const std::function<double(std::size_t)>& value) const {
  QPainterPath path;
  for (std::size_t k = 0; k < shown_.frequency.size(); ++k) {
    const double share = std::clamp((value(k) - box.low) / (box.high - box.low), 0.0, 1.0);
    const QPointF at(across(shown_.frequency[k], box.place), box.place.bottom() - share * box.place.height());
    k > 0 ? path.lineTo(at) : path.moveTo(at);
  }
  p.setPen(pen);
  p.setBrush(Qt::NoBrush);
  p.drawPath(path);
}

// The bed, the band of the fit, and where the modes are.
void FrfPlot::drawFrame(QPainter& p, const Box& box) const {
  p.setPen(theme_.colors.secondary);
  p.setFont(theme_.font(type_size::kTick));
  const int title = theme_.px(18);
  p.drawText(QRect(box.place.left(), box.place.top() - title, box.place.width(), title),
             Qt::AlignLeft | Qt::AlignVCenter, box.title);
  p.fillRect(box.place, theme_.colors.track);
  if (shown_.to > shown_.from) {
    const double from = across(shown_.from, box.place);
    const double to = std::min(across(shown_.to, box.place), static_cast<double>(box.place.right()));
    const QBrush hatch(theme_.colors.hatch, Qt::BDiagPattern);
    p.fillRect(QRectF(box.place.left(), box.place.top(), from - box.place.left(), box.place.height()), hatch);
    p.fillRect(QRectF(to, box.place.top(), box.place.right() - to, box.place.height()), hatch);
  }
  for (const TapMode& mode : shown_.modes) {
    const double x = across(mode.frequency.value, box.place);
    p.setPen(pen(mode.used ? theme_.colors.advice : theme_.colors.faint, Qt::DotLine));
    p.drawLine(QPointF(x, box.place.top()), QPointF(x, box.place.bottom()));
  }
  drawLeftAxis(p, box.place, {box.low, box.high}, box.unit, theme_);
}

// As much of the scale as the measured values take.
void FrfPlot::fitRange(Box& box) const {
  double low = 0.0, high = 0.0;
  for (const auto& line : shown_.measured) {
    low = std::min(low, box.value(line));
    high = std::max(high, box.value(line));
  }
  const double room = std::max(0.05 * (high - low), 1e-12);
  box.low = low - room;
  box.high = high + room;
}

void FrfPlot::drawBox(QPainter& p, const Box& box) const {
  drawFrame(p, box);
  drawCurve(p, box, pen(theme_.colors.text), [&](std::size_t k) { return box.value(shown_.measured[k]); });
  if (shown_.fitted.size() != shown_.frequency.size()) return;
  drawCurve(p, box, pen(theme_.colors.advice, Qt::DashLine),
            [&](std::size_t k) { return box.value(shown_.fitted[k]); });
}

void FrfPlot::drawCoherence(QPainter& p, const Box& box) const {
  const QRect& place = box.place;
  const bool known = shown_.coherence.size() == shown_.frequency.size();
  drawFrame(p, box);
  if (!known) {
    // On a bed of its own: no line crosses it.
    const QString why = shown_.withForce ? tr("One hit only: not known") : tr("No hammer: not known");
    const QFontMetrics metrics(p.font());
    QRect bed(0, 0, metrics.horizontalAdvance(why) + theme_.px(16), metrics.height());
    bed.moveCenter(place.center());
    p.fillRect(bed, theme_.colors.track);
    p.setPen(theme_.colors.secondary);
    p.drawText(bed, Qt::AlignCenter, why);
    return;
  }
  const double y = place.bottom() - kTells * place.height();
  p.setPen(QPen(theme_.colors.secondary, 1.0, Qt::DashLine));
  p.drawLine(QPointF(place.left(), y), QPointF(place.right(), y));
  drawCurve(p, box, pen(theme_.colors.text), [&](std::size_t k) { return shown_.coherence[k]; });
}

void FrfPlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setFont(theme_.font(type_size::kBody));
  if (!hasResponse()) {
    p.setPen(theme_.colors.secondary);
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
               shown_.problem.isEmpty() ? tr("Here the response of the tool appears with the first good hit.")
                                        : shown_.problem);
    return;
  }
  const QString unit = shown_.withForce ? QStringLiteral("\u00b5m/N") : QString();
  const double scale = shown_.withForce ? kMicro : 1.0;
  double most = -1e300;
  for (const auto& v : shown_.measured) most = std::max(most, decibel(v));
  most = std::ceil(most / 10.0) * 10.0;
  // Two columns of two, and the coherence below both.
  std::array<Box, 4> boxes{
      Box{{}, tr("Real part; dashed: the modes"), unit, 0.0, 1.0, [&](auto v) { return scale * v.real(); }},
      Box{{}, tr("Imaginary part"), unit, 0.0, 1.0, [&](auto v) { return scale * v.imag(); }},
      Box{{}, tr("Magnitude"), QStringLiteral("dB"), most - kSpan_dB, most, decibel},
      Box{{}, tr("Phase"), QStringLiteral("\u00b0"), -190.0, 190.0, [](auto v) { return std::arg(v) * kDegrees; }}};
  fitRange(boxes[0]);
  fitRange(boxes[1]);
  Box coherence{{}, tr("Coherence; below the mark it says little"), {}, 0.0, 1.0, {}};
  const int gap = theme_.px(10), title = theme_.px(18), bottom = theme_.px(28);
  const int wide = width() / 2, high = (height() - bottom) * 2 / 5, low = height() - bottom - 2 * high;
  const int plotHigh = high - title - gap, stripHigh = low - title - gap;
  // Every sign and digit has room, and what stands below each other is aligned.
  std::array<int, 2> left{leftAxisWidth(stripHigh, {0.0, 1.0}, {}, theme_), 0};
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    left[k / 2] = std::max(left[k / 2], leftAxisWidth(plotHigh, {boxes[k].low, boxes[k].high}, boxes[k].unit, theme_));
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const int column = static_cast<int>(k / 2), row = static_cast<int>(k % 2);
    boxes[k].place = QRect(column * wide + left[k / 2], row * high + title, wide - left[k / 2] - gap, plotHigh);
    drawBox(p, boxes[k]);
  }
  coherence.place = QRect(left[0], 2 * high + title, width() - left[0] - gap, stripHigh);
  drawCoherence(p, coherence);
  drawBottomAxis(p, coherence.place, {0.0, shown_.frequency.back()}, QStringLiteral("Hz"), theme_);
}

}  // namespace stillcut::ui
