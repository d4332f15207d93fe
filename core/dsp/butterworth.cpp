#include "core/dsp/butterworth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::dsp {
namespace {

using Complex = std::complex<double>;

// Analogue edge frequency (in units of 2/T) that the bilinear transform maps to `edge`.
double prewarp(Hertz edge, Hertz rate) {
  const double relative = std::clamp(edge.value / rate.value, 1e-7, 0.4999);
  return std::tan(std::numbers::pi * relative);
}

Complex prototypePole(int k, int order) {
  return std::polar(1.0, std::numbers::pi * (2.0 * k + order + 1.0) / (2.0 * order));
}

Complex bilinear(Complex s) {
  return (1.0 + s) / (1.0 - s);
}

// Section with poles p, q (a conjugate pair or two reals) and numerator b; gain set so that |H| = 1 at z0.
Biquad makeSection(Complex p, Complex q, double b1, double b2, Complex z0) {
  Biquad s{1.0, b1, b2, -(p + q).real(), (p * q).real()};
  const Complex d = 1.0 / z0;
  const double gain = std::abs((1.0 + s.a1 * d + s.a2 * d * d) / (1.0 + b1 * d + b2 * d * d));
  s.b0 *= gain;
  s.b1 *= gain;
  s.b2 *= gain;
  return s;
}

// One real pole as a section of first order.
Biquad firstOrder(double pole, double zero, double z0) {
  const double gain = std::abs((1.0 - pole / z0) / (1.0 - zero / z0));
  return {gain, -zero * gain, 0.0, -pole, 0.0};
}

// Low-pass (zeros at z = -1) or high-pass (zeros at z = +1) from the prototype's poles mapped by `analogue`.
template <class Map>
int fill(std::array<Biquad, Butterworth::kMaxSections>& out, int order, double zero, Map analogue) {
  int count = 0;
  for (int k = 0; k < order / 2; ++k) {
    const Complex p = bilinear(analogue(prototypePole(k, order)));
    out[static_cast<std::size_t>(count++)] = makeSection(p, std::conj(p), -2.0 * zero, 1.0, Complex(-zero, 0.0));
  }
  if (order % 2 == 1) {
    const double p = bilinear(analogue(Complex(-1.0, 0.0))).real();
    out[static_cast<std::size_t>(count++)] = firstOrder(p, zero, -zero);
  }
  return count;
}

}  // namespace

void Butterworth::lowPass(int order, Hertz edge, Hertz rate) noexcept {
  const double w = prewarp(edge, rate);
  sections_ = fill(coefficients_, std::clamp(order, 1, 2 * kMaxSections), -1.0, [w](Complex s) { return s * w; });
}

void Butterworth::highPass(int order, Hertz edge, Hertz rate) noexcept {
  const double w = prewarp(edge, rate);
  sections_ = fill(coefficients_, std::clamp(order, 1, 2 * kMaxSections), 1.0, [w](Complex s) { return w / s; });
}

void Butterworth::process(std::span<Butterworth> filters, const double* x, std::ptrdiff_t stride, double* out,
                          std::ptrdiff_t outStride, std::size_t frames, const kernels::Kernels& kernels) noexcept {
  static_assert(sizeof(Biquad) == 5 * sizeof(double) && sizeof(state_) == 2 * kMaxSections * sizeof(double));
  for (std::size_t n = 0; n < filters.size(); n += 2) {
    const bool alone = n + 1 == filters.size();
    kernels::CascadeRun run;
    run.frames = frames;
    run.sections = static_cast<std::size_t>(filters[n].sections_);
    std::array<std::array<double, 2>, kMaxSections> copied = filters[n].state_;  // an odd one keeps itself company
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t at = alone ? n : n + i;
      run.in[i] = x + static_cast<std::ptrdiff_t>(at) * stride;
      run.out[i] = out + static_cast<std::ptrdiff_t>(at) * outStride;
      run.coefficients[i] = &filters[at].coefficients_[0].b0;
      run.state[i] = alone && i == 1 ? copied[0].data() : filters[at].state_[0].data();
    }
    kernels.cascade(run);
  }
}

std::complex<double> Butterworth::response(Hertz f, Hertz rate) const {
  const Complex d = std::polar(1.0, -kTwoPi * f.value / rate.value);
  Complex h = 1.0;
  for (int s = 0; s < sections_; ++s) {
    const Biquad& c = coefficients_[static_cast<std::size_t>(s)];
    h *= (c.b0 + c.b1 * d + c.b2 * d * d) / (1.0 + c.a1 * d + c.a2 * d * d);
  }
  return h;
}

}  // namespace stillcut::dsp
