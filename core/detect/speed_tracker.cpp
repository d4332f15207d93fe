#include "core/detect/speed_tracker.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kQuickTurns = 12.0;
constexpr double kThoroughTurns = 24.0;
constexpr double kSlowestHertz = 8.0;    // without a told speed: 480 rev/min ...
constexpr double kFastestHertz = 500.0;  // ... to 30 000 rev/min
// A comb that carries half of all power needs no other proof; a weaker one must stand out of all other combs. In air
// and on machine noise the contrast stays below 2, on cuts it is 3 to 80.
constexpr double kClearPart = 0.5;
constexpr double kLeastPart = 0.1;
constexpr double kContrast = 3.0;
constexpr double kAgreement = 1.5e-3;   // two windows in a row say the same speed
constexpr double kMoved = 2.5e-3;       // a lock this far off a better comb is given up ...
constexpr double kBetter = 2.0;         // ... if that comb carries so much more
constexpr double kMargin = 1.2;         // past the stated doubt, so that its end is still a peak
constexpr double kMachineRange = 0.01;  // a measured speed is better than a programmed one
constexpr double kSameSpeed = 1e-4;     // a read-back that moves less did not move
constexpr double kRecentSeconds = 0.05;
constexpr double kRide = 2e-3;    // from the mean of the recent past: faster than the phases can be followed
constexpr double kMoving = 1e-2;  // ... than turns can be compared
constexpr double kArrived = 1e-3;
constexpr double kRideSd = 1e-3;  // of a speed taken from the machine, once its ratio to the truth is known
constexpr int kRideFrames = 16;   // a speed that changes does so in steps this long

}  // namespace

void SpeedTracker::prepare(const CutSetup& setup, double searchRange) {
  rate_ = setup.rate.value;
  range_ = searchRange;
  nominal_ = toHertz(setup.nominalSpeed).value;
  channels_ = std::clamp(static_cast<int>(setup.channels.size()), 1, kSearchChannels);
  const double slowest = nominal_ > 0.0 ? nominal_ * (1.0 - kMargin * range_) : kSlowestHertz;
  const int window = std::clamp(static_cast<int>(kThoroughTurns * rate_ / slowest), 256, 1 << 19);
  thorough_.search.prepare(window, setup.rate, setup.teeth);
  quick_.search.prepare(std::max(128, static_cast<int>(window * kQuickTurns / kThoroughTurns)), setup.rate,
                        setup.teeth);
  tracker_.prepare(channels_, setup.rate, setup.teeth);
  for (auto& ring : ring_) ring.assign(static_cast<std::size_t>(window), 0.0);
  unrolled_.assign(static_cast<std::size_t>(window), 0.0);
  reset();
}

void SpeedTracker::reset() noexcept {
  told_ = before_ = recent_ = nominal_;
  measured_ = riding_ = moving_ = false;
  ratio_ = 1.0;
  source_ = nominal_ > 0.0 ? SpeedSource::Told : SpeedSource::None;
  locked_ = proven_ = false;
  toothPart_ = 0.0;
  angle_ = 0.0;
  restart();
  tracker_.start(Hertz(told_), Hertz(told_ * range_));
}

void SpeedTracker::restart() noexcept {
  catchUp_ = 0.0;
  forget();
  if (locked_) tracker_.start(spindle(), sd());
}

void SpeedTracker::listen(const MachineState& machine) noexcept {
  double told = nominal_;
  bool measured = false;
  before_ = told_;
  if (machine.valid && machine.linkUp) {
    if (machine.actualSpeed.value > 0.0) {
      told = toHertz(machine.actualSpeed).value;
      measured = true;
    } else if (machine.targetSpeed().value > 0.0) {
      told = toHertz(machine.targetSpeed()).value;
    }
  }
  if (measured != measured_ || !(before_ > 0.0)) before_ = recent_ = told;  // another kind of word, no change of speed
  measured_ = measured;
  if (told_ > 0.0 && std::abs(told / told_ - 1.0) < kSameSpeed) return;
  if (told_ > 0.0 && told > 0.0 && locked_ && !riding_) tracker_.nudge(Hertz(told * ratio_));
  told_ = told;
  if (!locked_) source_ = told > 0.0 ? (measured ? SpeedSource::Machine : SpeedSource::Told) : SpeedSource::None;
}

Hertz SpeedTracker::sd() const noexcept {
  if (locked_) return tracker_.sd();
  return Hertz(told_ * (source_ == SpeedSource::Machine ? kMachineRange : range_));
}

void SpeedTracker::remember(const double* const* samples, int frames) noexcept {
  const std::size_t size = unrolled_.size();
  for (int f = 0; f < frames; ++f) {
    for (int c = 0; c < channels_; ++c) ring_[static_cast<std::size_t>(c)][head_] = samples[c][f];
    head_ = head_ + 1 == size ? 0 : head_ + 1;
  }
}

void SpeedTracker::lock(Hertz spindle, Hertz sd) noexcept {
  locked_ = true;
  if (!(told_ > 0.0)) told_ = spindle.value;
  ratio_ = spindle.value / told_;
  source_ = SpeedSource::Signal;
  tracker_.start(spindle, sd);
  catchUp_ = 0.0;
}

void SpeedTracker::beginCut() noexcept {
  locked_ = proven_ = false;
  toothPart_ = 0.0;
  restart();
}

