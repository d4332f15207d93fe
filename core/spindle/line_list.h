// LineList: the lines of a power spectrum that stand out of the noise beside them.
//
// A bin is a line's where it is a local maximum and at least `kAboveNoise` times the noise around it. The noise is the
// median of the powers of a stretch of the spectrum: of white noise a bin's power is exponential, whose median is
// ln 2 of its mean. Frequencies between bins by a parabola through the logarithms (peak_shift.h).
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/units.h"

namespace stillcut::detect {

struct SpectralLine {
  Hertz frequency{};
  double power = 0.0;     // of its highest bin, as the spectrum gives it
  std::size_t bin = 0;    // the highest bin
  bool machines = false;  // stood there without the cut: no part of what is cut
};

class LineList {
 public:
  static constexpr int kMost = 96;  // the strongest

  void prepare(int bins, Hertz binWidth);
  // powers: of every bin of a Hann spectrum. Lines between low and high.
  void find(std::span<const double> powers, Hertz low, Hertz high) noexcept;
  std::span<SpectralLine> lines() noexcept { return {lines_.data(), count_}; }
  std::span<const SpectralLine> lines() const noexcept { return {lines_.data(), count_}; }

 private:
  double noiseAt(std::size_t bin) const noexcept;
  void measureNoise(std::span<const double> powers, std::size_t last) noexcept;

  double binWidth_ = 1.0;
  std::size_t stretch_ = 1;     // bins
  std::size_t stretches_ = 0;   // of this spectrum
  std::vector<double> noise_;   // mean power of a bin, by stretch
  std::vector<double> sorted_;  // of one stretch
  std::vector<SpectralLine> candidates_;
  std::array<SpectralLine, kMost> lines_{};
  std::size_t count_ = 0;
};

}  // namespace stillcut::detect
