#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

enum Row : std::size_t { kGain, kA1, kA2, kB1, kB2 };

// One register of bands. Two sections in transposed direct form with the states' signs turned (a negation less).
struct Sections {
  Native gain, a1, a2, b1, b2;
  Native n0, n1, m0, m1;

  [[gnu::always_inline]] Native process(Native x) {
    const Native t = gain * x;
    const Native y = t - n0;
    n0 = n1 + a1 * y;
    n1 = t + a2 * y;
    const Native z = y - m0;
    m0 = m1 + b1 * z;
    m1 = y + b2 * z;
    return z;
  }
};

STILLCUT_INLINE Sections loadSections(const BankRun& run, std::size_t lane) {
  const double* c = run.coefficients + lane;
  const double* z = run.state + lane;
  const std::size_t n = run.stride;
  return {loadNative(c + kGain * n), loadNative(c + kA1 * n), loadNative(c + kA2 * n),
          loadNative(c + kB1 * n),   loadNative(c + kB2 * n), loadNative(z),
          loadNative(z + n),         loadNative(z + 2 * n),   loadNative(z + 3 * n)};
}

STILLCUT_INLINE void storeState(const BankRun& run, std::size_t lane, const Sections& s) {
  double* z = run.state + lane;
  const std::size_t n = run.stride;
  storeNative(z, s.n0);
  storeNative(z + n, s.n1);
  storeNative(z + 2 * n, s.m0);
  storeNative(z + 3 * n, s.m1);
}

// kCount registers of bands side by side: one waits for its recursion while the other works.
template <std::size_t kCount>
STILLCUT_INLINE void filter(const BankRun& run, std::size_t lane) {
  Sections sections[kCount];
  for (std::size_t u = 0; u < kCount; ++u) sections[u] = loadSections(run, lane + u * kNative);
  const auto put = [&](std::size_t k, Native(&rows)[kCount][kNative]) {
    for (std::size_t u = 0; u < kCount; ++u) {
      transpose(rows[u]);
      for (std::size_t j = 0; j < kNative; ++j) storeNative(run.out[lane + u * kNative + j] + k, rows[u][j]);
    }
  };
  std::size_t k = 0;
  for (; k + kNative <= run.frames; k += kNative) {
    Native rows[kCount][kNative];
    for (std::size_t j = 0; j < kNative; ++j) {
      const Native x = spread(run.x[k + j]);
      for (std::size_t u = 0; u < kCount; ++u) rows[u][j] = sections[u].process(x);
    }
    put(k, rows);
  }
  if (k < run.frames) {
    Native rows[kCount][kNative] = {};
    for (std::size_t j = 0; k + j < run.frames; ++j) {
      const Native x = spread(run.x[k + j]);
      for (std::size_t u = 0; u < kCount; ++u) rows[u][j] = sections[u].process(x);
    }
    put(k, rows);
  }
  for (std::size_t u = 0; u < kCount; ++u) storeState(run, lane + u * kNative, sections[u]);
}

}  // namespace

void bank(const BankRun& run) noexcept {
  std::size_t lane = 0;
  for (; lane + 2 * kNative <= run.lanes; lane += 2 * kNative) filter<2>(run, lane);
  for (; lane < run.lanes; lane += kNative) filter<1>(run, lane);
}

// The prototype's pole p = (-1 + j) / sqrt 2 gives s^2 - p w s + c = 0 with w = high - low, c = low high, whose roots
// s = (p w +- sqrt(-4 c - j w^2)) / 2 are mapped to z = (1 + s) / (1 - s); s^2 w^2 over the four poles has the gain 1
// at the centre.
void designBank(const BankDesign& design) noexcept {
  constexpr double kRootHalf = 0.70710678118654752440;
  for (std::size_t n = 0; n < design.lanes; n += kLanes) {
    const Lanes low = load(design.low + n);
    const Lanes high = load(design.high + n);
    const Lanes width = high - low;
    const Lanes c4 = all(4.0) * low * high;
    const Lanes w2 = width * width;
    const Lanes im = root(all(0.5) * (root(c4 * c4 + w2 * w2) + c4));  // of the root, turned in sign
    const Lanes re = all(0.5) * w2 / im;
    const Lanes half = all(kRootHalf) * width;
    Lanes gain = w2;
    const auto section = [&](Lanes sigma, Lanes omega, std::size_t row) {
      const Lanes one = all(1.0);
      const Lanes o2 = omega * omega;
      const Lanes below = (one - sigma) * (one - sigma) + o2;
      gain = gain / below;
      store(design.coefficients + row * design.stride + n, all(-2.0) * ((one - sigma * sigma) - o2) / below);
      store(design.coefficients + (row + 1) * design.stride + n, ((one + sigma) * (one + sigma) + o2) / below);
    };
    section(all(0.5) * (re - half), all(0.5) * (half - im), kA1);
    section(all(-0.5) * (re + half), all(0.5) * (half + im), kB1);
    store(design.coefficients + kGain * design.stride + n, gain);
  }
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
