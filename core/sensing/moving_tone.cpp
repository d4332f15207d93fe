#include "core/sensing/moving_tone.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/fft.h"
#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

constexpr double kEnough = 6000.0;   // Hz: drives are heard below 2 kHz
constexpr double kHop = 0.125;       // of a window
constexpr double kRose = 8.0;        // 9 dB above what the bin had before
constexpr double kForgets = 0.15;    // s, time constant of what a bin had: a turn of a slow spindle, half a feed move
constexpr double kLeastPart = 2e-3;  // of all power: less makes no alarm
constexpr double kOnLine = 0.6;      // bins, rms, from the straight line
constexpr std::size_t kFewest = 12;  // places on a line
constexpr std::size_t kFewestAtEntry = 27;
constexpr double kPresent = 0.75;  // of them
constexpr double kStill = 0.25;    // bins, from hop to hop
constexpr double kBeside = 100.0;  // Hz, from where it was seen last
constexpr int kStands = 8;         // hops within a bin
constexpr int kGone = 16;          // hops without a place: two windows, the newest holds none of the glide
constexpr double kLowest = 60.0;   // Hz: two bins

}  // namespace

void MovingTone::prepare(Hertz rate) {
  average_ = std::max(1, static_cast<int>(rate.value / kEnough));
  rate_ = rate.value / average_;
  const int window = dsp::fastFftSize(std::max(32, static_cast<int>(kWindow.value * rate_)));
  hop_ = std::max<std::size_t>(1, static_cast<std::size_t>(kHop * window));
  heard_.prepare(1, window);
  spectrum_.prepare(window, Hertz(rate_), dsp::WindowKind::Hann);
  const auto bins = static_cast<std::size_t>(spectrum_.bins());
  for (auto* powers : {&powers_, &before_, &start_}) powers->assign(bins, 0.0);
  delayed_.assign(kDelay * bins, 0.0);
  reset();
}

void MovingTone::reset() noexcept {
  heard_.reset();
  since_ = looks_ = 0;
  averaged_ = 0;
  sum_ = 0.0;
  for (auto* values : {&powers_, &before_, &start_, &delayed_}) std::fill(values->begin(), values->end(), 0.0);
  places_ = {};
  gliding_ = arrived_ = false;
  still_ = gone_ = 0;
  frequency_ = {};
}

bool MovingTone::takeArrived() noexcept {
  const bool arrived = arrived_;
  arrived_ = false;
  return arrived;
}

double MovingTone::power(Hertz frequency) const noexcept {
  const double place = frequency.value / spectrum_.binWidth();
  const auto bin = static_cast<std::size_t>(std::clamp(std::lround(place), 1L, static_cast<long>(powers_.size()) - 2));
  return std::max({powers_[bin - 1], powers_[bin], powers_[bin + 1]});
}

void MovingTone::push(std::span<const double> x, bool entering) noexcept {
  entering_ = entering;
  for (const double v : x) {
    sum_ += v;
    if (++averaged_ < average_) continue;
    add(sum_ / average_);
    averaged_ = 0;
    sum_ = 0.0;
  }
}

void MovingTone::add(double x) noexcept {
  heard_.push(&x, 0, 1);
  if (++since_ < hop_) return;
  since_ = 0;
  if (heard_.full()) look();
}

void MovingTone::look() noexcept {
  spectrum_.transform(heard_.newest(0));
  spectrum_.powers(powers_);
  std::rotate(places_.begin(), places_.begin() + 1, places_.end());
  places_.back() = looks_ >= 2 * kDelay ? strongestAbove(before_, kLowest, rate_) : 0.0;
  remember();
  ++looks_;
  if (gliding_) return follow();
  for (std::size_t n = entering_ ? kFewestAtEntry : kFewest; n <= kPlaces && !gliding_; n += n / 2)
    gliding_ = onTheWay(n, kLeastWay);
  if (!gliding_) return;
  arrived_ = false;
  still_ = gone_ = 0;
  frequency_ = Hertz(*std::find_if(places_.rbegin(), places_.rend(), [](double place) { return place > 0.0; }));
  start_ = before_;
}

