#include "core/spindle/phase_tracker.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {
namespace {

constexpr double kMemoryTurns = 16.0;  // of the references and their scatter
// A spindle under load wanders by about 0.1 % with one second of memory; this is that, as a random walk.
constexpr double kWander = 1.0e-3;
constexpr double kWanderSeconds = 1.0;
// A drift is thought of only once it is shown (drift_watch.h), by phases that go along with it: were it always thought
// of, chatter that beats slowly beside an order (1.5 Hz at 800 rev/min) would be taken for one, and so would a width of
// cut that changes, which turns all phases as far as the middle of the arc moves, and then no further. Nobody knows how
// long it lasts: without a word from the phases it is forgotten within seconds.
constexpr double kDriftDoubt = 0.3;  // of what is shown
constexpr double kDriftSeconds = 2.0;
constexpr double kDriftScatter = 0.2;
constexpr double kLargestStep = 0.3;  // rad of the highest order in use; beyond it the phase may have slipped
// An angle error this many standard deviations large that one common turn of all phases explains is a spindle that
// changes its speed faster than it wanders (an override, a run-up). Chatter scatters the phases instead.
constexpr double kManoeuvre = 3.0;
constexpr double kExplained = 0.2;      // part of the power that the common turn may leave
constexpr double kManoeuvreStep = 1.0;  // rad of the highest order in use
// Once followed cleanly, forced vibration that is gone from its place was not drowned by chatter, which leaves it where
// it is: the comb has moved from under the tracker.
constexpr double kRetainTurns = 3.0;
constexpr double kLeastRetained = 0.3;
constexpr int kBackTurns = 2;  // phases that only turn past their place are not back in it: on end ...
constexpr double kBack = 0.8;  // ... they scatter less than this
// ... and so has it where next to nothing repeats for so many turns on end: the references fade then, and what is left
// of them says nothing of what was retained. Chatter that drowns the forced vibration leaves a turn of it now and then:
// of an end mill's there were never more than seven without.
constexpr int kScatteredTurns = 12;
constexpr double kScattered = 0.98;
constexpr double kDrowned = 4.0;  // in power
// Part of a line's power that one order away is found on a harmonic, over a turn: sinc^2 of 0.9.
constexpr double kLeak = 0.02;
constexpr double kUsualTurns = 64.0;
constexpr double kCleanScatter = 0.5;
constexpr int kManoeuvreTurns = 6;        // the references are known by then
constexpr double kManoeuvreSpread = 0.3;  // of a turn: what is seen of it has gathered over some turns

}  // namespace

void PhaseTracker::prepare(int channels, Hertz rate, int teeth) {
  channels_ = std::clamp(channels, 1, kChannels);
  kernels_ = dsp::kernels::bestKernels();
  rate_ = rate.value;
  stride_ = std::max(teeth, 1);
  start(Hertz(0.0), Hertz(0.0));
}

void PhaseTracker::start(Hertz spindle, Hertz sd, double drift) noexcept {
  omega_ = kTwoPi * spindle.value;
  p00_ = p01_ = 0.0;
  forgetDrift();
  if (mayDrift_) alpha_ = omega_ * drift;
  p22_ = kDriftDoubt * alpha_ * kDriftDoubt * alpha_;
  p11_ = kTwoPi * sd.value * kTwoPi * sd.value;
  drift_.reset();
  time_ = angleSum_ = 0.0;
  frames_ = 0;
  turns_ = 0;
  scatter_ = 0.0;
  inPlace_ = scattered_ = 0;
  retained_ = 1.0;
  gone_ = false;
  clean_ = false;
  sums_ = {};
  all_ = {};
  usual_ = 0.0;
  if (spindle.value > 0.0) {
    orders_ = std::clamp(static_cast<int>(0.45 * rate_ / (spindle.value * stride_)), 1, kOrders);
  }
  phasor_ = turn_ = {};
  step_ = 0.0;
}

void PhaseTracker::fill(Row& row, double angle) const noexcept {
  const double tooth = stride_ * angle;
  kernels_.powers(std::cos(tooth), -std::sin(tooth), static_cast<std::size_t>(orders_), row.re.data(), row.im.data());
}

void PhaseTracker::accumulate(double angle, double step, const double* const* samples, int first, int frames) noexcept {
  fill(phasor_, angle);
  if (step != step_) fill(turn_, step);
  step_ = step;
  const double* x = samples[0] + first;
  const double* y = samples[channels_ - 1] + first;
  kernels_.lineSums({x, y, static_cast<std::size_t>(frames), kOrders, phasor_.re.data(), phasor_.im.data(),
                     turn_.re.data(), turn_.im.data(), sums_[0].re.data(), sums_[0].im.data(), sums_[1].re.data(),
                     sums_[1].im.data()});
  for (int f = 0; f < frames; ++f) {
    all_[0] += x[f] * x[f];
    all_[1] += y[f] * y[f];
  }
  angleSum_ += frames * (angle + 0.5 * (frames - 1) * step);
  frames_ += frames;
}

