// The loop of a HarmonicRun, with something to be done with every rest while the next one is on its way.
// Only for files compiled once per instruction set; see kernels.h. Real-time; one thread for each state.
#pragma once

#include "core/dsp/kernels/lanes.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {

// The state in registers: kGroups times eight harmonics.
template <std::size_t kGroups, class Then>
STILLCUT_INLINE void inRegisters(const HarmonicRun& run, const Then& then) {
  Lanes re[kGroups];
  Lanes im[kGroups];
  Lanes c[kGroups];
  Lanes s[kGroups];
  for (std::size_t g = 0; g < kGroups; ++g) {
    re[g] = load(run.re + g * kLanes);
    im[g] = load(run.im + g * kLanes);
    c[g] = load(run.rotationRe + g * kLanes);
    s[g] = load(run.rotationIm + g * kLanes);
  }
  for (std::size_t k = 0; k < run.frames; ++k) {
    Lanes sum = re[0];
    for (std::size_t g = 1; g < kGroups; ++g) sum = sum + re[g];
    const double residual = run.x[k] - total(sum);
    run.residual[k] = residual * run.after;
    const Lanes step = all(run.gain * residual);
    then(residual);
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

// Two signals whose harmonics rotate alike.
template <std::size_t kGroups>
STILLCUT_INLINE void pairInRegisters(const HarmonicRun& first, const HarmonicRun& second) {
  const HarmonicRun* const runs[2] = {&first, &second};
  Lanes re[2][kGroups];
  Lanes im[2][kGroups];
  for (std::size_t n = 0; n < 2; ++n) {
    for (std::size_t g = 0; g < kGroups; ++g) {
      re[n][g] = load(runs[n]->re + g * kLanes);
      im[n][g] = load(runs[n]->im + g * kLanes);
    }
  }
  for (std::size_t k = 0; k < first.frames; ++k) {
    Lanes step[2];
    for (std::size_t n = 0; n < 2; ++n) {
      Lanes sum = re[n][0];
      for (std::size_t g = 1; g < kGroups; ++g) sum = sum + re[n][g];
      const double residual = runs[n]->x[k] - total(sum);
      runs[n]->residual[k] = residual * runs[n]->after;
      step[n] = all(runs[n]->gain * residual);
    }
    for (std::size_t g = 0; g < kGroups; ++g) {
      const Lanes c = load(first.rotationRe + g * kLanes);
      const Lanes s = load(first.rotationIm + g * kLanes);
      for (std::size_t n = 0; n < 2; ++n) {
        const Lanes r = re[n][g] + step[n];
        re[n][g] = r * c - im[n][g] * s;
        im[n][g] = r * s + im[n][g] * c;
      }
    }
  }
  for (std::size_t n = 0; n < 2; ++n) {
    for (std::size_t g = 0; g < kGroups; ++g) {
      store(runs[n]->re + g * kLanes, re[n][g]);
      store(runs[n]->im + g * kLanes, im[n][g]);
    }
  }
}

template <class Then>
STILLCUT_INLINE void inMemory(const HarmonicRun& run, const Then& then) {
  Lanes sum = load(run.re);
  for (std::size_t n = kLanes; n < run.lanes; n += kLanes) sum = sum + load(run.re + n);
  for (std::size_t k = 0; k < run.frames; ++k) {
    const double residual = run.x[k] - total(sum);
    run.residual[k] = residual * run.after;
    const Lanes step = all(run.gain * residual);
    then(residual);
    const auto group = [&](std::size_t n) {
      const Lanes r = load(run.re + n) + step;
      const Lanes i = load(run.im + n);
      const Lanes c = load(run.rotationRe + n);
      const Lanes s = load(run.rotationIm + n);
      const Lanes re = r * c - i * s;
      store(run.re + n, re);
      store(run.im + n, r * s + i * c);
      return re;
    };
    sum = group(0);
    for (std::size_t n = kLanes; n < run.lanes; n += kLanes) sum = sum + group(n);
  }
}

template <class Then>
STILLCUT_INLINE void harmonicLoop(const HarmonicRun& run, const Then& then) {
  if constexpr (kParts == 1) {  // other sets have not the registers
    switch (run.lanes / kLanes) {
      case 1:
        return inRegisters<1>(run, then);
      case 2:
        return inRegisters<2>(run, then);
      case 3:
        return inRegisters<3>(run, then);
      case 4:
        return inRegisters<4>(run, then);
      case 5:
        return inRegisters<5>(run, then);
      case 6:
        return inRegisters<6>(run, then);
      default:
        break;
    }
  }
  inMemory(run, then);
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
