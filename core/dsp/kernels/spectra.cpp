// Bin by bin: plain loops that the compiler turns into lanes without changing a sum. Sums are lanes by hand.
#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

constexpr std::size_t kSmooth = 2;  // bins to either side

// exp for -1.68 .. 0: Chebyshev fit about the middle, good to 1e-18.
STILLCUT_INLINE Lanes expOfSmall(Lanes x) {
  constexpr double kMiddle = 0.84;
  constexpr double kExpMiddle = 0.431710523429079693;
  constexpr double kEven[] = {
      4.828812813540571783e-14, 1.147010602799005194e-11, 2.087676138366418269e-9, 2.755731920678476175e-7,
      2.480158730162547791e-5,  1.388888888888884396e-3,  4.16666666666666669e-2,  0.5};
  constexpr double kOdd[] = {
      7.73601567135906691e-13, 1.605789178401563565e-10, 2.505211630424266158e-8, 2.755731919299741223e-6,
      1.984126984133861943e-4, 8.333333333333252391e-3,  1.666666666666666709e-1, 1.0};
  // Even and odd powers side by side: half the wait.
  const Lanes t = x + all(kMiddle);
  const Lanes t2 = t * t;
  Lanes even = all(kEven[0]);
  Lanes odd = all(kOdd[0]);
  for (std::size_t i = 1; i < 8; ++i) {
    even = even * t2 + all(kEven[i]);
    odd = odd * t2 + all(kOdd[i]);
  }
  even = even * t2 + all(1.0);
  return (even + odd * t) * all(kExpMiddle);
}

STILLCUT_INLINE Lanes sharpened(const SharpenRun& run, const double* g) {
  const Lanes mean = (((load(g - 2) + load(g - 1)) + load(g)) + load(g + 1) + load(g + 2)) * all(0.2);
  const Choices high = all(run.knee) < mean;
  const Lanes rest = mean - all(1.0);
  const Lanes e = expOfSmall(pick(high, rest * all(1.0 / run.above), rest * all(1.0 / run.below)));
  return pick(high, e, all(run.factor) * e);
}

// The largest value of each lane and where it stood first.
struct Tops {
  Lanes value = all(0.0);
  Lanes place = all(0.0);
  STILLCUT_INLINE void see(Tops& t, Lanes value, Lanes place) {
    const Choices more = t.value < value;
    t.value = pick(more, value, t.value);
    t.place = pick(more, place, t.place);
  }
};
constexpr double kIndex[kLanes] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};

STILLCUT_INLINE std::size_t fewer(std::size_t a, std::size_t b) {
  return a < b ? a : b;
}

// Whole lanes of a mask, whatever its first and last bin.
template <bool kSpreads>
STILLCUT_INLINE void maskReach(const MaskRun& run, std::size_t begin, std::size_t end) {
  const Lanes whole = all(6755399441055744.0);  // 1.5 * 2^52: adding it rounds to whole numbers
  const Lanes spacing = all(run.spacing);
  const Lanes perBin = all(1.0 / run.spacing);
  const Lanes most = all(0.45 * run.spacing);
  const Lanes half = all(run.halfWidth);
  const Lanes least = pick(most < half, most, half);
  Lanes square = least * least;
  Lanes bin = load(kIndex) + all(static_cast<double>(begin));
  for (std::size_t b = begin; b < end; b += kLanes) {
    const Lanes order = (bin * perBin + whole) - whole;
    const Lanes offset = bin - order * spacing;
    if constexpr (kSpreads) {
      const Lanes wanted = half + all(run.spread) * order;
      const Lanes width = pick(most < wanted, most, wanted);
      square = width * width;
    }
    store(run.free + b, pick(offset * offset < square, all(0.0), all(1.0)));
    bin = bin + all(static_cast<double>(kLanes));
  }
}

// Square root to 1e-10, from the bits of 1 / root by three steps of Newton's: a fifth of what the exact one takes.
STILLCUT_INLINE Lanes nearRoot(Lanes x) {
  using Bits [[gnu::vector_size(8 * STILLCUT_NATIVE)]] = unsigned long long;
  Lanes y = each([&](std::size_t i) {
    return reinterpret_cast<Native>(0x5FE6EB50C7B537A9ULL - (reinterpret_cast<Bits>(x.part[i]) >> 1));
  });
  const Lanes half = x * all(0.5);
  for (int step = 0; step < 3; ++step) y = y * (all(1.5) - half * y * y);
  return pick(x < all(1e-280), all(0.0), x * y);
}

