#include "core/dsp/kernels/harmonic_loop.h"
#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
void powers(double c, double s, std::size_t n, double* re, double* im) noexcept {
  double r = c;
  double i = s;
  for (std::size_t k = 0; k < n; ++k) {
    re[k] = r;
    im[k] = i;
    const double next = r * c - i * s;
    i = r * s + i * c;
    r = next;
  }
}

void turn(double* re, double* im, const double* rotationRe, const double* rotationIm, std::size_t lanes) noexcept {
  for (std::size_t n = 0; n < lanes; n += kLanes) {
    const Lanes r = load(re + n);
    const Lanes i = load(im + n);
    const Lanes c = load(rotationRe + n);
    const Lanes s = load(rotationIm + n);
    store(re + n, r * c - i * s);
    store(im + n, r * s + i * c);
  }
}

void harmonics(const HarmonicRun& run) noexcept {
  harmonicLoop(run, [](double) {});
}

void harmonicPair(const HarmonicRun& first, const HarmonicRun& second) noexcept {
  if constexpr (kParts == 1) {
    switch (first.lanes / kLanes) {
      case 1:
        return pairInRegisters<1>(first, second);
      case 2:
        return pairInRegisters<2>(first, second);
      case 3:
        return pairInRegisters<3>(first, second);
      case 4:
        return pairInRegisters<4>(first, second);
      case 5:
        return pairInRegisters<5>(first, second);
      case 6:
        return pairInRegisters<6>(first, second);
      default:
        break;
    }
  }
  harmonics(first);
  harmonics(second);
}

double weightedPower(const double* re, const double* im, const double* weight, std::size_t lanes) noexcept {
  Lanes sum = all(0.0);
  for (std::size_t n = 0; n < lanes; n += kLanes) {
    const Lanes r = load(re + n);
    const Lanes i = load(im + n);
    sum = sum + load(weight + n) * (r * r + i * i);
  }
  return total(sum);
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
