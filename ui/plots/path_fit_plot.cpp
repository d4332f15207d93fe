#include "ui/plots/path_fit_plot.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/plots/axis_painter.h"

namespace stillcut::ui {
namespace {

constexpr double kTells = 0.8;  // coherence below which the measurement says little
constexpr double kDegrees = 360.0 / kTwoPi;
constexpr double kSpan_dB = 60.0;
constexpr double kStands = 90.0;  // [degrees]

double decibel(std::complex<double> value) {
  return 20.0 * std::log10(std::max(std::abs(value), 1e-300));
}

}  // namespace

PathFitPlot::PathFitPlot(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Fit of the path's model"));
}

double PathFitPlot::phaseError(const PathFit& fit, std::size_t k) {
  if (!(fit.coherence[k] >= kTells)) return std::numeric_limits<double>::quiet_NaN();
  return std::arg(fit.modelled[k] * std::conj(fit.measured[k])) * kDegrees;
}

void PathFitPlot::display(const PathFit* fit) {
  // Both axes were identified at one time; their magnitudes are never the same.
  const bool same = fit == nullptr
                        ? !hasFit()
                        : hasFit() && fit->path.identified == fit_.path.identified && fit->measured == fit_.measured;
  if (same) return;
  fit_ = fit != nullptr ? *fit : PathFit();
  update();
}

void PathFitPlot::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QPen PathFitPlot::pen(const QColor& color, Qt::PenStyle style) const {
  return QPen(color, theme_.px(1.6), style);
}

template <class Value>
void PathFitPlot::drawCurve(QPainter& p, const QRect& box, double low, double high, const QPen& pen,
                            const Value& value) const {
  const double top = fit_.frequency.back();
  QPainterPath path;
  bool drawn = false;
  for (std::size_t k = 0; k < fit_.frequency.size(); ++k) {
    const double v = value(k);
    if (!std::isfinite(v)) {
      drawn = false;
      continue;
    }
    const double x = box.left() + fit_.frequency[k] / top * box.width();
    const double y = box.bottom() - std::clamp((v - low) / (high - low), 0.0, 1.0) * box.height();
    drawn ? path.lineTo(x, y) : path.moveTo(x, y);
    drawn = true;
  }
  p.setPen(pen);
  p.setBrush(Qt::NoBrush);
  p.drawPath(path);
}

void PathFitPlot::drawMagnitude(QPainter& p, const QRect& box) const {
  double high = -1e300;
  for (const auto& value : fit_.measured) high = std::max(high, decibel(value));
  high = std::ceil(high / 10.0) * 10.0;
  drawLeftAxis(p, box, {high - kSpan_dB, high}, QStringLiteral("dB"), theme_);
  drawCurve(p, box, high - kSpan_dB, high, pen(theme_.colors.secondary),
            [this](std::size_t k) { return decibel(fit_.measured[k]); });
  drawCurve(p, box, high - kSpan_dB, high, pen(theme_.colors.advice, Qt::DashLine),
            [this](std::size_t k) { return decibel(fit_.modelled[k]); });
}

void PathFitPlot::drawPhase(QPainter& p, const QRect& box) const {
  const auto at = [&box](double degrees) { return box.bottom() - (degrees + 180.0) / 360.0 * box.height(); };
  for (const double side : {-180.0, kStands}) {
    p.fillRect(QRectF(box.left(), at(side + kStands), box.width(), at(side) - at(side + kStands)),
               QBrush(theme_.colors.hatch, Qt::BDiagPattern));
  }
  drawLeftAxis(p, box, {-180.0, 180.0}, QStringLiteral("\u00b0"), theme_);
  drawCurve(p, box, -180.0, 180.0, pen(theme_.colors.text), [this](std::size_t k) { return phaseError(fit_, k); });
}

void PathFitPlot::drawCoherence(QPainter& p, const QRect& box) const {
  drawLeftAxis(p, box, {0.0, 1.0}, QString(), theme_);
  const double y = box.bottom() - kTells * box.height();
  p.setPen(QPen(theme_.colors.secondary, 1.0, Qt::DashLine));
  p.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
  drawCurve(p, box, 0.0, 1.0, pen(theme_.colors.text), [this](std::size_t k) { return fit_.coherence[k]; });
}

void PathFitPlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setFont(theme_.font(type_size::kTick));
  p.setPen(theme_.colors.secondary);
  if (!hasFit()) {
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No model: identify the path"));
    return;
  }
  const int left = theme_.px(56), right = theme_.px(8), title = theme_.px(20), bottom = theme_.px(28);
  const int each = (height() - bottom) / 3;
  const QString titles[] = {tr("Magnitude: measured grey, model blue and dashed"),
                            tr("Phase error; hatched: control goes wrong"),
                            tr("Coherence; below the mark it says little")};
  for (int k = 0; k < 3; ++k) {
    const QRect box(left, k * each + title, width() - left - right, each - title - theme_.px(8));
    p.setPen(theme_.colors.secondary);
    p.drawText(QRect(left, k * each, box.width(), title), Qt::AlignLeft | Qt::AlignVCenter, titles[k]);
    p.fillRect(box, theme_.colors.track);
    if (k == 0) drawMagnitude(p, box);
    if (k == 1) drawPhase(p, box);
    if (k == 2) drawCoherence(p, box);
    if (k == 2) drawBottomAxis(p, box, {0.0, fit_.frequency.back()}, QStringLiteral("Hz"), theme_);
  }
}

}  // namespace stillcut::ui
