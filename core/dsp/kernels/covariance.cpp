#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

constexpr double kUnit[kLanes][kLanes] = {{1, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 0},
                                          {0, 0, 0, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 0, 1, 0, 0},
                                          {0, 0, 0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 0, 0, 1}};

STILLCUT_INLINE double dot(const double* a, const double* b, std::size_t n) {
  Lanes sum = all(0.0);
  for (std::size_t i = 0; i < n; i += kLanes) sum = sum + load(a + i) * load(b + i);
  return total(sum);
}

// Eight rows from `row` on, one register of columns after the other: P <- P - k ph^T + Q (kUpdate), and what these
// blocks and their mirror images give to P h.
template <bool kUpdate>
STILLCUT_INLINE void rows(const CovarianceRun& run, std::size_t row, const double* gain, const double* h, double* ph) {
  const std::size_t n = 2 * run.lanes;
  double* p = run.p + row * n;
  Octet<Native> mirrored[kLanes];
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto element = [&](std::size_t r, std::size_t column, Native old) {
      double* at = p + r * n + column;
      Native v = loadNative(at);
      if constexpr (kUpdate) {
        v = v - spread(gain[row + r]) * old;
        if (column < row + kLanes) {
          v = v + spread(run.drift[row + r]) * loadNative(kUnit[r] + part * kNative);
        }
        storeNative(at, v);
      }
      return v;
    };
    const std::size_t own = row + part * kNative;
    const Native ownOld = loadNative(run.ph + own);
    Native down = loadNative(ph + own);
    for (std::size_t r = 0; r < kLanes; ++r) down = down + element(r, own, ownOld) * spread(h[row + r]);
    storeNative(ph + own, down);
    Native across[kLanes] = {};
    for (std::size_t column = own + kLanes; column < n; column += kLanes) {
      const Native old = loadNative(run.ph + column);
      const Native there = loadNative(h + column);
      down = loadNative(ph + column);
      for (std::size_t r = 0; r < kLanes; ++r) {
        const Native v = element(r, column, old);
        across[r] = across[r] + v * there;
        down = down + v * spread(h[row + r]);
      }
      storeNative(ph + column, down);
    }
    for (std::size_t r = 0; r < kLanes; ++r) mirrored[r].part[part] = across[r];
  }
  for (std::size_t r = 0; r < kLanes; ++r) ph[row + r] += total(mirrored[r]);
}

template <bool kUpdate>
STILLCUT_INLINE void times(const CovarianceRun& run, const double* gain, double* ph) {
  const std::size_t n = 2 * run.lanes;
  for (std::size_t i = 0; i < n; i += kLanes) store(ph + i, all(0.0));
  for (std::size_t row = 0; row < n; row += kLanes) rows<kUpdate>(run, row, gain, run.h, ph);
}

}  // namespace

void covariance(const CovarianceRun& run) noexcept {
  const std::size_t n = 2 * run.lanes;
  double* gain = run.scratch;
  double* ph = run.scratch + n;
  for (std::size_t k = 0; k < run.frames; ++k) {
    const double part = 1.0 / (1.0 + dot(run.h, run.ph, n));  // of the innovation that is left; K = P h times this
    for (std::size_t i = 0; i < n; i += kLanes) store(gain + i, load(run.ph + i) * all(part));
    for (std::size_t c = 0; c < run.channels; ++c) {
      double* state = run.states + c * n;
      const double e =
          run.x[static_cast<std::ptrdiff_t>(c) * run.stride + static_cast<std::ptrdiff_t>(k)] - dot(run.h, state, n);
      run.residual[static_cast<std::ptrdiff_t>(c) * run.residualStride + static_cast<std::ptrdiff_t>(k)] = e * part;
      for (std::size_t i = 0; i < n; i += kLanes) store(state + i, load(state + i) + load(gain + i) * all(e));
    }
    turn(run.h, run.h + run.lanes, run.rotationRe, run.rotationIm, run.lanes);
    times<true>(run, gain, ph);
    for (std::size_t i = 0; i < n; i += kLanes) store(run.ph + i, load(ph + i));
  }
}

void covarianceTimes(const CovarianceRun& run) noexcept {
  times<false>(run, run.h, run.scratch);
  for (std::size_t i = 0; i < 2 * run.lanes; i += kLanes) store(run.ph + i, load(run.scratch + i));
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