void PhaseTracker::nudge(Hertz spindle) noexcept {
  const double change = kTwoPi * spindle.value - omega_;
  omega_ += change;
  p11_ += 0.01 * change * change;  // a machine's read-back is good to a tenth of the change
}

Hertz PhaseTracker::sd() const noexcept {
  return Hertz(std::sqrt(std::max(p11_, 0.0)) / kTwoPi);
}

PhaseTracker::Angle PhaseTracker::measure() const noexcept {
  double sum = 0.0;
  double info = 0.0;
  for (int c = 0; c < channels_; ++c) {
    for (int k = 0; k < orders_; ++k) {
      const auto i = static_cast<std::size_t>(c * kOrders + k);
      const double order = (k + 1.0) * stride_;
      const double power = std::norm(reference_[i]);
      const double noise = std::max(variance_[i], 0.25 * std::norm(now_[i] - reference_[i])) + 1e-4 * power + 1e-300;
      sum += order * (std::conj(reference_[i]) * now_[i]).imag() / noise;
      info += order * order * power / noise;
    }
  }
  return info > 0.0 ? Angle{sum / info, 1.0 / info} : Angle{};
}

// The one angle by which all phases turned most nearly, weighted by amplitude alone.
PhaseTracker::CommonTurn PhaseTracker::commonTurn() const noexcept {
  double sum = 0.0;
  double weight = 0.0;
  double all = 0.0;
  for (int c = 0; c < channels_; ++c) {
    for (int k = 0; k < orders_; ++k) {
      const auto i = static_cast<std::size_t>(c * kOrders + k);
      const double order = (k + 1.0) * stride_;
      const std::complex<double> turn = std::conj(reference_[i]) * now_[i];
      sum += order * std::abs(turn) * std::arg(turn);
      weight += order * order * std::abs(turn);
      all += std::norm(reference_[i]);
    }
  }
  if (!(weight > 0.0) || !(all > 0.0)) return {};
  const double delta = sum / weight;
  double left = 0.0;
  for (int c = 0; c < channels_; ++c) {
    for (int k = 0; k < orders_; ++k) {
      const auto i = static_cast<std::size_t>(c * kOrders + k);
      left += std::norm(now_[i] * std::polar(1.0, -(k + 1.0) * stride_ * delta) - reference_[i]);
    }
  }
  return {{delta, 0.5 * left / weight}, left / all};
}

// Over a turn that is over.
void PhaseTracker::predict(double seconds) noexcept {
  const double t = seconds;
  const double keep = std::exp(-t / kDriftSeconds);
  const double wandered = wander();
  omega_ += alpha_ * t;
  alpha_ *= keep;
  p00_ += t * (2.0 * p01_ + t * (p11_ + p02_ + t * (p12_ + 0.25 * t * p22_))) + wandered * t * t * t / 3.0;
  p01_ += t * (p11_ + p02_ + t * (1.5 * p12_ + 0.5 * t * p22_)) + 0.5 * wandered * t * t;
  p02_ = keep * (p02_ + t * (p12_ + 0.5 * t * p22_));
  p11_ += t * (2.0 * p12_ + t * p22_) + wandered * t;
  p12_ = keep * (p12_ + t * p22_);
  p22_ *= keep * keep;
}

// Returns the angle by which the spindle is ahead.
double PhaseTracker::correct(Angle error) noexcept {
  const double all = p00_ + error.variance;
  const double gain0 = p00_ / all;
  const double gain1 = p01_ / all;
  const double gain2 = p02_ / all;
  omega_ += gain1 * error.delta;
  alpha_ += gain2 * error.delta;
  p11_ -= gain1 * p01_;
  p12_ -= gain1 * p02_;
  p22_ -= gain2 * p02_;
  p00_ *= 1.0 - gain0;
  p01_ *= 1.0 - gain0;
  p02_ *= 1.0 - gain0;
  return gain0 * error.delta;
}

// A spindle that changes its speed: the doubt grows to what the error says.
PhaseTracker::Angle PhaseTracker::manoeuvred(Angle angle, double seconds) noexcept {
  if (turns_ < kManoeuvreTurns || scatter_ > kCleanScatter) return angle;  // a cut that changes scatters them first
  const CommonTurn turn = commonTurn();
  const double square = turn.angle.delta * turn.angle.delta;
  if (!(turn.left < kExplained) || square < kManoeuvre * kManoeuvre * (p00_ + turn.angle.variance)) return angle;
  p00_ += square;
  p01_ += kManoeuvreSpread * square / seconds;
  p11_ += kManoeuvreSpread * kManoeuvreSpread * square / (seconds * seconds);
  const double limit = kManoeuvreStep / (orders_ * stride_);
  return {std::clamp(turn.angle.delta, -limit, limit), turn.angle.variance};
}

