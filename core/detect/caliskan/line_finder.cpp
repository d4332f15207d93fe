#include "core/detect/caliskan/line_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/dsp/kernels/choose.h"
#include "core/dsp/order.h"
#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

constexpr std::size_t kPlaces = 4;  // to a bin: a parabola through three then errs by a thousandth of a bin
// Half width of what counts as the line: twice a Hann lobe, since a line that grows fast is broad.
constexpr double kLobe = 4.0;  // of 1 / window
constexpr std::size_t kTaps = 16;
constexpr std::size_t kHalfTaps = kTaps / 2;
constexpr double kSameBins = 2.0;  // within which a side line is where it should be
// In power, over the mean of what is beside it. A bin of noise reaches nine times its mean once in 8000, and half way
// between two orders the turn difference makes 2.7 times the mean of it.
constexpr double kStandsOut = 24.0;
// ... and exactly there: a line that stands out so is known to a tenth of a bin, one that has nothing to do with it
// lies anywhere within the two.
constexpr double kInPlaceBins = 0.25;
constexpr double kOtherLine = 4.0;  // a line this much stronger than the one followed takes its place
constexpr double kScalloped = 0.7;  // of a line's power that a bin half way beside it holds at least

using Taps = std::array<std::array<double, kTaps>, kPlaces>;

// Taps of the bins b - 7 .. b + 8 for the places of bin b. The signs move time's origin into the middle of the period.
Taps makeTaps() {
  Taps taps{};
  for (std::size_t p = 1; p < kPlaces; ++p) {
    const double part = static_cast<double>(p) / kPlaces;
    for (std::size_t k = 0; k < kTaps; ++k) {
      const double t = static_cast<double>(k) - (kHalfTaps - 1.0) - part;
      const double window = std::cos(std::numbers::pi * t / (kTaps + 1));
      const double sinc = std::sin(std::numbers::pi * t) / (std::numbers::pi * t);
      taps[p][k] = (k % 2 == 0 ? 1.0 : -1.0) * sinc * window * window;
    }
  }
  return taps;
}

const Taps kInterpolation = makeTaps();

// |X|^2 at a place of one channel's transform.
double powerAt(std::span<const std::complex<double>> bins, std::size_t place) {
  const std::size_t b = place / kPlaces;
  const std::size_t part = place % kPlaces;
  if (part == 0) return std::norm(bins[b]);
  const std::array<double, kTaps>& taps = kInterpolation[part];
  std::complex<double> value = 0.0;
  if (b + 1 >= kHalfTaps && b + kHalfTaps < bins.size()) {
    const std::complex<double>* from = bins.data() + (b + 1 - kHalfTaps);
    for (std::size_t k = 0; k < kTaps; ++k) value += taps[k] * from[k];
    return std::norm(value);
  }
  const auto last = static_cast<std::ptrdiff_t>(bins.size()) - 1;
  for (std::size_t k = 0; k < kTaps; ++k) {  // beyond either end stands the mirror image
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(b + k + 1) - static_cast<std::ptrdiff_t>(kHalfTaps);
    const bool mirrored = i < 0 || i > last;
    const std::complex<double> x = bins[static_cast<std::size_t>(i < 0 ? -i : i > last ? 2 * last - i : i)];
    value += taps[k] * (mirrored ? std::conj(x) : x);
  }
  return std::norm(value);
}

}  // namespace

void LineFinder::prepare(int channels, int window, Hertz rate) {
  kernels_ = dsp::kernels::bestKernels();
  window_ = static_cast<std::size_t>(window);
  channels_.clear();
  channels_.resize(static_cast<std::size_t>(channels));
  for (SpectrumChannel& c : channels_) {
    c.ring.assign(window_, 0.0);
    c.spectrum.prepare(window, rate, dsp::WindowKind::Recent, dsp::fastFftSize(window + (window + 7) / 8));
  }
  const auto bins = static_cast<std::size_t>(channels_.front().spectrum.bins());
  lobe_ = static_cast<std::size_t>(std::lround(kLobe * kPlaces * rate.value / (window * binWidth())));
  for (auto* v : {&power_, &now_}) v->assign(bins, 0.0);
  reset();
}

