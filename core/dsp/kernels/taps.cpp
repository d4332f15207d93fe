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
  return total(even + odd);
}

void tapSteer(double* a, double keep, double step, const double* b, std::size_t taps) noexcept {
  // 1 for what is left of the taps in the last lanes, 0 after it.
  static constexpr double kLast[2 * kLanes] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  const Lanes kept = all(keep);
  const Lanes stepped = all(step);
  const std::size_t whole = taps / kLanes * kLanes;
  for (std::size_t k = 0; k < whole; k += kLanes) store(a + k, kept * load(a + k) + stepped * load(b + k));
  if (whole == taps) return;
  const Lanes last = load(kLast + kLanes - (taps - whole));
  store(a + whole, (kept * load(a + whole) + stepped * load(b + whole)) * last);
}

void tapPair(PairRun& run) noexcept {
  Lanes in[2] = {all(0.0), all(0.0)};  // four chains
  Lanes past[2] = {all(0.0), all(0.0)};
  for (std::size_t k = 0; k < run.forwardTaps; k += kLanes) {
    const Lanes c = load(run.forward + k);
    in[0] = in[0] + c * load(run.in[0] + k);
    in[1] = in[1] + c * load(run.in[1] + k);
  }
  for (std::size_t k = 0; k < run.backwardTaps; k += kLanes) {
    const Lanes c = load(run.backward + k);
    past[0] = past[0] + c * load(run.past[0] + k);
    past[1] = past[1] + c * load(run.past[1] + k);
  }
  run.out[0] = total(in[0] + past[0]);
  run.out[1] = total(in[1] + past[1]);
}

void lineSums(const LineRun& run) noexcept {
  for (std::size_t l = 0; l < run.lanes; l += kLanes) {
    Lanes re = load(run.re + l), im = load(run.im + l);
    const Lanes turnRe = load(run.turnRe + l), turnIm = load(run.turnIm + l);
    Lanes xRe = load(run.xRe + l), xIm = load(run.xIm + l);
    Lanes yRe = load(run.yRe + l), yIm = load(run.yIm + l);
    for (std::size_t n = 0; n < run.frames; ++n) {
      const Lanes x = all(run.x[n]), y = all(run.y[n]);
      xRe = xRe + x * re;
      xIm = xIm + x * im;
      yRe = yRe + y * re;
      yIm = yIm + y * im;
      const Lanes next = re * turnRe - im * turnIm;
      im = re * turnIm + im * turnRe;
      re = next;
    }
    store(run.re + l, re);
    store(run.im + l, im);
    store(run.xRe + l, xRe);
    store(run.xIm + l, xIm);
    store(run.yRe + l, yRe);
    store(run.yIm + l, yIm);
  }
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
