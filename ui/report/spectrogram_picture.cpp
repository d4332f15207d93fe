#include "ui/report/spectrogram_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/spectrogram/colormap.h"
#include "ui/report/plot_frame.h"

namespace stillcut::ui {
namespace {

constexpr double kStep = 5.0;
constexpr double kLeastSpan = 30.0;
constexpr double kMostSpan = 80.0;

double partOf(std::vector<float>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return static_cast<double>(values[static_cast<std::size_t>(at)]);
}

void drawLevels(QPainter& painter, const QRectF& inside, const LevelSpan& levels, const PageStyle& style) {
  const QRectF bar(inside.right() + 10, inside.top(), 9, inside.height());
  QImage shades(1, 256, QImage::Format_RGB32);
  for (int i = 0; i < 256; ++i) shades.setPixel(0, 255 - i, viridis()[static_cast<std::size_t>(i)]);
  painter.drawImage(bar, shades);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style.colors().border, 1.0));
  painter.drawRect(bar);
  for (const double level : niceTicks(levels.low, levels.high, 5)) {
    const double y = bar.bottom() - (level - levels.low) / (levels.high - levels.low) * bar.height();
    drawLine(painter, QRectF(bar.right() + 4, y - 7, 36, 14), number(level), style.font(10), style.colors().secondary);
  }
  drawLine(painter, QRectF(bar.left(), bar.top() - 17, 40, 15), say("dB"), style.font(10), style.colors().secondary);
}

void drawMarks(QPainter& painter, const QRectF& inside, const SessionSummary& summary, Hertz top,
               const PageStyle& style) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(style.colors().chatter);
  double lastX = -1e9;
  for (const SpectrumColumn& column : summary.spectrogram) {
    if (!(column.chatter.value > 0.0) || column.chatter.value > top.value) continue;
    const double x = inside.left() + sinceEpoch(column.time).value / summary.length.value * inside.width();
    if (x - lastX < 5.0) continue;  // dots, so that what lies under them is still seen
    lastX = x;
    const double y = inside.bottom() - column.chatter.value / top.value * inside.height();
    painter.setPen(QPen(style.colors().raised, 0.7));
    painter.drawEllipse(QPointF(x, y), 2.2, 2.2);
  }
}

}  // namespace

LevelSpan levelSpan(const SessionSummary& summary) {
  std::vector<float> all;
  const std::size_t every = std::max<std::size_t>(1, summary.spectrogram.size() / 256);
  for (std::size_t i = 0; i < summary.spectrogram.size(); i += every) {
    for (const float v : summary.spectrogram[i].level_dB) {
      if (std::isfinite(v)) all.push_back(v);
    }
  }
  if (all.empty()) return {};
  LevelSpan span;
  span.high = std::ceil(partOf(all, 0.9995) / kStep) * kStep;
  span.low = std::floor(partOf(all, 0.20) / kStep) * kStep;
  span.low = std::clamp(span.low, span.high - kMostSpan, span.high - kLeastSpan);
  return span;
}

Hertz visibleTop(const SessionSummary& summary) {
  std::array<double, kSpectrumBins> power{};
  double chatter = 0.0;
  for (const SpectrumColumn& column : summary.spectrogram) {
    chatter = std::max(chatter, column.chatter.value);
    for (std::size_t b = 0; b < power.size(); ++b) {
      const double level = static_cast<double>(column.level_dB[b]);
      if (std::isfinite(level)) power[b] += std::pow(10.0, 0.1 * level);
    }
  }
  double all = 0.0;
  for (const double p : power) all += p;
  constexpr double kNearlyAll = 0.999;
  constexpr double kLeast = 0.08;  // of what was measured
  constexpr double kMargin = 1.5;
  constexpr double kHarmonics = 3.5;  // of chatter
  double sum = 0.0;
  std::size_t bin = 0;
  while (bin + 1 < power.size() && sum + power[bin] < kNearlyAll * all) sum += power[bin++];
  const double binWidth = summary.spectrumTop.value / kSpectrumBins;
  const double wanted = std::max(
      {kMargin * binWidth * static_cast<double>(bin + 1), kHarmonics * chatter, kLeast * summary.spectrumTop.value});
  return Hertz(std::min(wanted, summary.spectrumTop.value));
}

QImage spectrogramImage(const SessionSummary& summary, Hertz top, const LevelSpan& levels, QRgb gap) {
  if (summary.spectrogram.empty() || !(summary.length.value > 0.0)) return {};
  const auto columns = static_cast<int>(summary.spectrogram.size());
  const double part = std::clamp(top.value / std::max(summary.spectrumTop.value, 1e-9), 0.0, 1.0);
  const int bins = std::max(1, static_cast<int>(std::lround(part * kSpectrumBins)));
  QImage image(columns, bins, QImage::Format_RGB32);
  image.fill(gap);
  const double perPixel = summary.length.value / columns;
  const double reach = 1.5 * std::max(summary.columnWidth.value, perPixel);
  std::size_t nearest = 0;
  for (int x = 0; x < columns; ++x) {
    const double t = (x + 0.5) * perPixel;
    const auto away = [&](std::size_t i) { return std::abs(sinceEpoch(summary.spectrogram[i].time).value - t); };
    while (nearest + 1 < summary.spectrogram.size() && away(nearest + 1) <= away(nearest)) ++nearest;
    if (away(nearest) > reach) continue;
    const SpectrumColumn& column = summary.spectrogram[nearest];
    for (int bin = 0; bin < bins; ++bin) {
      const double level = static_cast<double>(column.level_dB[static_cast<std::size_t>(bin)]);
      const double place = std::isfinite(level) ? (level - levels.low) / (levels.high - levels.low) : 0.0;
      const auto index = static_cast<std::size_t>(std::lround(255.0 * std::clamp(place, 0.0, 1.0)));
      image.setPixel(x, bins - 1 - bin, viridis()[index]);
    }
  }
  return image;
}

void drawSpectrogram(QPainter& painter, const QRectF& inside, const SessionSummary& summary, Hertz top,
                     const PageStyle& style) {
  const LevelSpan levels = levelSpan(summary);
  const QImage image = spectrogramImage(summary, top, levels, style.colors().gap.rgb());
  painter.fillRect(inside, style.colors().gap);
  if (image.isNull()) {
    drawLine(painter, inside, say("too short for a spectrogram"), style.font(12), style.colors().secondary,
             Qt::AlignCenter);
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(inside, image);
  drawMarks(painter, inside, summary, top, style);
  drawLevels(painter, inside, levels, style);
}

}  // namespace stillcut::ui
