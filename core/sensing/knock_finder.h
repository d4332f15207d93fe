// Knocks that no cut makes. In one window of one channel: how much a linear predictor leaves of the signal, and how
// much of the signal's energy lies in isolated knocks that do not come back at the same spindle angle.
//
// A structure is driven where an edge enters or leaves, at the same angles turn after turn, in chatter as well as in a
// stable cut; what a predictor of order 8 (Levinson's recursion on the window itself) cannot foretell of it are a few
// percent. A sensor that rattles on its seat changes its gain and knocks at any angle, each time within one sample.
// A knock is six standard deviations of what is usual (by the median, which knocks do not move) from the prediction,
// and three times anything seen near that angle in the last turns.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

struct KnockFacts {
  double left = 0.0;      // part of the power that the predictor leaves, 0..1; white noise: 1
  double kurtosis = 0.0;  // of what it leaves; Gaussian noise: 3
  double part = 0.0;      // part of the window's energy in knocks
  int knocks = 0;
};

class KnockFinder {
 public:
  static constexpr int kAngles = 120;                  // 3 degrees each
  static constexpr std::uint8_t kNoAngle = 0xFF;       // the spindle's angle is not known: no knock is counted
  static std::uint8_t angleOf(double angle) noexcept;  // [rad], wrapped to 0..2 pi

  void prepare(int longestWindow);
  void reset() noexcept;
  // A window without its mean, the angle of every sample, and the least that counts as a knock.
  KnockFacts look(std::span<const double> x, std::span<const std::uint8_t> angle, double least) noexcept;

 private:
  static constexpr int kOrder = 8;
  bool predict(std::span<const double> x) noexcept;
  bool isNews(double size, int angle) noexcept;
  void turnTo(int angle) noexcept;
  double middle(std::size_t count) noexcept;

  dsp::kernels::Kernels kernels_;
  std::vector<double> rest_, sorted_;
  static constexpr std::size_t kBins = 512;
  std::array<std::uint32_t, kBins> counts_{};
  std::array<double, kOrder + 1> model_{};
  std::array<double, kAngles> before_{};  // largest by angle in the turns before, fading
  std::array<double, kAngles> now_{};     // ... in this turn
  int angle_ = 0;
  int turns_ = 0;
};

}  // namespace stillcut::detect
