// WavePyramid: least and greatest of every stretch of a signal, in steps of four, so that any part of a recording of
// any length is drawn from a few thousand numbers. 64 samples make the finest cell; what lies between is drawn from
// the samples themselves. Samples that are missing are not a number and belong to no cell.
// Thread: one while samples are added; any afterwards. 0.17 bytes a sample.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace stillcut {

struct WaveExtent {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  bool present() const { return low <= high; }
  void take(float value) {
    if (std::isnan(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void take(const WaveExtent& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

class WavePyramid {
 public:
  static constexpr std::int64_t kCell = 64;  // samples of the finest cell
  static constexpr std::int64_t kStep = 4;   // cells that make one of the next level
  static constexpr std::size_t kLevels = 10;

  void add(std::span<const float> samples) {
    for (const float value : samples) {
      if (samples_ % kCell == 0) levels_[0].emplace_back();
      levels_[0].back().take(value);
      whole_.take(value);
      ++samples_;
      if (samples_ % kCell == 0) lift(levels_[0].size());
    }
  }

  std::int64_t samples() const { return samples_; }
  // Least and greatest of all.
  const WaveExtent& whole() const { return whole_; }
  // Of the finest cells that hold the samples from .. to.
  WaveExtent over(std::int64_t from, std::int64_t to) const {
    WaveExtent found;
    from = std::clamp<std::int64_t>(from, 0, samples_);
    to = std::clamp<std::int64_t>(to, from, samples_);
    const std::int64_t end = (to + kCell - 1) / kCell;
    for (std::int64_t cell = from / kCell; cell < end;) {
      // The largest one that begins here and does not reach too far.
      std::size_t level = 0;
      std::int64_t wide = 1;
      while (level + 1 < kLevels && cell % (wide * kStep) == 0 && cell + wide * kStep <= end &&
             static_cast<std::size_t>(cell / (wide * kStep)) < levels_[level + 1].size()) {
        wide *= kStep;
        ++level;
      }
      found.take(levels_[level][static_cast<std::size_t>(cell / wide)]);
      cell += wide;
    }
    return found;
  }

 private:
  // A whole cell has been made: where it is the last of its four, they are one of the next level.
  void lift(std::size_t cells) {
    for (std::size_t level = 0; level + 1 < kLevels && cells % kStep == 0; ++level) {
      WaveExtent one;
      for (std::size_t k = cells - kStep; k < cells; ++k) one.take(levels_[level][k]);
      levels_[level + 1].push_back(one);
      cells = levels_[level + 1].size();
    }
  }

  std::array<std::vector<WaveExtent>, kLevels> levels_;
  std::int64_t samples_ = 0;
  WaveExtent whole_;
};

}  // namespace stillcut
