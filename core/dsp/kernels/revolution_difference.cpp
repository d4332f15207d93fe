// Fractional delays in lanes of time.
#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

constexpr double kDifferenceScale = 0.408248290463863;  // 1 / sqrt(6)
constexpr double kNewsScale = 0.816496580927726;        // 1 / sqrt(1.5)

// Four sums, so that none waits for another.
STILLCUT_INLINE Lanes delayed(const double* newest, const double* taps) {
  Lanes sums[4] = {};
  for (std::size_t k = 0; k < kDelayTaps; k += 4) {
    for (std::size_t i = 0; i < 4; ++i) sums[i] = sums[i] + all(taps[k + i]) * load(newest - (k + i));
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

STILLCUT_INLINE double delayedOne(const double* newest, const double* taps) {
  double sums[4] = {};
  for (std::size_t k = 0; k < kDelayTaps; k += 4) {
    for (std::size_t i = 0; i < 4; ++i) sums[i] += taps[k + i] * *(newest - (k + i));
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

void turns(const RevolutionDifferenceRun& run) noexcept {
  const auto eight = [&run](std::size_t f) {
    const Lanes now = load(run.now + f);
    const Lanes one = delayed(run.one + f, run.oneTaps);
    const Lanes two = delayed(run.two + f, run.twoTaps);
    store(run.difference + f, all(kDifferenceScale) * ((now - all(2.0) * one) + two));
    if (run.innovation != nullptr) store(run.innovation + f, all(kNewsScale) * (now - all(0.5) * (one + two)));
  };
  std::size_t f = 0;
  for (; f + kLanes <= run.frames; f += kLanes) eight(f);
  if (f < run.frames && f > 0) return eight(run.frames - kLanes);  // some of them once more, to the same bits
  for (; f < run.frames; ++f) {
    const double now = run.now[f];
    const double one = delayedOne(run.one + f, run.oneTaps);
    const double two = delayedOne(run.two + f, run.twoTaps);
    run.difference[f] = kDifferenceScale * ((now - 2.0 * one) + two);
    if (run.innovation != nullptr) run.innovation[f] = kNewsScale * (now - 0.5 * (one + two));
  }
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
