// Sums over the last values of a signal and the weights of an adaptive filter: short, and once per sample.
#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {

namespace {

STILLCUT_INLINE void steer(double* a, double keep, double step, Lanes first, const double* b, std::size_t taps) {
  // 1 for what is left of the taps in the last lanes, 0 after it.
  static constexpr double kLast[2 * kLanes] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  const Lanes kept = all(keep);
  const Lanes stepped = all(step);
  Lanes values = first;
  std::size_t k = 0;
  while (k + kLanes <= taps) {
    store(a + k, kept * load(a + k) + stepped * values);
    k += kLanes;
    if (k == taps) return;  // nothing lies behind them
    values = load(b + k);
  }
  const Lanes last = load(kLast + kLanes - (taps - k));
  store(a + k, (kept * load(a + k) + stepped * values) * last);
}

}  // namespace

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

// The newest last: whatever waits for it then waits for one addition.
double newTapSum(const double* a, double b, const double* older, std::size_t n) noexcept {
  Lanes even = all(0.0);
  Lanes odd = all(0.0);
  std::size_t k = kLanes;
  for (; k + 2 * kLanes <= n; k += 2 * kLanes) {
    even = even + load(a + k) * load(older + k - 1);
    odd = odd + load(a + k + kLanes) * load(older + k + kLanes - 1);
  }
  if (k < n) even = even + load(a + k) * load(older + k - 1);
  return total((even + odd) + load(a) * loadAfter(b, older));
}

void tapSteer(double* a, double keep, double step, const double* b, std::size_t taps) noexcept {
  if (taps == 0) return;  // a finite response has none behind it
  steer(a, keep, step, load(b), b, taps);
}

void newTapSteer(double* a, double keep, double step, double b, const double* older, std::size_t taps) noexcept {
  steer(a, keep, step, loadAfter(b, older), older - 1, taps);
}

void filterPair(PairRun& run) noexcept {
  const Lanes in[2] = {all(run.in[0]), all(run.in[1])};
  const Lanes out[2] = {all(run.out[0]), all(run.out[1])};
  Lanes now[2] = {load(run.state[0]), load(run.state[1])};
  for (std::size_t k = 0; k < run.taps; k += kLanes) {
    const Lanes a = load(run.forward + k);
    const Lanes b = load(run.backward + k);
    for (std::size_t i = 0; i < 2; ++i) {
      const Lanes next = load(run.state[i] + k + kLanes);
      const Lanes moved = movedOn(now[i], next) + (a * in[i] + b * out[i]);
      store(run.state[i] + k, moved);
      if (k == 0) run.out[i] = moved.part[0][0];
      now[i] = next;
    }
  }
}

void lineSums(const LineRun& run) noexcept {
  for (std::size_t l = 0; l < run.lanes; l += kLanes) {
    Lanes re = load(run.re + l), im = load(run.im + l);
    const Lanes rotationRe = load(run.rotationRe + l), rotationIm = load(run.rotationIm + l);
    Lanes xRe = load(run.xRe + l), xIm = load(run.xIm + l);
    Lanes yRe = load(run.yRe + l), yIm = load(run.yIm + l);
    for (std::size_t n = 0; n < run.frames; ++n) {
      const Lanes x = all(run.x[n]), y = all(run.y[n]);
      xRe = xRe + x * re;
      xIm = xIm + x * im;
      yRe = yRe + y * re;
      yIm = yIm + y * im;
      const Lanes next = re * rotationRe - im * rotationIm;
      im = re * rotationIm + im * rotationRe;
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

// Lanes of time.
void demodulate(HannRun& run) noexcept {
  double lineRe[kLanes + 1] = {1.0};
  double lineIm[kLanes + 1] = {0.0};
  double windowRe[kLanes + 1] = {1.0};
  double windowIm[kLanes + 1] = {0.0};
  powers(run.lineRe, run.lineIm, kLanes, lineRe + 1, lineIm + 1);
  powers(run.windowRe, run.windowIm, kLanes, windowRe + 1, windowIm + 1);
  const Lanes rotationRe = all(lineRe[kLanes]), rotationIm = all(lineIm[kLanes]);
  const Lanes stepRe = all(windowRe[kLanes]), stepIm = all(windowIm[kLanes]);
  Lanes re = load(lineRe), im = load(lineIm);
  Lanes rise = load(windowRe), side = load(windowIm);
  Lanes sumRe = all(0.0), sumIm = all(0.0);
  const auto take = [&](const double* x) {
    const Lanes v = load(x) * (all(0.5) - all(0.5) * rise);
    sumRe = sumRe + v * re;
    sumIm = sumIm + v * im;
    const Lanes nextRe = re * rotationRe - im * rotationIm;
    im = re * rotationIm + im * rotationRe;
    re = nextRe;
    const Lanes nextRise = rise * stepRe - side * stepIm;
    side = rise * stepIm + side * stepRe;
    rise = nextRise;
  };
  std::size_t k = 0;
  for (; k + kLanes <= run.frames; k += kLanes) take(run.x + k);
  if (k < run.frames) {
    double last[kLanes] = {};
    for (std::size_t i = 0; k + i < run.frames; ++i) last[i] = run.x[k + i];
    take(last);
  }
  run.re = total(sumRe);
  run.im = total(sumIm);
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
