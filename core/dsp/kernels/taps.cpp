// Sums over the last values of a signal and the weights of an adaptive filter: short, and once per sample.
#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {

double tapSum(const double* a, const double* b, std::size_t n) noexcept {
  Lanes even = all(0.0);  // two chains: one waits for its addition while the other is added to
  Lanes odd = all(0.0);
  std::size_t k = 0;
  for (; k + 2 * kLanes <= n; k += 2 * kLanes) {
    even = even + load(a + k) * load(b + k);
    odd = odd + load(a + k + kLanes) * load(b + k + kLanes);
  }
  if (k < n) even = even + load(a + k) * load(b + k);
  double s[kLanes];
  store(s, even + odd);
  return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
}

void tapSteer(double* a, double keep, double step, const double* b, std::size_t n) noexcept {
  const Lanes kept = all(keep);
  const Lanes stepped = all(step);
  for (std::size_t k = 0; k < n; k += kLanes) store(a + k, kept * load(a + k) + stepped * load(b + k));
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
