// AxisTally: what one axis of the loop did over about the last second, in tenths.
// Thread: one; everything but prepare() is real-time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/realtime.h"
#include "core/model/active_state.h"

namespace stillcut::active {

class AxisTally {
 public:
  // `amplitude`: the largest output.
  void prepare(Hertz rate, double amplitude) {
    length_ = std::max(1, static_cast<int>(std::lround(kTenth * rate.value)));
    amplitude_ = amplitude;
    reset();
  }
  void reset() noexcept {
    ring_ = {};
    at_ = 0;
  }
  void add(double error, double without, double output, bool limited) STILLCUT_RT {
    Tenth& now = ring_[at_];
    now.peak = std::max(now.peak, std::abs(output));
    now.output += output * output;
    now.error += error * error;
    now.without += without * without;
    now.limited += limited ? 1 : 0;
    if (++now.samples == length_) {
      at_ = (at_ + 1) % kTenths;
      ring_[at_] = {};
    }
  }
  void tell(ActiveAxis& axis) const STILLCUT_RT {
    Tenth all;
    for (const Tenth& t : ring_) {
      all.peak = std::max(all.peak, t.peak);
      all.output += t.output;
      all.error += t.error;
      all.without += t.without;
      all.limited += t.limited;
      all.samples += t.samples;
    }
    const double n = std::max(1, all.samples);
    axis.strokePeak = all.peak / amplitude_;
    axis.strokeRms = std::sqrt(all.output / n) / amplitude_;
    axis.limitedFraction = all.limited / n;
    axis.errorRms = std::sqrt(all.error / n);
    axis.uncontrolledRms = std::sqrt(all.without / n);
  }

 private:
  static constexpr double kTenth = 0.1;  // [s]
  static constexpr std::size_t kTenths = 11;
  struct Tenth {
    double peak = 0.0, output = 0.0, error = 0.0, without = 0.0;
    int limited = 0, samples = 0;
  };
  int length_ = 1;
  double amplitude_ = 1.0;
  std::array<Tenth, kTenths> ring_{};
  std::size_t at_ = 0;
};

}  // namespace stillcut::active
