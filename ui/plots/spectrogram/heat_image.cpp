#include "ui/plots/spectrogram/heat_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "ui/plots/spectrogram/colormap.h"

namespace stillcut::ui {
namespace {

constexpr double kHoleFrom = 1.8;      // columns: further apart than that, some are missing
constexpr double kSameSpindle = 1e-3;  // a change of speed less than this moves no order by a pixel

bool sameLook(const HeatWindow& a, const HeatWindow& b) {
  return a.size == b.size && a.span == b.span && a.low == b.low && a.high == b.high && a.order == b.order &&
         a.linear == b.linear && a.low_dB == b.low_dB && a.high_dB == b.high_dB && a.gap == b.gap;
}

// The palette's place of every level, 0..255.
std::size_t shade(float level_dB, const HeatWindow& w) {
  if (!std::isfinite(level_dB)) return 0;
  const double level = level_dB;
  const double place =
      w.linear ? std::pow(10.0, (level - w.high_dB) / 20.0) : (level - w.low_dB) / (w.high_dB - w.low_dB);
  return static_cast<std::size_t>(std::lround(std::clamp(place, 0.0, 1.0) * 255.0));
}

}  // namespace

double columnHop(const std::deque<SpectrumColumn>& columns) {
  double hop = 1.0;
  const std::size_t looked = std::min<std::size_t>(columns.size(), 20);
  for (std::size_t k = columns.size() - looked + 1; k < columns.size(); ++k) {
    const double apart = secondsBetween(columns[k - 1].time, columns[k].time).value;
    if (apart > 0.0) hop = std::min(hop, apart);
  }
  return hop;
}

std::int64_t HeatImage::pixelOf(Instant t) const {
  return static_cast<std::int64_t>(std::floor(sinceEpoch(t).value / window_.span.value * window_.size.width()));
}

// True where the picture has been moved and only its right end is to be painted.
bool HeatImage::moveAlong(const HeatWindow& window, Hertz spindle, Hertz top) {
  const bool speedHeld = !window.order || std::abs(spindle / spindle_ - 1.0) < kSameSpindle;
  const bool same = sameLook(window, window_) && speedHeld && top == top_ && !image_.isNull();
  window_ = window;
  const std::int64_t first = pixelOf(window.from);
  const std::int64_t by = first - first_;
  const int width = window.size.width();
  if (!same || by < 0 || by >= width) {
    spindle_ = spindle;
    top_ = top;
    first_ = next_ = first;
    stretch_ = -1.0;
    image_ = QImage(window.size, QImage::Format_RGB32);
    image_.fill(window.gap);
    return false;
  }
  first_ = first;
  for (int y = 0; by > 0 && y < window.size.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
    std::memmove(line, line + by, sizeof(QRgb) * static_cast<std::size_t>(width - by));
    std::fill(line + width - by, line + width, window.gap);
  }
  return true;
}

void HeatImage::fitRows(double stretch, Hertz top) {
  if (std::abs(stretch - stretch_) < 1e-6) return;
  stretch_ = stretch;
  const int height = window_.size.height();
  const double binWidth = top.value / kSpectrumBins;
  bins_.resize(static_cast<std::size_t>(height) + 1);
  for (int y = 0; y <= height; ++y) {
    const double f = (window_.low.value + (window_.high - window_.low).value * (height - y) / height) * stretch;
    bins_[static_cast<std::size_t>(y)] = std::clamp(static_cast<int>(f / binWidth), 0, kSpectrumBins - 1);
  }
}

// A row shows the strongest of its bins, so that no line falls between two.
void HeatImage::paint(const Levels& levels, std::int64_t from, std::int64_t to) {
  const std::int64_t left = std::max<std::int64_t>(from - first_, 0);
  const std::int64_t right = std::min<std::int64_t>(to - first_, window_.size.width());
  if (left >= right) return;
  const ColorTable& palette = viridis();
  std::array<QRgb, kSpectrumBins> colors{};
  for (int b = bins_.back(); b <= bins_.front(); ++b) {
    const auto index = static_cast<std::size_t>(b);
    colors[index] = palette[shade(levels[index], window_)];
  }
  for (int y = 0; y < window_.size.height(); ++y) {
    auto best = static_cast<std::size_t>(bins_[static_cast<std::size_t>(y) + 1]);
    const auto above = static_cast<std::size_t>(bins_[static_cast<std::size_t>(y)]);
    for (std::size_t b = best + 1; b < above; ++b) {
      if (levels[b] > levels[best]) best = b;
    }
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
    std::fill(line + left, line + right, colors[best]);
  }
  painted_ += static_cast<int>(right - left);
}

const QImage& HeatImage::draw(const RunHistory& history, const HeatWindow& window) {
  painted_ = 0;
  const auto& columns = history.columns();
  if (columns.empty() || window.size.isEmpty() || !(window.span.value > 0.0) || !(history.spectrumTop().value > 0.0)) {
    image_ = QImage();
    return image_;
  }
  const Hertz newest = columns.back().spindle;
  moveAlong(window, newest, history.spectrumTop());
  const double hop = columnHop(columns);
  const Instant begin = std::min(window.from, columns.back().time) - toDuration(Seconds(kHoleFrom * hop));
  auto c = std::lower_bound(columns.begin(), columns.end(), begin,
                            [](const SpectrumColumn& column, Instant t) { return column.time < t; });
  const std::int64_t end = first_ + window.size.width();
  while (c != columns.end()) {
    const std::int64_t pixel = pixelOf(c->time);
    if (pixel >= end) break;
    const double stretch = window.order && newest.value > 0 && c->spindle.value > 0 ? c->spindle / newest : 1.0;
    Levels levels = c->level_dB;
    auto last = c;
    for (++c; c != columns.end() && pixelOf(c->time) == pixel; last = c++) {
      for (std::size_t b = 0; b < levels.size(); ++b) levels[b] = std::max(levels[b], c->level_dB[b]);
    }
    if (pixel + 1 < next_ && c != columns.end()) continue;  // painted before
    const bool follows = c != columns.end() && secondsBetween(last->time, c->time).value < kHoleFrom * hop;
    const std::int64_t to =
        std::max(follows ? pixelOf(c->time) : pixelOf(last->time + toDuration(Seconds(hop))), pixel + 1);
    fitRows(stretch, history.spectrumTop());
    paint(levels, pixel, to);
    if (follows) next_ = to;
  }
  return image_;
}

}  // namespace stillcut::ui
