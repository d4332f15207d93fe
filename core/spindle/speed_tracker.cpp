#include "core/spindle/speed_tracker.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kQuickTurns = 12.0;
constexpr double kThoroughTurns = 24.0;
constexpr int kQuickHops = 6;  // looks per window
constexpr int kThoroughHops = 4;
constexpr double kSlowestHertz = 8.0;    // without a told speed: 480 rev/min ...
constexpr double kFastestHertz = 500.0;  // ... to 30 000 rev/min
constexpr double kSeekSeconds = 2.0;     // windows without a told speed, thorough ...
constexpr double kSeekQuickly = 0.25;    // ... and quick, as a part of it
// Where nobody knows the speed, or it has moved: a comb found over such a range must hold most of the power, the same
// in so many windows in a row, and more than the place it was thought to be.
constexpr double kSeekPart = 0.6;
constexpr double kSeekRest = 0.5;  // of what is not in the strongest line
constexpr int kSeekLooks = 3;
constexpr int kReturnLooks = 2;
constexpr double kReturnAgreement = 6e-3;  // it may still be moving
constexpr double kReturnLow = 0.45;        // overrides go from 50 % ...
constexpr double kReturnHigh = 1.3;        // ... to 120 %
constexpr int kReturnTurns = 4;            // after that what was found must be followed cleanly
constexpr int kDeadTurns = 8;              // a lock that was not held cleanly in these, ...
constexpr double kDead = 0.9;              // ... of phases that scatter by so much, where no comb stands, is none
constexpr double kGone = 0.6;              // the old comb holds so much less
constexpr double kFar = 0.05;              // of the speed; a comb further away than that may be chatter's ...
constexpr double kTeethOfFar = 0.5;        // ... unless the teeth make so much of it
constexpr int kTrialTurns = 48;            // in which a comb that nobody told must be followed cleanly
constexpr double kSlipped = 0.5;           // scatter of phases that are not held
constexpr double kEveryPassing = 0.01;     // 20 dB below what the other multiples of the tooth passing hold
constexpr double kOffMains = 0.2;          // Hz, as hum_watch.h has it
constexpr double kFine = 7e-4;
constexpr double kAgreement = 1.5e-3;   // two windows in a row say the same speed
constexpr double kMoved = 2.5e-3;       // a lock this far off a better comb is given up ...
constexpr double kBetter = 2.0;         // ... if that comb carries so much more
constexpr double kStaysPart = 0.2;      // of what chatter leaves beside its line: the spindle's comb has it
constexpr double kDisbelief = 3e-3;     // further from what the line series say, a comb is not the spindle's
constexpr int kBelieve = 2;             // looks on end that say the same
constexpr double kMargin = 1.2;         // past the stated doubt, so that its end is still a peak
constexpr double kMachineRange = 0.01;  // a measured speed is better than a programmed one
constexpr double kSameSpeed = 1e-4;     // a read-back that moves less did not move
constexpr double kSmear = 1e-2;         // a comb is sought in what was heard while the told speed moved by less
constexpr double kRideSd = 1e-3;        // of a speed taken from the machine, once its ratio to the truth is known
constexpr int kRideFrames = 16;         // a speed that changes does so in steps this long

}  // namespace

void SpeedTracker::prepare(const CutSetup& setup, double searchRange) {
  rate_ = setup.rate.value;
  teeth_ = setup.teeth;
  range_ = searchRange;
  nominal_ = toHertz(setup.nominalSpeed).value;
  channels_ = std::clamp(static_cast<int>(setup.channels.size()), 1, kSearchChannels);
  const bool told = nominal_ > 0.0;
  const double seconds = told ? kThoroughTurns / (nominal_ * (1.0 - kMargin * range_)) : kSeekSeconds;
  const double part = told ? kQuickTurns / kThoroughTurns : kSeekQuickly;
  const int window = std::clamp(static_cast<int>(seconds * rate_), 256, 1 << 19);
  thorough_.search.prepare(window, setup.rate, setup.teeth);
  quick_.search.prepare(std::max(128, static_cast<int>(window * part)), setup.rate, setup.teeth);
  tracker_.prepare(channels_, setup.rate, setup.teeth);
  lone_.prepare(setup.teeth, setup.rate);
  trend_.prepare(kQuickHops);
  heard_.prepare(channels_, window);
  reset();
}

