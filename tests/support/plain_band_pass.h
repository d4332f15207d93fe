// A Butterworth band-pass of four poles from its definition, one sample at a time: what the bank's kernels are held to.
// The two poles of the low-pass prototype, exp(+-j 3 pi/4), each give two by s -> (s^2 + w1 w2) / (s (w2 - w1)), and
// the bilinear transform with prewarped edges takes all four to the z plane. Transposed direct form II: tuned anew it
// keeps what it remembers, as the bank does.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "core/base/units.h"

namespace stillcut::test {

class PlainBandPass {
 public:
  void tune(Hertz low, Hertz high, Hertz rate) {
    const double w1 = std::tan(std::numbers::pi * (low / rate));
    const double w2 = std::tan(std::numbers::pi * (high / rate));
    const std::complex<double> p = std::polar(w2 - w1, 0.75 * std::numbers::pi);
    const std::complex<double> root = std::sqrt(p * p - 4.0 * w1 * w2);
    const std::complex<double> middle = std::polar(1.0, -2.0 * std::atan(std::sqrt(w1 * w2)));  // z^-1 where |H| is 1
    for (std::size_t s = 0; s < 2; ++s) {
      const std::complex<double> analogue = 0.5 * (s == 0 ? p + root : p - root);
      const std::complex<double> pole = (1.0 + analogue) / (1.0 - analogue);
      Section& c = sections_[s];
      c.a1 = -2.0 * pole.real();
      c.a2 = std::norm(pole);
      c.gain = std::abs((1.0 + c.a1 * middle + c.a2 * middle * middle) / (1.0 - middle * middle));
    }
  }
  double process(double x) {
    for (Section& c : sections_) {
      const double y = c.gain * x + c.z1;
      c.z1 = c.z2 - c.a1 * y;
      c.z2 = -c.gain * x - c.a2 * y;
      x = y;
    }
    return x;
  }

 private:
  struct Section {
    double gain = 0.0, a1 = 0.0, a2 = 0.0;
    double z1 = 0.0, z2 = 0.0;
  };
  std::array<Section, 2> sections_;
};

}  // namespace stillcut::test
