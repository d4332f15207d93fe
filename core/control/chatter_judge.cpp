#include "core/control/chatter_judge.h"

#include <cmath>

namespace stillcut::control {
namespace {

// A sixth of the tooth-passing frequency: noise of a real line is far below it, random lines exceed it two times in
// three.
constexpr double kStill = 1.0 / 6.0;
// A frequency that jumps this share of the tooth-passing frequency is another member of the family, not noise.
constexpr double kFamilyJump = 0.25;
constexpr double kFast = 0.04, kSlow = 0.3;  // [s] time constants that tell growth from decay
constexpr double kGrowing = 1.15, kFalling = 0.9;
// A gap in the alarm this long ends it; a single missed verdict does not.
constexpr double kGap = 0.05;  // [s]

double wrapped(double fraction) noexcept {
  return fraction - std::round(fraction);
}

}  // namespace

void ChatterJudge::forget() STILLCUT_RT {
  frequency_ = {};
  fraction_ = standing_ = quiet_ = fast_ = slow_ = 0.0;
  confirmed_ = false;
}

void ChatterJudge::hear(const Verdict& verdict, Seconds dt, Hertz toothPass, bool moved) STILLCUT_RT {
  const double step = std::isfinite(dt.value) && dt.value > 0.0 ? dt.value : 0.0;
  if (!verdict.alarming() || !(verdict.frequency.value > 0.0) || !(toothPass.value > 0.0)) {
    quiet_ += step;
    confirmed_ = false;
    if (quiet_ > kGap) forget();
    return;
  }
  quiet_ = 0.0;
  follow(verdict, step, toothPass.value);
  if (!moved) {
    confirmed_ = standing_ >= options_.first.value;
    return;
  }
  const bool lasting = standing_ >= options_.after.value;
  const bool full = verdict.state == CutState::Chatter && fast_ > kFalling * slow_;
  const bool growing = fast_ > kGrowing * slow_;
  confirmed_ = lasting && (full || growing);
}

void ChatterJudge::follow(const Verdict& verdict, double dt, double toothPass) STILLCUT_RT {
  const double severity = std::isfinite(verdict.severity.value) ? verdict.severity.value : 0.0;
  const double now = wrapped(verdict.frequency.value / toothPass);
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
  const double step = (verdict.frequency - frequency_).value;
  frequency_ = std::abs(step) > kFamilyJump * toothPass ? verdict.frequency : frequency_ + Hertz(share * step);
  fast_ += (severity - fast_) * dt / (dt + kFast);
  slow_ += (severity - slow_) * dt / (dt + kSlow);
}

}  // namespace stillcut::control
