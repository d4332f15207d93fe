// HarmonicMask: which bins of a spectrum belong to the spindle.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

// Bins of the spindle harmonics (the tooth-passing ones are among them): free() is 1 between them and 0 on them.
class HarmonicMask {
 public:
  void prepare(int bins, double binWidth);
  // halfWidth: bins to either side. doubt: standard deviation of the spindle frequency, widens the mask with the order.
  // Below half the spindle frequency and above `high` nothing is free.
  void update(Hertz spindle, Hertz doubt, double halfWidth, Hertz high) noexcept;
  bool free(std::size_t bin) const noexcept { return free_[bin] != 0.0; }
  std::span<const double> frees() const noexcept { return std::span(free_).first(bins_); }
  // Frequency^(2 eta) of every bin; eta -1, 0, 1.
  std::span<const double> weights(int eta) const noexcept { return weights_[static_cast<std::size_t>(eta + 1)]; }
  std::size_t first() const noexcept { return first_; }
  std::size_t last() const noexcept { return last_; }  // inclusive; the outermost bins are never in reach

 private:
  dsp::kernels::Kernels kernels_;
  std::size_t bins_ = 0;
  double binWidth_ = 1.0;
  std::size_t first_ = 1;
  std::size_t last_ = 0;
  std::vector<double> free_;
  std::array<std::vector<double>, 3> weights_;
};

}  // namespace stillcut::detect