void SpeedTracker::reset() noexcept {
  told_ = before_ = nominal_;
  measured_ = false;
  tracker_.mayDrift(true);
  motion_.reset(nominal_);
  machine_.reset();
  toldSd_ = 0.0;
  ratio_ = 1.0;
  source_ = nominal_ > 0.0 ? SpeedSource::Nominal : SpeedSource::None;
  locked_ = proven_ = trusted_ = returning_ = followed_ = false;
  believedLooks_ = 0;
  far_ = 0.0;
  toothPart_ = 0.0;
  lone_.reset();
  angle_ = 0.0;
  restart();
  tracker_.start(Hertz(told_), Hertz(told_ * range_));
}

void SpeedTracker::restart() noexcept {
  slew_ = 0.0;
  forget();
  if (locked_) tracker_.start(spindle(), sd());
}

void SpeedTracker::setMachineState(const MachineState& machine, int frames, Instant end) noexcept {
  blockFrames_ = std::max(frames, 1);
  blockDone_ = 0;
  before_ = told_;
  const ReportedSpeed::Word word = machine_.hear(machine, end);
  const double told = word.hertz > 0.0 ? word.hertz : nominal_;
  toldSd_ = word.sd;
  if (word.measured != measured_ || !(before_ > 0.0)) {
    before_ = told;
    motion_.retell(told);
  }
  if (word.measured != measured_) tracker_.mayDrift(!word.measured);
  measured_ = word.measured;
  if (!(told > 0.0) && locked_) return;  // nobody says more than the signal did
  if (told_ > 0.0 && std::abs(told / told_ - 1.0) < kSameSpeed) return;
  if (told_ > 0.0 && told > 0.0 && locked_ && !riding()) tracker_.nudge(Hertz(told * ratio_));
  told_ = told;
  far_ = 0.0;
  if (!locked_) source_ = told > 0.0 ? (measured_ ? SpeedSource::Machine : SpeedSource::Nominal) : SpeedSource::None;
}

Hertz SpeedTracker::sd() const noexcept {
  // A speed that changes is followed with some delay.
  if (locked_ && !astray()) {
    return Hertz(std::hypot(tracker_.sd().value, tracker_.spindle().value - motion_.heard(), riding() ? toldSd_ : 0.0));
  }
  return Hertz(std::hypot(told_ * (measured_ ? kMachineRange : range_), toldSd_));
}

void SpeedTracker::remember(const double* const* samples, int frames) noexcept {
  const int skipped = std::max(0, frames - static_cast<int>(heard_.window()));
  const std::ptrdiff_t stride = channels_ > 1 ? samples[1] - samples[0] : 0;
  heard_.push(samples[0] + skipped, stride, static_cast<std::size_t>(frames - skipped));
}

void SpeedTracker::lock(Hertz spindle, Hertz sd, double drift) noexcept {
  locked_ = true;
  trusted_ = told_ > 0.0 && (trusted_ || nominal_ > 0.0 || measured_);
  if (!(told_ > 0.0)) told_ = spindle.value;
  ratio_ = spindle.value / told_;
  source_ = SpeedSource::Signal;
  motion_.startHearing(spindle.value);
  tracker_.start(spindle, sd, drift);
  slew_ = 0.0;
}

