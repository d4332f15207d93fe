#include "ui/plots/spectrogram/level_range.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillcut::ui {
namespace {

constexpr double kStep = 5.0;
constexpr double kSlack = 7.5;       // how far the signal must leave the range, or the range the signal, to move it
constexpr double kLeastSpan = 40.0;  // less would blow noise up to a pattern
constexpr double kMostSpan = 80.0;
constexpr double kFloorShare = 0.02;  // per column
constexpr double kPeakFall = 0.05;    // dB per column

double upwards(double v) {
  return std::ceil(v / kStep) * kStep;
}
double downwards(double v) {
  return std::floor(v / kStep) * kStep;
}

}  // namespace

bool LevelRange::add(std::span<const float> levels_dB) {
  std::vector<float> sorted;
  sorted.reserve(levels_dB.size());
  for (const float v : levels_dB) {
    if (std::isfinite(v)) sorted.push_back(v);
  }
  if (sorted.empty()) return false;
  const auto fifth = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 5);
  std::nth_element(sorted.begin(), fifth, sorted.end());
  const double quiet = *fifth;
  const double loud = *std::max_element(sorted.begin(), sorted.end());
  if (!started_) {
    started_ = true;
    floor_ = quiet;
    peak_ = loud;
    low_ = downwards(floor_);
    high_ = std::max(upwards(peak_), low_ + kLeastSpan);
    low_ = std::max(low_, high_ - kMostSpan);
    return true;
  }
  floor_ += kFloorShare * (quiet - floor_);
  peak_ = std::max(loud, peak_ - kPeakFall);
  return settle();
}

bool LevelRange::settle() {
  double low = low_, high = high_;
  if (std::abs(floor_ - low_) > kSlack) low = downwards(floor_);
  if (peak_ > high_ || peak_ < high_ - 2.0 * kSlack) high = upwards(peak_);
  high = std::max(high, low + kLeastSpan);
  low = std::max(low, high - kMostSpan);
  const bool moved = low < low_ || low > low_ || high < high_ || high > high_;
  low_ = low;
  high_ = high;
  return moved;
}

double LevelRange::place(double level_dB) const {
  return std::clamp((level_dB - low_) / (high_ - low_), 0.0, 1.0);
}

}  // namespace stillcut::ui
