#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

constexpr double kLeastSine2 = 1e-3;  // nearer to 0 or pi the quotient says nothing

struct Operators {
  Lanes signal;
  Lanes difference;
};

STILLCUT_INLINE Operators operators(const double* s, std::size_t d) {
  const Lanes s0 = load(s);
  const Lanes s1 = load(s - d);
  const Lanes s2 = load(s - 2 * d);
  const Lanes s3 = load(s - 3 * d);
  const Lanes s4 = load(s - 4 * d);
  const Lanes y0 = s0 - s1;
  const Lanes y1 = s1 - s2;
  const Lanes y2 = s2 - s3;
  const Lanes y3 = s3 - s4;
  return {s2 * s2 - s3 * s1, (y1 * y1 - y2 * y0) + (y2 * y2 - y3 * y1)};
}

// asin(x) / x for z = x^2 in 0 .. 1/4: Chebyshev fit, good to 1e-18.
STILLCUT_INLINE Lanes arcSineSeries(Lanes z) {
  constexpr double kSeries[] = {0.02604448887372043489 * -1.0, 0.02475487628386959954,
                                0.0007093925943252462581,      0.01000360663988135153,
                                0.009484697869045621556,       0.01158567991890895014,
                                0.0139618911843898398,         0.01735294518022547831,
                                0.02237215153695574367,        0.03038194464975052354,
                                0.04464285713950676724,        0.07500000000002855978,
                                0.1666666666666665708,         1.0};
  Lanes p = all(0.03357714694742870201);
  for (const double c : kSeries) p = p * z + all(c);
  return p;
}

// Of -1 .. 1.
STILLCUT_INLINE Lanes arcCosine(Lanes c) {
  constexpr double kPi = 3.14159265358979323846;
  const Lanes zero = all(0.0);
  const Choices negative = c < zero;
  const Lanes size = pick(negative, zero - c, c);
  const Choices large = all(0.5) < size;
  const Lanes z = pick(large, all(0.5) * (all(1.0) - size), size * size);
  const Lanes x = pick(large, root(z), size);
  const Lanes sine = x * arcSineSeries(z);
  const Lanes angle = pick(large, sine + sine, all(0.5 * kPi) - sine);
  return pick(negative, all(kPi) - angle, angle);
}

}  // namespace

void operatorSums(const OperatorRun& run) noexcept {
  Lanes signal = all(0.0);
  Lanes difference = all(0.0);
  std::size_t k = 0;
  for (; k + kLanes <= run.frames; k += kLanes) {
    const Operators now = operators(run.first + k, run.lag);
    signal = signal + now.signal;
    difference = difference + now.difference;
  }
  if (k < run.frames) {
    constexpr double kIndex[kLanes] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
    const Choices used = load(kIndex) < all(static_cast<double>(run.frames - k));
    const Operators last = operators(run.first + k, run.lag);
    signal = signal + pick(used, last.signal, all(0.0));
    difference = difference + pick(used, last.difference, all(0.0));
  }
  *run.signal += total(signal);
  *run.difference += total(difference);
}

void separate(const SeparationRun& run) noexcept {
  const Lanes zero = all(0.0);
  const Lanes one = all(1.0);
  for (std::size_t n = 0; n < run.lanes; n += kLanes) {
    const Lanes signal = load(run.signal + n);
    const Lanes cosine = one - load(run.difference + n) / (all(4.0) * signal);
    const Lanes sine2 = one - cosine * cosine;
    const Choices valid = (zero < signal) & (all(kLeastSine2) < sine2);  // a sum that is not a number is not valid
    const Lanes power = signal / (all(run.frames) * sine2);
    store(run.frequency + n, pick(valid, arcCosine(cosine) * load(run.scale + n), load(run.frequency + n)));
    store(run.power + n, pick(valid, power, load(run.power + n)));
    store(run.valid + n, pick(valid, one, zero));
    store(run.signal + n, zero);
    store(run.difference + n, zero);
  }
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
