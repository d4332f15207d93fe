#include "core/control/chatter_confirmation.h"

#include <algorithm>
#include <cmath>

namespace stillcut::control {
namespace {

// Of a spindle frequency: noise of a real line is far below it, random lines exceed it seven times in ten.
constexpr double kStill = 0.15;
// A frequency that jumps this fraction of the tooth-passing frequency is another member of the family, not noise.
constexpr double kFamilyJump = 0.25;
// Time constants that separate growth from decay: [s], but at least so many revolutions, which a detector needs to
// answer.
constexpr double kFast = 0.04, kSlow = 0.3;
constexpr double kFastTurns = 0.5, kSlowTurns = 5.0;
constexpr double kGrowing = 1.15, kFalling = 0.95;
constexpr double kLastingTurns = 5.0;
// A gap in the alarm this long ends it; a single missed verdict does not.
constexpr double kGap = 0.05;  // [s]

// Vibration: time constants [s], and what counts as loud.
constexpr double kLoudTime = 0.1, kUsualTime = 1.0;
constexpr double kAsBefore = 0.3, kTimesUsual = 4.0;
constexpr double kStandingSeverity = 0.05;
// Chatter without an alarm: as many times as long as an alarm, and revolutions for a decay.
constexpr double kUntold = 4.0, kUntoldTurns = 20.0;

// Detectors themselves do not see chatter nearer to a harmonic; a measured speed is good for 0.1 % of the order.
constexpr double kHarmonic = 0.025;

double wrapped(double fraction) {
  return fraction - std::round(fraction);
}

// Of every `step`-th order.
bool onHarmonic(Hertz frequency, Hertz spindle, int step) {
  return std::abs(wrapped(frequency / spindle / step)) * step < kHarmonic;
}

}  // namespace

void ChatterConfirmation::forget() STILLCUT_RT {
  frequency_ = {};
  fraction_ = standing_ = full_ = quiet_ = untold_ = fast_ = slow_ = 0.0;
  confirmed_ = false;
}

void ChatterConfirmation::listen(const Verdict& verdict, double dt, bool moved, double vibration) STILLCUT_RT {
  if (!std::isfinite(vibration) || vibration < 0.0) return;
  loud_ += (vibration - loud_) * dt / (dt + kLoudTime);
  const bool usual = !moved && verdict.state == CutState::Stable && verdict.phase == CutPhase::Steady;
  if (usual) usual_ += (vibration - usual_) * (usual_ > 0.0 ? dt / (dt + kUsualTime) : 1.0);
}

void ChatterConfirmation::update(const Verdict& verdict, Seconds dt, const Spindle& spindle,
                                 double vibration) STILLCUT_RT {
  const double step = std::isfinite(dt.value) && dt.value > 0.0 ? dt.value : 0.0;
  listen(verdict, step, spindle.moved, vibration);
  const bool heard = verdict.alarming() && verdict.frequency.value > 0.0 && spindle.measured.value > 0.0;
  if (!heard || (spindle.moved && onHarmonic(verdict.frequency, spindle.measured, spindle.teeth))) {
    hearNone(verdict, step, spindle);
    return;
  }
  quiet_ = untold_ = 0.0;
  full_ = verdict.state == CutState::Chatter ? full_ + step : 0.0;
  follow(verdict, step, spindle);
  if (!spindle.moved) {
    confirmed_ = standing_ >= options_.first.value;
    if (confirmed_) {
      struck_ = loud_;
      believed_ = frequency_;
    }
    return;
  }
  const double turn = 1.0 / spindle.measured.value;
  const double lasts = std::max(options_.after.value, kLastingTurns * turn);
  const bool full = verdict.state == CutState::Chatter && fast_ > kFalling * slow_;
  const bool growing = fast_ > kGrowing * slow_;
  const bool loud = usual_ > 0.0 && loud_ > kTimesUsual * usual_ && loud_ > kAsBefore * struck_ &&
                    slow_ > kStandingSeverity && standing_ >= 2.0 * options_.after.value;
  const bool restless = loud_ > struck_ && full_ >= 2.0 * lasts;
  const bool locked = onHarmonic(verdict.frequency, spindle.measured, 1);
  confirmed_ = restless || (!locked && standing_ >= lasts && (full || growing || loud));
  if (confirmed_) believed_ = frequency_;
}

void ChatterConfirmation::hearNone(const Verdict& verdict, double dt, const Spindle& spindle) STILLCUT_RT {
  const double untold = untold_;
  quiet_ += dt;
  confirmed_ = false;
  if (quiet_ > kGap) forget();
  const bool known = spindle.moved && usual_ > 0.0 && believed_.value > 0.0 && spindle.measured.value > 0.0;
  const bool said = verdict.valid && !verdict.alarming() && verdict.severity.value > 0.0;
  const bool restless = known && said && loud_ * std::sqrt(verdict.severity.value) > kTimesUsual * usual_;
  untold_ = restless ? untold + dt : 0.0;
  if (!restless || untold_ < std::max(kUntold * options_.after.value, kUntoldTurns / spindle.measured.value)) return;
  frequency_ = believed_;
  confirmed_ = true;
}

void ChatterConfirmation::follow(const Verdict& verdict, double dt, const Spindle& spindle) STILLCUT_RT {
  const double severity = std::isfinite(verdict.severity.value) ? verdict.severity.value : 0.0;
  const double now = wrapped(verdict.frequency / spindle.measured);
  if (frequency_.value <= 0.0 || std::abs(wrapped(now - fraction_)) > kStill) {
    standing_ = 0.0;
    frequency_ = verdict.frequency;
    fraction_ = now;
    fast_ = slow_ = severity;
    return;
  }
  standing_ += dt;
  const double share = dt > 0.0 ? dt / (dt + options_.smoothing.value) : 0.0;
  fraction_ = wrapped(fraction_ + share * wrapped(now - fraction_));
  const double toothPass = spindle.measured.value * spindle.teeth;
  const double step = (verdict.frequency - frequency_).value;
  frequency_ = std::abs(step) > kFamilyJump * toothPass ? verdict.frequency : frequency_ + Hertz(share * step);
  const double turn = 1.0 / spindle.measured.value;
  fast_ += (severity - fast_) * dt / (dt + std::max(kFast, kFastTurns * turn));
  slow_ += (severity - slow_) * dt / (dt + std::max(kSlow, kSlowTurns * turn));
}

}  // namespace stillcut::control
