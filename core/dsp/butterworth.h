// Butterworth filters as biquad cascades (transposed direct form II), designed by the bilinear transform with
// prewarped edges, so that the response at the edges is exactly -3 dB (half power). retune() changes the coefficients
// in place, without allocation, and keeps the state: what a filter that follows the spindle speed needs.
// Source: any text on digital filters; poles of the prototype s_k = exp(j pi (2k + n + 1) / 2n).
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "core/base/units.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::dsp {

struct Biquad {
  double b0 = 1.0, b1 = 0.0, b2 = 0.0, a1 = 0.0, a2 = 0.0;
};

class Butterworth {
 public:
  static constexpr int kMaxSections = 8;

  // order: poles. A bank of band-passes is a kernel of its own (kernels.h, BankDesign).
  // Edges are clamped into (0, rate/2). Real-time (trigonometry only); the state is kept.
  void lowPass(int order, Hertz edge, Hertz rate) noexcept;
  void highPass(int order, Hertz edge, Hertz rate) noexcept;

  // One stretch of several signals, each through its own filter; all filters of one order. x[signal * stride + frame];
  // out the same with outStride, and may be x itself.
  static void process(std::span<Butterworth> filters, const double* x, std::ptrdiff_t stride, double* out,
                      std::ptrdiff_t outStride, std::size_t frames, const kernels::Kernels& kernels) noexcept;
  double process(double x) noexcept {
    for (int s = 0; s < sections_; ++s) {
      const Biquad& c = coefficients_[static_cast<std::size_t>(s)];
      std::array<double, 2>& z = state_[static_cast<std::size_t>(s)];
      const double y = c.b0 * x + z[0];
      z[0] = c.b1 * x - c.a1 * y + z[1];
      z[1] = c.b2 * x - c.a2 * y;
      x = y;
    }
    return x;
  }
  void reset() noexcept { state_ = {}; }

  // H(e^{j 2 pi f / rate}).
  std::complex<double> response(Hertz f, Hertz rate) const;

 private:
  int sections_ = 0;
  std::array<Biquad, kMaxSections> coefficients_{};
  std::array<std::array<double, 2>, kMaxSections> state_{};
};

}  // namespace stillcut::dsp