void SpeedTracker::judge(const Look& look, const SpeedCandidate& before) noexcept {
  const auto good = [](const SpeedCandidate& c) {
    return !c.atEdge && (c.part > kClearPart || (c.part > kLeastPart && c.contrast > kContrast));
  };
  const SpeedCandidate& now = look.last;
  if (!good(now) || !good(before) || std::abs(now.spindle / before.spindle - 1.0) > kAgreement) return;
  if (locked_) {
    // A comb that once carried half of all power was the spindle; what fits better later is chatter.
    if (std::abs(now.spindle / spindle() - 1.0) < kMoved) proven_ = proven_ || now.part > kClearPart;
    if (proven_ || std::abs(now.spindle / spindle() - 1.0) < kMoved) return;
    // Both spectra must prefer the new comb: a chatter line that happens to fit it shows in one of them only.
    const SpeedSearch::Parts here = look.search.partsAt(spindle());
    const SpeedSearch::Parts there = look.search.partsAt(now.spindle);
    if (there.vibration < kBetter * here.vibration || there.square < kBetter * here.square) return;
  }
  toothPart_ = now.toothPart;
  proven_ = now.part > kClearPart;
  lock(now.spindle, Hertz(std::max(now.sd.value, 3e-4 * now.spindle.value)));
}

void SpeedTracker::lookIfDue(Look& look) noexcept {
  const long window = look.search.window();
  if (look.since < window / 4 || inCut_ < window) return;
  look.since = 0;
  look.search.begin();
  const auto size = static_cast<std::ptrdiff_t>(unrolled_.size());
  const auto head = static_cast<std::ptrdiff_t>(head_);
  for (int c = 0; c < channels_; ++c) {
    const auto& ring = ring_[static_cast<std::size_t>(c)];
    std::copy(ring.begin(), ring.begin() + head, std::copy(ring.begin() + head, ring.end(), unrolled_.begin()));
    look.search.add(std::span<const double>(unrolled_).subspan(static_cast<std::size_t>(size - window)));
  }
  const double range = kMargin * (source_ == SpeedSource::Machine ? kMachineRange : range_);
  const Hertz low(told_ > 0.0 ? told_ * (1.0 - range) : kSlowestHertz);
  const Hertz high(told_ > 0.0 ? told_ * (1.0 + range) : std::min(kFastestHertz, rate_ / 16.0));
  const SpeedCandidate before = look.last;
  look.last = look.search.search(low, high);
  judge(look, before);
}

void SpeedTracker::followMachine(double seconds) noexcept {
  if (!(told_ > 0.0) || !measured_) {
    riding_ = moving_ = false;
    return;
  }
  recent_ += (1.0 - std::exp(-seconds / kRecentSeconds)) * (told_ - recent_);
  const double away = std::abs(told_ / recent_ - 1.0);
  moving_ = away > (moving_ ? kArrived : kMoving);
  const bool rode = riding_;
  riding_ = away > (riding_ ? kArrived : kRide);
  if (rode && !riding_ && locked_) tracker_.start(Hertz(told_ * ratio_), Hertz(told_ * kRideSd));
}

void SpeedTracker::ride(int frames, double* angle, double* step) noexcept {
  catchUp_ = 0.0;
  for (int f = 0; f < frames; ++f) {
    if (f % kRideFrames == 0) {
      const double share = std::min(1.0, (f + 0.5 * kRideFrames) / frames);
      step[f] = kTwoPi * ratio_ * (before_ + share * (told_ - before_)) / rate_;
    } else {
      step[f] = step[f - 1];
    }
    angle[f] = angle_;
    angle_ += step[f];
    if (angle_ >= kTwoPi) angle_ -= kTwoPi;
  }
}

// A search over a speed that changes finds nothing.
void SpeedTracker::forget() noexcept {
  inCut_ = 0;
  head_ = 0;
  for (Look* look : {&quick_, &thorough_}) {
    look->last = {};
    look->since = 0;
  }
}

void SpeedTracker::advance(const double* const* samples, int frames, double* angle, double* step) noexcept {
  followMachine(frames / rate_);
  if (riding_) {
    ride(frames, angle, step);
    forget();
    return;
  }
  remember(samples, frames);
  inCut_ += frames;
  quick_.since += frames;
  thorough_.since += frames;
  double omega = locked_ ? kTwoPi * tracker_.spindle().value : kTwoPi * spindle().value;
  double slew = 0.0;
  const auto retime = [&] {
    // Catch up within the next turn; never more than 2 % of the speed, so that the angle stays monotone.
    const double turn = omega > 0.0 ? kTwoPi / omega * rate_ : 1.0;
    slew = std::clamp(catchUp_ / turn, -0.02 * omega / rate_, 0.02 * omega / rate_);
  };
  retime();
  std::complex<double> phasor = std::polar(1.0, angle_);
  std::complex<double> rotation = std::polar(1.0, omega / rate_ + slew);
  for (int f = 0; f < frames; ++f) {
    const double increment = omega / rate_ + slew;
    angle[f] = angle_;
    step[f] = increment;
    if (locked_) tracker_.accumulate(phasor, samples, f);
    angle_ += increment;
    catchUp_ -= slew;
    phasor *= rotation;
    if (angle_ < kTwoPi) continue;
    angle_ -= kTwoPi;
    if (locked_) {
      catchUp_ = tracker_.completeTurn();
      omega = kTwoPi * tracker_.spindle().value;
      if (told_ > 0.0) ratio_ = tracker_.spindle().value / told_;
      retime();
      rotation = std::polar(1.0, omega / rate_ + slew);
    }
    phasor = std::polar(1.0, angle_);
  }
  if (!locked_) lookIfDue(quick_);
  lookIfDue(thorough_);
}

}  // namespace stillcut::detect