void SpeedTracker::beginCut() noexcept {
  if (locked_ && tracker_.turns() < kThoroughTurns) return;  // found while the tool was coming in
  if (source_ == SpeedSource::Signal) {                      // what was told still holds
    told_ = nominal_ > 0.0 || measured_ ? told_ : 0.0;
    source_ = !(told_ > 0.0) ? SpeedSource::None : measured_ ? SpeedSource::Machine : SpeedSource::Nominal;
  }
  locked_ = proven_ = trusted_ = returning_ = followed_ = false;
  believedLooks_ = 0;
  far_ = 0.0;
  toothPart_ = 0.0;
  lone_.reset();
  restart();
}

bool SpeedTracker::believedElsewhere(Hertz spindle) const noexcept {
  // What is followed by its phases is known better, and at once where the speed changes.
  return (!locked_ || astray()) && believedLooks_ >= kBelieve && std::abs(spindle / believed_ - 1.0) > kDisbelief;
}

Hertz SpeedTracker::centre() const noexcept {
  return Hertz(far_ > 0.0 ? far_ : told_);
}

double SpeedTracker::centreSd() const noexcept {
  return (measured_ ? kMachineRange : range_) / 3.0;
}

void SpeedTracker::believe(Hertz spindle, double sd, bool certain) noexcept {
  if (!certain || riding()) {
    believedLooks_ = 0;
    return;
  }
  const bool same = believedLooks_ > 0 && std::abs(spindle / believed_ - 1.0) < kDisbelief;
  believedLooks_ = same ? believedLooks_ + 1 : 1;
  believed_ = spindle;
  if (believedLooks_ < kBelieve || (locked_ && !believedElsewhere(this->spindle()))) return;
  lock(spindle, Hertz(std::max(sd, 3e-4) * spindle.value));
  if (std::abs(spindle.value / told_ - 1.0) < kMargin * range_) far_ = 0.0;
  toothPart_ = 0.0;
  proven_ = false;
  trend_.reset();
}

bool SpeedTracker::dead() const noexcept {
  if (tracker_.clean()) return tracker_.scattered() && onComb_ < kStaysPart && !measured_;
  const bool held = tracker_.turns() < kDeadTurns || tracker_.scatter() < kDead;
  const bool known = followed_ || (tracker_.scattered() && onComb_ < kStaysPart);
  return known && !held && !measured_ && !quick_.last.stands() && !thorough_.last.stands();
}

bool SpeedTracker::astray() const noexcept {
  return locked_ && (tracker_.lost() || (returning_ && tracker_.turns() > kReturnTurns) || dead());
}

