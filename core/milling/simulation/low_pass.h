// Butterworth low-pass of 4th order, bilinear with the edge at -3 dB: what sits before a converter, and after one.
// Thread: one, real-time.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/units.h"

namespace stillcut::milling {

class LowPass4 {
 public:
  void prepare(Hertz edge, Hertz rate) noexcept {
    const double w = std::tan(kTwoPi * 0.5 * edge.value / rate.value);
    const std::array<double, 2> quality{0.54119610014619701, 1.3065629648763764};
    for (std::size_t i = 0; i < 2; ++i) {
      const double norm = 1.0 / (1.0 + w / quality[i] + w * w);
      sections_[i] = {w * w * norm, 2.0 * (w * w - 1.0) * norm, (1.0 - w / quality[i] + w * w) * norm, 0.0, 0.0};
    }
  }
  // As if x had always been there.
  void settle(double x) noexcept {
    for (Section& s : sections_) {
      s.s2 = (s.b - s.a2) * x;
      s.s1 = (2.0 * s.b - s.a1) * x + s.s2;
    }
  }
  double run(double x) noexcept {
    for (Section& s : sections_) {
      const double y = s.b * x + s.s1;
      s.s1 = 2.0 * s.b * x - s.a1 * y + s.s2;
      s.s2 = s.b * x - s.a2 * y;
      x = y;
    }
    return x;
  }

 private:
  struct Section {
    double b = 1.0, a1 = 0.0, a2 = 0.0, s1 = 0.0, s2 = 0.0;  // b, 2b, b
  };
  std::array<Section, 2> sections_{};
};

}  // namespace stillcut::milling
