#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

STILLCUT_INLINE void turnOnce(double* re, double* im, Lanes c, Lanes s) {
  const Lanes r = load(re);
  const Lanes i = load(im);
  store(re, r * c - i * s);
  store(im, r * s + i * c);
}

// The state in registers: kGroups times eight harmonics.
template <std::size_t kGroups>
STILLCUT_INLINE void inRegisters(const HarmonicRun& run) {
  Lanes re[kGroups];
  Lanes im[kGroups];
  Lanes c[kGroups];
  Lanes s[kGroups];
  for (std::size_t g = 0; g < kGroups; ++g) {
    re[g] = load(run.re + g * kLanes);
    im[g] = load(run.im + g * kLanes);
    c[g] = load(run.turnRe + g * kLanes);
    s[g] = load(run.turnIm + g * kLanes);
  }
  for (std::size_t k = 0; k < run.frames; ++k) {
    Lanes sum = re[0];
    for (std::size_t g = 1; g < kGroups; ++g) sum = sum + re[g];
    const double rest = run.x[k] - total(sum);
    run.rest[k] = rest * run.after;
    const Lanes step = all(run.gain * rest);
    for (std::size_t g = 0; g < kGroups; ++g) {
      const Lanes r = re[g] + step;
      re[g] = r * c[g] - im[g] * s[g];
      im[g] = r * s[g] + im[g] * c[g];
    }
  }
  for (std::size_t g = 0; g < kGroups; ++g) {
    store(run.re + g * kLanes, re[g]);
    store(run.im + g * kLanes, im[g]);
  }
}

STILLCUT_INLINE void inMemory(const HarmonicRun& run) {
  for (std::size_t k = 0; k < run.frames; ++k) {
    Lanes sum = load(run.re);
    for (std::size_t n = kLanes; n < run.lanes; n += kLanes) sum = sum + load(run.re + n);
    const double rest = run.x[k] - total(sum);
    run.rest[k] = rest * run.after;
    const Lanes step = all(run.gain * rest);
    for (std::size_t n = 0; n < run.lanes; n += kLanes) {
      store(run.re + n, load(run.re + n) + step);
      turnOnce(run.re + n, run.im + n, load(run.turnRe + n), load(run.turnIm + n));
    }
  }
}

}  // namespace

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

void turn(double* re, double* im, const double* turnRe, const double* turnIm, std::size_t lanes) noexcept {
  for (std::size_t n = 0; n < lanes; n += kLanes) turnOnce(re + n, im + n, load(turnRe + n), load(turnIm + n));
}

void harmonics(const HarmonicRun& run) noexcept {
  if constexpr (kParts == 1) {  // other sets have not the registers
    switch (run.lanes / kLanes) {
      case 1:
        return inRegisters<1>(run);
      case 2:
        return inRegisters<2>(run);
      case 3:
        return inRegisters<3>(run);
      case 4:
        return inRegisters<4>(run);
      default:
        break;
    }
  }
  inMemory(run);
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