STILLCUT_INLINE void largest(const Tops& tops, double& top, std::size_t& place) {
  double values[kLanes];
  double places[kLanes];
  store(values, tops.value);
  store(places, tops.place);
  top = 0.0;
  place = 0;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const auto here = static_cast<std::size_t>(places[l]);
    if (!(top < values[l]) && !(top == values[l] && top > 0.0 && here < place)) continue;
    top = values[l];
    place = here;
  }
}

}  // namespace

void multiply(const double* __restrict a, const double* __restrict b, double* __restrict out, std::size_t n) noexcept {
  for (std::size_t i = 0; i < n; ++i) out[i] = a[i] * b[i];
}

double sum(const double* x, std::size_t n) noexcept {
  Lanes sums[2] = {};
  std::size_t i = 0;
  for (; i + 2 * kLanes <= n; i += 2 * kLanes) {
    sums[0] = sums[0] + load(x + i);
    sums[1] = sums[1] + load(x + i + kLanes);
  }
  double all = total(sums[0] + sums[1]);
  for (; i < n; ++i) all += x[i];
  return all;
}

double largest(const double* x, std::size_t n) noexcept {
  Lanes most = all(0.0);
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    const Lanes now = load(x + i);
    most = pick(most < now, now, most);
  }
  double lanes[kLanes];
  store(lanes, most);
  double top = 0.0;
  for (const double one : lanes) top = top < one ? one : top;
  for (; i < n; ++i) top = top < x[i] ? x[i] : top;
  return top;
}

void addScaled(double scale, const double* __restrict a, double* __restrict out, std::size_t n) noexcept {
  for (std::size_t i = 0; i < n; ++i) out[i] += scale * a[i];
}

void squares(const double* __restrict z, double* __restrict out, std::size_t n) noexcept {
  for (std::size_t i = 0; i < n; ++i) out[i] = z[2 * i] * z[2 * i] + z[2 * i + 1] * z[2 * i + 1];
}

void unfold(const UnfoldRun& run) noexcept {
  const double* z = run.folded;
  run.out[0] = z[0] + z[1];
  run.out[1] = 0.0;
  run.out[2 * run.n] = z[0] - z[1];
  run.out[2 * run.n + 1] = 0.0;
  std::size_t k = 1;
  const Lanes half = all(0.5);
  // Up to the middle from both ends; the last ones may go past each other.
  for (; 2 * k <= run.n && k + kLanes <= run.n; k += kLanes) {
    const std::size_t mirror = run.n - k - (kLanes - 1);
    const ComplexLanes low = loadComplex(z + 2 * k);
    const ComplexLanes up = loadComplex(z + 2 * mirror);
    const ComplexLanes high{reversed(up.re), reversed(up.im)};
    const Lanes c = load(run.rotationRe + k);
    const Lanes s = load(run.rotationIm + k);
    const Lanes evenRe = half * (low.re + high.re);
    const Lanes evenIm = half * (low.im - high.im);
    const Lanes oddRe = low.im + high.im;
    const Lanes oddIm = high.re - low.re;
    const Lanes re = c * oddRe - s * oddIm;
    const Lanes im = c * oddIm + s * oddRe;
    storeComplex(run.out + 2 * mirror, {reversed(evenRe - re), reversed(im - evenIm)});
    storeComplex(run.out + 2 * k, {evenRe + re, evenIm + im});
  }
  for (; 2 * k <= run.n; ++k) {
    const double* low = z + 2 * k;
    const double* high = z + 2 * (run.n - k);
    const double evenRe = 0.5 * (low[0] + high[0]);
    const double evenIm = 0.5 * (low[1] - high[1]);
    const double oddRe = low[1] + high[1];
    const double oddIm = high[0] - low[0];
    const double re = run.rotationRe[k] * oddRe - run.rotationIm[k] * oddIm;
    const double im = run.rotationRe[k] * oddIm + run.rotationIm[k] * oddRe;
    run.out[2 * (run.n - k)] = evenRe - re;
    run.out[2 * (run.n - k) + 1] = im - evenIm;
    run.out[2 * k] = evenRe + re;
    run.out[2 * k + 1] = evenIm + im;
  }
}

void maskHarmonics(const MaskRun& run) noexcept {
  const std::size_t begin = fewer(run.first, run.bins) / kLanes * kLanes;
  const std::size_t end = run.last < run.first ? begin : fewer(wholeLanes(run.last + 1), run.bins);
  for (std::size_t b = 0; b < begin; b += kLanes) store(run.free + b, all(0.0));
  for (std::size_t b = end; b < run.bins; b += kLanes) store(run.free + b, all(0.0));
  if (run.spread > 0.0) {
    maskReach<true>(run, begin, end);
  } else {
    maskReach<false>(run, begin, end);
  }
  for (std::size_t b = begin; b < end && b < run.first; ++b) run.free[b] = 0.0;
  for (std::size_t b = run.last + 1; b < end; ++b) run.free[b] = 0.0;
}