void LineFinder::reset() {
  for (SpectrumChannel& c : channels_) std::fill(c.ring.begin(), c.ring.end(), 0.0);
  head_ = seen_ = 0;
  asked_ = false;
}

void LineFinder::push(const double* rest, std::ptrdiff_t stride, std::size_t frames) {
  for (std::size_t done = 0; done < frames;) {
    const std::size_t now = std::min(frames - done, window_ - head_);
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      std::copy_n(rest + static_cast<std::ptrdiff_t>(c) * stride + done, now, channels_[c].ring.data() + head_);
    }
    head_ = head_ + now == window_ ? 0 : head_ + now;
    done += now;
  }
  seen_ = std::min(seen_ + frames, window_);
  asked_ = false;
}

void LineFinder::transform(std::size_t first, std::size_t last) {
  std::fill(power_.begin(), power_.end(), 0.0);
  for (SpectrumChannel& c : channels_) {
    const std::span<const double> ring(c.ring);
    c.spectrum.transform(ring.subspan(head_), ring.first(head_));
    c.spectrum.powers(now_);
    const double total = kernels_.sum(now_.data() + first, last + 1 - first);
    c.share = total > 0.0 ? 1.0 / total : 0.0;
    if (total > 0.0) kernels_.addScaled(c.share, now_.data() + first - 1, power_.data() + first - 1, last - first + 3);
  }
}

double LineFinder::power(std::size_t place) const {
  double all = 0.0;
  for (const SpectrumChannel& c : channels_) {
    if (c.share > 0.0) all += c.share * powerAt(c.spectrum.values(), place);
  }
  return all;
}

std::size_t LineFinder::highest(std::size_t from, std::size_t to) const {
  std::size_t place = from;
  double most = power(from);
  for (std::size_t p = from + 1; p <= to; ++p) {
    const double now = power(p);
    if (now <= most) continue;
    most = now;
    place = p;
  }
  return place;
}

FoundLine LineFinder::find(Hertz low, Hertz high) {
  if (asked_ && low == low_ && high == high_) return found_;
  asked_ = true;
  low_ = low;
  high_ = high;
  found_ = look(low, high);
  return found_;
}

FoundLine LineFinder::look(Hertz low, Hertz high) {
  FoundLine found;
  if (2 * seen_ < window_) return found;
  const auto first = static_cast<std::size_t>(std::max(1.0, std::ceil(low.value / binWidth())));
  const auto last = std::min(static_cast<std::size_t>(high.value / binWidth()), power_.size() - 2);
  if (first >= last) return found;
  transform(first, last);
  const std::span<const double> inReach = std::span<const double>(power_).subspan(first, last + 1 - first);
  const double whole = kernels_.sum(inReach.data(), inReach.size());
  if (!(whole > 0.0)) return found;
  // Between the bins a line may be higher than any bin says.
  const double top = kernels_.largest(inReach.data(), inReach.size());
  std::size_t peak = first * kPlaces;
  double most = 0.0;
  for (std::size_t b = first; b <= last; ++b) {
    if (power_[b] < kScalloped * top || (b > first && power_[b - 1] > power_[b]) ||
        (b < last && power_[b + 1] > power_[b])) {
      continue;
    }
    const std::size_t place = highest(std::max(first, b - 1) * kPlaces, std::min(last, b + 1) * kPlaces);
    const double height = power(place);
    if (height <= most) continue;
    most = height;
    peak = place;
  }
  double line = 0.0;
  const std::size_t right = std::min(last * kPlaces, peak + lobe_);
  for (std::size_t p = std::max(first * kPlaces, peak - std::min(peak, lobe_)); p <= right; ++p) line += power(p);
  found.frequency = refined(peak);
  if (tooth_.value > 0.0) choose(found);
  found.purity = std::min(line / (kPlaces * whole), 1.0);
  return found;
}