void PhaseTracker::learn(double delta) noexcept {
  double off = 0.0;
  double on = 0.0;
  double kept = 0.0;
  double all = 0.0;
  std::array<std::complex<double>, kChannels * kOrders> errors{};
  for (int c = 0; c < channels_; ++c) {
    for (int k = 0; k < orders_; ++k) {
      const auto i = static_cast<std::size_t>(c * kOrders + k);
      const std::complex<double> turned = now_[i] * std::polar(1.0, -(k + 1.0) * stride_ * delta);
      errors[i] = turned - reference_[i];
      off += std::norm(errors[i]);
      on += std::norm(reference_[i]);
      all += std::norm(now_[i]);
      kept += (std::conj(reference_[i]) * turned).real();
    }
  }
  scatter_ = on > 0.0 ? std::sqrt(std::min(off / on, 1.0)) : 1.0;
  clean_ = clean_ || (turns_ >= kMemoryTurns && scatter_ < kCleanScatter);
  scattered_ = scatter_ < kScattered ? 0 : scattered_ + 1;
  // Where something much louder came in, nothing can be said of what was there.
  if (on > 0.0 && all < kDrowned * on) retained_ += (std::clamp(kept / on, -1.0, 1.0) - retained_) / kRetainTurns;
  inPlace_ = scatter_ < kBack ? inPlace_ + 1 : 0;
  gone_ = retained_ < kLeastRetained || (gone_ && inPlace_ < kBackTurns);
  if (lost()) return;  // what was forced is remembered until the speed is found again
  const double rate = 1.0 / std::min(static_cast<double>(turns_ + 1), kMemoryTurns);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    reference_[i] += rate * errors[i];
    variance_[i] += rate * (std::norm(errors[i]) - variance_[i]);
  }
}

// Has something come in beside the followed lines that leaks more into them than they hold?
bool PhaseTracker::drowned() noexcept {
  double beside = 0.0;
  double on = 0.0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    beside += 2.0 / static_cast<double>(frames_) * all_[c];
    for (std::size_t k = 0; k < static_cast<std::size_t>(orders_); ++k) {
      beside -= std::norm(now_[c * kOrders + k]);
      on += std::norm(reference_[c * kOrders + k]);
    }
  }
  const bool louder = turns_ > kMemoryTurns && beside > kDrowned * usual_ && kLeak * beside > on;
  if (!louder) usual_ += (beside - usual_) / std::min(static_cast<double>(turns_ + 1), kUsualTurns);
  return louder;
}

bool PhaseTracker::scattered() const noexcept {
  return scattered_ > kScatteredTurns;
}

bool PhaseTracker::lost() const noexcept {
  return clean_ && gone_;
}

double PhaseTracker::wander() const noexcept {
  return 2.0 * kWander * kWander * omega_ * omega_ / kWanderSeconds;
}

void PhaseTracker::forgetDrift() noexcept {
  alpha_ = p02_ = p12_ = p22_ = 0.0;
}

void PhaseTracker::mayDrift(bool may) noexcept {
  mayDrift_ = may;
  drift_.reset();
  if (!may) forgetDrift();
}

void PhaseTracker::watchDrift(double seconds, double angle) noexcept {
  drift_.add(seconds, angle);
  if (p22_ > 0.0) {
    if (drift_.over(wander())) forgetDrift();
    return;
  }
  if (scatter_ > kDriftScatter) return;
  const auto shown = drift_.shown(wander());
  if (!shown) return;
  omega_ = shown->omega;
  alpha_ = shown->alpha;
  p22_ = kDriftDoubt * alpha_ * kDriftDoubt * alpha_;
}

double PhaseTracker::completeTurn() noexcept {
  if (frames_ < 4) return 0.0;
  const double seconds = static_cast<double>(frames_) / rate_;
  const double scale = 2.0 / static_cast<double>(frames_);
  for (int c = 0; c < channels_; ++c) {
    const Row& row = sums_[static_cast<std::size_t>(c)];
    for (std::size_t k = 0; k < kOrders; ++k) {
      now_[static_cast<std::size_t>(c) * kOrders + k] = {scale * row.re[k], scale * row.im[k]};
    }
  }
  const bool hidden = drowned();
  sums_ = {};
  all_ = {};
  const double middle = time_ + 0.5 * seconds;
  const double where = kTwoPi * turns_ + angleSum_ / static_cast<double>(frames_);
  time_ += seconds;
  angleSum_ = 0.0;
  frames_ = 0;
  if (turns_ == 0) {
    reference_ = now_;
    for (std::size_t i = 0; i < now_.size(); ++i) variance_[i] = 0.01 * std::norm(now_[i]);
    ++turns_;
    return 0.0;
  }
  const double known = p11_;
  predict(seconds);
  if (hidden) {
    // A spindle that nobody looks at wanders no further than it does.
    const double most = std::max(known, kWander * kWander * omega_ * omega_);
    if (p11_ > most) p12_ *= std::sqrt(most / p11_);
    p11_ = std::min(p11_, most);
    drift_.reset();
    ++turns_;
    return 0.0;
  }
  const double limit = kLargestStep / (orders_ * stride_);
  Angle angle = measure();
  angle.delta = std::clamp(angle.delta, -limit, limit);
  angle = manoeuvred(angle, seconds);
  const double step = angle.variance > 0.0 ? correct(angle) : 0.0;
  learn(angle.delta);
  if (mayDrift_) watchDrift(middle, where + angle.delta);
  ++turns_;
  return step;
}

}  // namespace stillcut::detect