void SpeedTracker::judge(const Look& look, const SpeedCandidate& before) noexcept {
  const SpeedCandidate& now = look.last;
  const bool same = now.stands() && before.stands() && std::abs(now.spindle / before.spindle - 1.0) < kAgreement;
  const double apart = look.search.window() / (kThoroughHops * rate_);  // s, of thorough windows
  if (&look == &thorough_) motion_.followCombs(same ? now.spindle / before.spindle - 1.0 : 1.0, apart);
  const bool drowned = tracker_.scattered();
  const double off = std::abs(now.spindle / spindle() - 1.0);
  if ((astray() || drowned) && now.stands() && off < (drowned ? kAgreement : kFine)) {
    toothPart_ = now.toothPart;  // the comb that was followed says the same speed: it was the cut that changed
    tracker_.stay();
    return;
  }
  if (!same || believedElsewhere(now.spindle)) return;
  if (locked_) {
    // A comb that once carried half of all power was the spindle; what fits better later is chatter.
    if (off < kMoved && !astray()) {
      const bool slipped = !proven_ && off > kFine && tracker_.scatter() > kSlipped;
      // Not by its window alone: a comb may fit the coming in of the tool, when a mode rings and lines are broad.
      const bool held = tracker_.clean() || (off < kFine && tracker_.turns() > kThoroughTurns);
      proven_ = proven_ || (now.part > SpeedCandidate::kClearPart && held);
      if (!slipped) return;
    }
    if (off > kMoved && proven_ && !astray()) return;
  }
  // Where nobody tells a change and no lock has settled, what the windows have led on to is the comb that was found.
  const bool sameComb = &look == &quick_ && !measured_ && !proven_ && trend_.unbroken();
  if (locked_ && !sameComb && off > kMoved) {
    // Both spectra must prefer the new comb: a chatter line that happens to fit it shows in one of them only, and has
    // little beside it.
    const SpeedSearch::Parts here = look.search.restAt(spindle() / look.gone);
    const SpeedSearch::Parts there = look.search.restAt(now.spindle / look.gone);
    if (there.vibration < kBetter * here.vibration || there.square < kBetter * here.square) {
      // What else there is has stayed in its place: it is chatter that made it look lost.
      if (here.vibration > there.vibration && here.square > there.square) tracker_.stay();
      return;
    }
  }
  toothPart_ = now.toothPart;
  proven_ = false;
  // What was found is the speed in the middle of the window; while a machine tells its change, it has moved evenly
  // since what is remembered began.
  const double sinceMiddle = 0.5 * look.search.window() / static_cast<double>(inCut_);
  const double gone = riding() ? sinceMiddle * (motion_.told() / toldFirst_ - 1.0) : 0.0;
  lock(now.spindle * (1.0 + gone), Hertz(std::max(now.sd.value, 3e-4 * now.spindle.value)), look.drift);
  // What the quick windows say leads on only from what one of them has found.
  if (&look == &quick_) {
    trend_.mark();
  } else {
    trend_.reset();
  }
}

// Mains hum and its multiples are a comb as well, as if teeth passed 50 or 60 times a second.
bool SpeedTracker::mayBeHum(Hertz spindle) const noexcept {
  const double passing = spindle.value * std::max(teeth_, 1);
  return std::min(std::abs(passing - 50.0), std::abs(passing - 60.0)) < kOffMains;
}

bool SpeedTracker::believed(const Look& look) const noexcept {
  if (look.agreeing < (locked_ ? kReturnLooks : kSeekLooks)) return false;
  const Hertz found = look.found.spindle;
  if (believedElsewhere(found)) return false;
  if (!locked_ && (mayBeHum(found) || look.found.everyPassing < kEveryPassing)) return false;
  if (!locked_) return look.found.toothPart * teeth_ >= look.found.part || teeth_ < 1;
  const bool teeth = teeth_ < 1 || look.found.toothPart > kTeethOfFar * look.found.part;
  const double least = returning_ ? 1.0 : kGone;  // what was found on the way is the next place to leave
  return look.search.hasMoved(spindle(), found, least) && (teeth || std::abs(found / spindle() - 1.0) < kFar);
}

void SpeedTracker::seek(Look& look) noexcept {
  const Hertz low(locked_ ? kReturnLow * spindle().value : kSlowestHertz);
  const Hertz high(locked_ ? kReturnHigh * spindle().value : std::min(kFastestHertz, rate_ / 16.0));
  const FoundSpeed before = look.found;
  look.found = look.search.find(low, high);
  const bool same = std::abs(look.found.spindle / before.spindle - 1.0) < (locked_ ? kReturnAgreement : kAgreement);
  // One line and its fractions make a comb of anything, a chatter line as well: the others must be on it too.
  const double others = 1.0 - look.search.strongest().part;
  const bool alone = !locked_ && look.search.restAt(look.found.spindle).vibration < kSeekRest * others;
  look.agreeing = look.found.part < kSeekPart || alone ? 0 : same ? look.agreeing + 1 : 1;
  if (!believed(look)) return;
  look.agreeing = 0;
  toothPart_ = look.found.toothPart;
  proven_ = false;
  returning_ = locked_;
  far_ = std::abs(look.found.spindle.value / told_ - 1.0) > kMargin * range_ ? look.found.spindle.value : 0.0;
  lock(look.found.spindle, Hertz(kRideSd * look.found.spindle.value));
  trend_.reset();
}