// A line above the noise beside it.
bool LineFinder::standsOut(const Peak& peak) const {
  const auto middle = static_cast<std::ptrdiff_t>(std::lround(peak.frequency.value / binWidth()));
  const auto lobe = static_cast<std::ptrdiff_t>(lobe_ / kPlaces + 1);
  double sum = 0.0;
  int bins = 0;
  for (std::ptrdiff_t b = middle - 3 * lobe; b <= middle + 3 * lobe; ++b) {
    if (b < 1 || b >= static_cast<std::ptrdiff_t>(power_.size()) || std::abs(b - middle) <= lobe) continue;
    sum += power_[static_cast<std::size_t>(b)];
    ++bins;
  }
  return peak.power * bins > kStandsOut * sum;
}

// Lines that stand out, where the line itself and its side lines have to be: use(peak, place).
template <class Use>
void LineFinder::eachSideLine(Hertz line, Hertz tooth, const Use& use) const {
  const double offset = std::abs(dsp::orderOffset(line, tooth));
  for (int k = 0; tooth.value * (k - offset) < high_.value; ++k) {
    for (const double order : {k - offset, k + offset}) {
      const Hertz place = tooth * order;
      if (place < low_ || high_ < place) continue;
      const Peak peak = near(place, Hertz(kSameBins * binWidth()));
      if (standsOut(peak)) use(peak, place);
    }
  }
}

// An integral takes 1 / f of each line's amplitude: undone by f^2 in power, which makes more of the noise as well.
void LineFinder::choose(FoundLine& found) const {
  double most = 0.0;
  double all = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  const Hertz strongest = found.frequency;
  eachSideLine(strongest, tooth_, [&](const Peak& peak, Hertz) {
    const double f = peak.frequency.value;
    const double force = peak.power * (integrals_ ? f * f : 1.0);
    all += force;
    sum += force * f;
    squares += force * f * f;
    if (force <= most) return;
    most = force;
    found.frequency = peak.frequency;
  });
  const double away = all > 0.0 ? found.frequency.value - sum / all : 0.0;
  const double variance = all > 0.0 ? squares / all - (sum / all) * (sum / all) : 0.0;
  found.spread = Hertz(std::sqrt(std::max(variance, 0.0) + away * away));
}

int LineFinder::sideLines(Hertz line, Hertz toothPassing) const {
  if (!asked_ || !(toothPassing.value > 0.0)) return 0;
  const double width = binWidth();
  int lines = 0;
  double last = 0.0;  // half way between two tooth passings a line is the mirror image of the one before as well
  eachSideLine(line, toothPassing, [&](const Peak& peak, Hertz place) {
    const bool itself = std::abs(peak.frequency.value - line.value) < kSameBins * width;
    const bool counted = std::abs(peak.frequency.value - last) < kSameBins * width;
    if (itself || counted || std::abs(peak.frequency.value - place.value) > kInPlaceBins * width) return;
    last = peak.frequency.value;
    ++lines;
  });
  return lines;
}

Hertz LineFinder::refined(std::size_t place) const {
  const double shift = peakShift(power(place - 1), power(place), power(place + 1));
  return Hertz((static_cast<double>(place) + shift) * binWidth() / kPlaces);
}

LineFinder::Peak LineFinder::near(Hertz middle, Hertz reach) const {
  const double width = binWidth() / kPlaces;
  const double low = std::max(1.0, std::ceil((middle.value - reach.value) / width));
  const double high =
      std::min((middle.value + reach.value) / width, static_cast<double>((power_.size() - 1) * kPlaces) - 2.0);
  if (!(low < high)) return {};
  const std::size_t peak = highest(static_cast<std::size_t>(low), static_cast<std::size_t>(high));
  const double height = power(peak);
  if (height < power(peak - 1) || height < power(peak + 1)) return {};
  return {refined(peak), height};
}

Hertz LineFinder::keep(Hertz followed, Hertz strongest, Hertz reach) const {
  if (std::abs(strongest.value - followed.value) <= reach.value) return strongest;
  const Peak held = near(followed, reach);
  return near(strongest, reach).power < kOtherLine * held.power ? held.frequency : strongest;
}

}  // namespace stillcut::detect