// Until it stands, or cannot be seen any more: then it may have come to stand where a harmonic was before.
void MovingTone::follow() noexcept {
  const double here = places_.back();
  gone_ = here > 0.0 ? 0 : gone_ + 1;
  still_ = here > 0.0 && std::abs(here - frequency_.value) < kStill * spectrum_.binWidth() ? still_ + 1 : 0;
  if (here > 0.0) frequency_ = Hertz(here);
  arrived_ = still_ >= kStands;
  if (gone_ >= kGone) {
    const double found = strongestAbove(start_, frequency_.value - kBeside, frequency_.value + kBeside);
    arrived_ = found > 0.0;
    if (arrived_) frequency_ = Hertz(found);
  }
  gliding_ = !arrived_ && gone_ < kGone;
  if (!gliding_) places_ = {};
}

// Hz, between bins; 0: nothing there rose.
double MovingTone::strongestAbove(std::span<const double> before, double from, double to) const noexcept {
  const double width = spectrum_.binWidth();
  const auto first = static_cast<std::size_t>(std::ceil(std::max(kLowest, from) / width));
  const auto last = std::min(powers_.size() - 1, static_cast<std::size_t>(std::max(0.0, to) / width));
  double all = 0.0;
  double most = 0.0;
  std::size_t at = 0;
  for (std::size_t b = 1; b + 1 < powers_.size(); ++b) all += powers_[b];
  for (std::size_t b = first; b < last; ++b) {
    if (powers_[b] < kRose * before[b] || powers_[b] <= most) continue;
    most = powers_[b];
    at = b;
  }
  if (at == 0 || most < kLeastPart * all) return 0.0;
  return (static_cast<double>(at) + peakShift(powers_[at - 1], powers_[at], powers_[at + 1])) * width;
}

Hertz MovingTone::lineNear(Hertz frequency) const noexcept {
  const double around = 2.0 * spectrum_.binWidth();
  const double found = strongestAbove(start_, frequency.value - around, frequency.value + around);
  return found > 0.0 ? Hertz(found) : frequency;
}

void MovingTone::remember() noexcept {
  const std::size_t bins = powers_.size();
  double* row = delayed_.data() + (looks_ % kDelay) * bins;
  const double keeps = std::exp(-static_cast<double>(hop_) / rate_ / kForgets);
  for (std::size_t b = 0; b < bins; ++b) {
    before_[b] = std::max(keeps * before_[b], row[b]);
    row[b] = powers_[b];
  }
}

// The last places, on one straight line that is steep enough, and so far. Where the tone passes a harmonic of the
// spindle nothing rises: a quarter of the places may be absent.
bool MovingTone::onTheWay(std::size_t places, double way) const noexcept {
  double n = 0.0, t = 0.0, f = 0.0, tt = 0.0, tf = 0.0, ff = 0.0;
  for (std::size_t i = 0; i < places; ++i) {
    const double place = places_[kPlaces - places + i];
    if (!(place > 0.0)) continue;
    const auto time = static_cast<double>(i);
    n += 1.0;
    t += time;
    f += place;
    tt += time * time;
    tf += time * place;
    ff += place * place;
  }
  if (n < static_cast<double>(kFewest) || n < kPresent * static_cast<double>(places)) return false;
  const double squares = tt - t * t / n;
  const double product = tf - t * f / n;
  const double slope = product / squares;  // Hz a hop
  const double error = std::max(0.0, ff - f * f / n - slope * product) / n;
  const double rate = slope * rate_ / static_cast<double>(hop_);
  const double gone = slope * static_cast<double>(places - 1);
  return std::abs(rate) > kLeastRate && std::abs(gone) > way && std::sqrt(error) < kOnLine * spectrum_.binWidth();
}

}  // namespace stillcut::detect