// A comb that was never followed cleanly was not the spindle's: chatter and its side lines make combs as well. Nor is
// one that proves, followed, to be the mains', which the windows that found it did not tell so finely.
void SpeedTracker::dropUntrusted() noexcept {
  if (!locked_ || trusted_) return;
  const bool clean = tracker_.clean();
  const bool hum = clean && mayBeHum(spindle());
  trusted_ = clean && !hum;
  if (trusted_ || (!hum && tracker_.turns() < kTrialTurns)) return;
  locked_ = false;
  told_ = nominal_;
  ratio_ = 1.0;
  source_ = SpeedSource::None;
  forget();
}

// The comb must not lie on the line that is known not to be forced, whatever was told: in the middle between two orders
// is where chatter is most itself.
void SpeedTracker::stepAside(const SpeedSearch& search) noexcept {
  lone_.followSuspect(search);
  const Hertz line = lone_.suspect();
  if (std::abs(dsp::orderOffset(line, spindle())) > SpeedSearch::kOnComb || !(told_ > 0.0)) return;
  locked_ = false;
  ratio_ = line.value / ((std::floor(line.value / told_) + 0.5) * told_);
}

void SpeedTracker::lookIfDue(Look& look) noexcept {
  const long window = look.search.window();
  if (look.since < window / (&look == &quick_ ? kQuickHops : kThoroughHops) || inCut_ < window) return;
  look.since = 0;
  // A proven comb that is followed is not given up for another (judge()): there is nothing to be found.
  if (locked_ && proven_ && !astray() && !motion_.phasesMove() && !tracker_.scattered() &&
      !(lone_.suspect().value > 0.0))
    return;
  const double followed = locked_ && !astray() ? tracker_.drift() : 0.0;
  look.drift = followed != 0.0 || measured_ ? followed : trend_.drift();
  look.gone = 1.0 + 0.5 * look.drift * static_cast<double>(window) / rate_;
  look.search.begin(look.drift);
  for (int c = 0; c < channels_; ++c) look.search.add(heard_.newest(c).last(static_cast<std::size_t>(window)));
  if (&look == &quick_) {
    const double doubt = kMargin * (measured_ ? LoneLine::kReadBack : range_);
    onComb_ = tracker_.scattered() ? look.search.restPartAt(spindle() / look.gone) : 1.0;
    lone_.watch(look.search, Hertz(told_), doubt, measured_, locked_ ? spindle() : Hertz());
  }
  if (&look == &quick_ && (astray() || !(told_ > 0.0))) seek(look);
  if (!(told_ > 0.0)) return;
  const double range = kMargin * (measured_ ? kMachineRange : range_);
  const SpeedCandidate before = look.last;
  // A speed found far from the told one has its own neighbourhood.
  const double middle = locked_ && std::abs(ratio_ - 1.0) > range ? told_ * ratio_ : told_;
  if (lone_.suspect().value > 0.0) stepAside(look.search);
  const auto within = [&](double part) {
    return look.search.search(Hertz(middle * (1.0 - part)), Hertz(middle * (1.0 + part)), lone_.suspect());
  };
  look.last = within(range);
  if (!locked_ && !measured_) {
    const SpeedCandidate further = within(range + SpeedSearch::kRunAway);
    const double least = std::max(SpeedCandidate::kClearPart, kBetter * look.last.part);
    if (further.stands() && further.part > least) look.last = further;
  }
  if (&look == &quick_ && !look.last.stands()) {
    trend_.reset();
  } else if (&look == &quick_) {
    trend_.add(Seconds((static_cast<double>(inCut_) - 0.5 * static_cast<double>(window)) / rate_), look.last.spindle);
  }
  look.last.spindle *= look.gone;
  judge(look, before);
}