void scanLines(LineScan& scan) noexcept {
  const Lanes zero = all(0.0);
  Lanes sum = zero;
  Lanes free = zero;
  Lanes forced = zero;
  Tops tops;
  std::size_t b = scan.first;
  for (; b + kLanes <= scan.last + 1; b += kLanes) {
    const Lanes p = load(scan.power + b);
    const Lanes f = load(scan.free + b) * p;
    sum = sum + p;
    free = free + f;
    forced = forced + (p - f) * load(scan.weight + b);
    const Choices below = (p < load(scan.power + b - 1)) | (p < load(scan.power + b + 1));
    Tops::see(tops, pick(below, zero, f), load(kIndex) + all(static_cast<double>(b)));
  }
  scan.sum = total(sum);
  scan.freeSum = total(free);
  scan.forcedSum = total(forced);
  largest(tops, scan.top, scan.place);
  for (; b <= scan.last; ++b) {
    const double p = scan.power[b];
    const double f = scan.free[b] * p;
    scan.sum += p;
    scan.freeSum += f;
    scan.forcedSum += (p - f) * scan.weight[b];
    if (p < scan.power[b - 1] || p < scan.power[b + 1] || !(scan.top < f)) continue;
    scan.top = f;
    scan.place = b;
  }
}

void scanCross(CrossScan& scan) noexcept {
  Lanes free = all(0.0);
  Lanes high = all(0.0);
  Tops tops;
  std::size_t b = scan.first;
  for (; b + kLanes <= scan.last + 1; b += kLanes) {
    const Lanes f = load(scan.free + b);
    const Lanes size = f * load(scan.cross + b);
    const Lanes ratio = f * load(scan.ratio + b);
    free = free + size;
    high = pick(high < ratio, ratio, high);
    Tops::see(tops, size * ratio, load(kIndex) + all(static_cast<double>(b)));
  }
  scan.freeSum = total(free);
  largest({high, high}, scan.largestRatio, scan.place);
  largest(tops, scan.top, scan.place);
  for (; b <= scan.last; ++b) {
    const double size = scan.free[b] * scan.cross[b];
    const double ratio = scan.free[b] * scan.ratio[b];
    scan.freeSum += size;
    if (scan.largestRatio < ratio) scan.largestRatio = ratio;
    if (!(scan.top < size * ratio)) continue;
    scan.top = size * ratio;
    scan.place = b;
  }
}

void coherence(const CoherenceRun& run) noexcept {
  const Lanes part = all(run.part);
  const Lanes imaginary = all(run.welch ? 1.0 : 0.0);
  const Lanes zero = all(0.0);
  const Lanes one = all(1.0);
  const auto follow = [part](double* mean, Lanes now) {
    const Lanes before = load(mean);
    const Lanes after = before + part * (now - before);
    store(mean, after);
    return after;
  };
  for (std::size_t b = 0; b < run.bins; b += kLanes) {
    const ComplexLanes x = loadComplex(run.x + 2 * b);
    const ComplexLanes y = loadComplex(run.y + 2 * b);
    const Lanes both = follow(run.gx + b, x.re * x.re + x.im * x.im) * follow(run.gy + b, y.re * y.re + y.im * y.im);
    const Lanes re = follow(run.crossRe + b, x.re * y.re + x.im * y.im);
    const Lanes im = follow(run.crossIm + b, x.re * y.im - x.im * y.re);
    const Lanes quotient = (re * re + imaginary * (im * im)) / both;
    const Choices some = zero < both;
    store(run.coherence + b, pick(some, pick(quotient < one, quotient, one), zero));
    store(run.cross + b, nearRoot(re * re + im * im));
  }
}

void sharpen(const SharpenRun& run) noexcept {
  if (run.bins < 2 * kSmooth + 1) return;
  const std::size_t end = run.bins - kSmooth;
  std::size_t b = kSmooth;
  for (; b + kLanes <= end; b += kLanes) {
    store(run.out + b, sharpened(run, run.coherence + b) * load(run.weight + b));
  }
  if (b == end) return;
  // The last few once more in a row of their own.
  double g[kLanes + 2 * kSmooth] = {};
  double out[kLanes];
  for (std::size_t i = b - kSmooth; i < run.bins; ++i) g[i - (b - kSmooth)] = run.coherence[i];
  store(out, sharpened(run, g + kSmooth));
  for (std::size_t i = b; i < end; ++i) run.out[i] = out[i - b] * run.weight[i];
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
