#include "ui/plots/spectrogram/spectrogram_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/plots/spectrogram/colormap.h"

namespace stillcut::ui {
namespace {

constexpr int kMostColumns = 2000;

SpectrogramImage::Cell cellOf(const SpectrumColumn& column, Tone alarm) {
  return {true, column.afterGap, alarm, {column.level_dB.begin(), column.level_dB.end()}};
}

}  // namespace

void SpectrogramImage::setAxis(int rows, Hertz visibleTop, Hertz spectrumTop) {
  std::vector<int> bins;
  if (rows > 0 && spectrumTop.value > 0 && visibleTop.value > 0) {
    const double binsPerRow = std::min(visibleTop / spectrumTop, 1.0) * kSpectrumBins / rows;
    for (int r = 0; r <= rows; ++r)
      bins.push_back(std::clamp(static_cast<int>((rows - r) * binsPerRow), 0, kSpectrumBins));
  }
  if (bins == firstBin_) return;
  rows_ = bins.empty() ? 0 : rows;
  firstBin_ = std::move(bins);
  paintAll();
}

void SpectrogramImage::setGapColor(QRgb color) {
  if (color == gapColor_) return;
  gapColor_ = color;
  paintAll();
}

void SpectrogramImage::clear() {
  cells_.clear();
  hasLast_ = false;
  period_ = Seconds();
  capacity_ = 0;
  image_ = QImage();
  range_ = LevelRange();
}

void SpectrogramImage::append(const SpectrumColumn& column, Tone alarm) {
  const Seconds since = secondsBetween(last_.time, column.time);
  if (hasLast_ && (column.time <= last_.time || since > span_)) clear();
  if (hasLast_ && capacity_ == 0) start(column);
  const bool repaint = range_.add(column.level_dB);
  if (capacity_ > 0) {
    const long steps = std::max(std::lround(since / period_), 1L);
    // Hatched is only what the device has lost. Columns that a late screen has missed are left empty.
    for (long k = 1; k < steps; ++k) push(Cell{false, column.afterGap, Tone::Normal, {}});
    push(cellOf(column, alarm));
    if (repaint) paintAll();
  }
  last_ = column;
  lastAlarm_ = alarm;
  hasLast_ = true;
}

// The distance of two columns with nothing lost between them is the width of a pixel.
void SpectrogramImage::start(const SpectrumColumn& second) {
  if (second.afterGap || second.number <= last_.number) return;
  const auto steps = static_cast<double>(second.number - last_.number);
  period_ = secondsBetween(last_.time, second.time) * (1.0 / steps);
  capacity_ = std::clamp(static_cast<int>(std::lround(span_ / period_)), 2, kMostColumns);
  cells_.assign(1, cellOf(last_, lastAlarm_));
  paintAll();
}

void SpectrogramImage::push(Cell cell) {
  cells_.push_back(std::move(cell));
  while (static_cast<int>(cells_.size()) > capacity_) cells_.pop_front();
  if (image_.isNull()) return;
  scrollLeft();
  paintCell(capacity_ - 1, cells_.back());
}

void SpectrogramImage::scrollLeft() {
  for (int y = 0; y < rows_; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
    std::memmove(line, line + 1, sizeof(QRgb) * static_cast<std::size_t>(capacity_ - 1));
  }
}

void SpectrogramImage::paintAll() {
  if (capacity_ == 0 || rows_ == 0) {
    image_ = QImage();
    return;
  }
  image_ = QImage(capacity_, rows_, QImage::Format_ARGB32_Premultiplied);
  image_.fill(Qt::transparent);
  int x = capacity_ - static_cast<int>(cells_.size());
  for (const Cell& cell : cells_) paintCell(x++, cell);
}

// A row shows the highest of its bins, so that a narrow line never falls between two rows.
void SpectrogramImage::paintCell(int x, const Cell& cell) {
  const ColorTable& colors = viridis();
  for (int y = 0; y < rows_; ++y) {
    QRgb color = gapColor_;
    if (cell.present) {
      const int from = std::min(firstBin_[static_cast<std::size_t>(y) + 1], kSpectrumBins - 1);
      const int to = std::max(firstBin_[static_cast<std::size_t>(y)], from + 1);
      const float level = *std::max_element(cell.level_dB.begin() + from, cell.level_dB.begin() + to);
      const double place = std::isfinite(level) ? range_.place(level) : 0.0;
      color = colors[static_cast<std::size_t>(std::lround(place * 255.0))] | 0xff000000U;
    }
    reinterpret_cast<QRgb*>(image_.scanLine(y))[x] = color;
  }
}

}  // namespace stillcut::ui