void SpeedTracker::followMotion(double seconds) noexcept {
  if (!(told_ > 0.0) || !measured_) {
    motion_.noMachine();
  } else if (motion_.followMachine(told_, toldSd_, seconds) && locked_) {
    proven_ = false;  // the ratio of true to told speed need not have stayed the same
    tracker_.start(Hertz(told_ * ratio_), Hertz(told_ * kRideSd));
  }
  if (locked_ && !riding()) motion_.followSignal(tracker_.spindle().value, tracker_.drift(), seconds);
}

void SpeedTracker::ride(int frames, double* angle, double* step) noexcept {
  slew_ = 0.0;
  for (int f = 0; f < frames; ++f) {
    if (f % kRideFrames == 0) {
      const double share = std::min(1.0, (blockDone_ - frames + f + 0.5 * kRideFrames) / blockFrames_);
      step[f] = kTwoPi * ratio_ * (before_ + share * (told_ - before_)) / rate_;
    } else {
      step[f] = step[f - 1];
    }
    angle[f] = angle_;
    angle_ += step[f];
    if (angle_ >= kTwoPi) angle_ -= kTwoPi;
  }
}

void SpeedTracker::forget() noexcept {
  inCut_ = 0;
  trend_.reset();
  for (Look* look : {&quick_, &thorough_}) {
    look->last = {};
    look->found = {};
    look->agreeing = 0;
    look->since = 0;
  }
  lone_.forget();
  onComb_ = 1.0;
  motion_.forgetCombs();
}

// Within the next turn; never more than 2 % of the speed, so that the angle stays monotone.
void SpeedTracker::catchUp(double angle, double omega) noexcept {
  const double turn = omega > 0.0 ? kTwoPi / omega * rate_ : 1.0;
  slew_ = std::clamp(angle / turn, -0.02 * omega / rate_, 0.02 * omega / rate_);
}

void SpeedTracker::advance(const double* const* samples, int frames, double* angle, double* step) noexcept {
  blockDone_ += frames;
  if (riding()) ride(frames, angle, step);
  if (riding() && !seeksWhileRiding()) return forget();
  if (riding() && std::abs(motion_.told() / toldFirst_ - 1.0) > kSmear) forget();
  if (inCut_ == 0) toldFirst_ = motion_.told();
  remember(samples, frames);
  inCut_ += frames;
  for (Look* look : {&quick_, &thorough_}) look->since += frames;
  if (riding()) return;
  double omega = locked_ ? turnToCome() : kTwoPi * spindle().value;
  for (int f = 0; f < frames;) {
    const int first = f;
    const double begin = angle_;
    const double increment = omega / rate_ + slew_;
    do {
      angle[f] = angle_;
      step[f] = increment;
      angle_ += increment;
    } while (++f < frames && angle_ < kTwoPi);
    if (locked_) tracker_.accumulate(begin, increment, samples, first, f - first);
    if (angle_ < kTwoPi) return;
    angle_ -= kTwoPi;
    if (!locked_) continue;
    const double ahead = tracker_.completeTurn();
    omega = turnToCome();
    if (told_ > 0.0) ratio_ = tracker_.spindle().value / told_;
    catchUp(ahead, omega);
  }
}

void SpeedTracker::look(Seconds since, bool leaving) noexcept {
  followMotion(since.value);
  dropUntrusted();
  if (riding() && !seeksWhileRiding()) return;
  returning_ = returning_ && !tracker_.clean();
  if (!tracker_.scattered()) onComb_ = 1.0;
  followed_ = followed_ || (locked_ && tracker_.clean());
  const bool sure = locked_ && tracker_.clean();  // until then the comb may be the chatter's
  if (sure) lone_.forget();
  if (proven_ && !motion_.phasesMove()) motion_.forgetCombs();
  if (locked_ && leaving) return;
  if (!sure || astray() || tracker_.scattered()) lookIfDue(quick_);
  lookIfDue(thorough_);
}

}  // namespace stillcut::detect
