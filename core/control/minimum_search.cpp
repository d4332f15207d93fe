#include "core/control/minimum_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillcut::control {
namespace {

constexpr double kSettledShare = 0.3;  // of a step
// Of a step: what rounding and slip may leave. The speed before is a whole one off.
constexpr double kBesideShare = 0.75;
constexpr double kStood = 1.0;       // [s] after which the spindle is not on its way any more
constexpr double kMostDrift = 0.25;  // between two trials: more is not believed
// Times H at the best speed. H of a quiet cut scatters by eight within a second at one speed of the simulated ramp.
constexpr double kNearChatter = 8.0;
constexpr double kNextTo = 1.5;  // steps

}  // namespace

void MinimumSearch::forget() STILLCUT_RT {
  const Options options = options_;
  *this = MinimumSearch{};
  options_ = options;
}

void MinimumSearch::start(Rpm speed, Rpm base) STILLCUT_RT {
  forget();
  state_ = State::Searching;
  base_ = base;
  way_ = speed > base ? 1 : -1;
  tryAt(speed);
}

void MinimumSearch::tryAt(Rpm speed) STILLCUT_RT {
  trying_ = speed;
  waited_ = stoodFor_ = 0.0;
  dwelt_ = sum_ = early_ = earlyTime_ = perturbationSum_ = 0.0;
  ++trials_;
}

Rpm MinimumSearch::advance(const Input& in) STILLCUT_RT {
  if (state_ != State::Searching || !(in.dt > 0.0) || !std::isfinite(in.level)) return trying_;
  reach_ = in.reach;
  sinceJudged_ += in.dt;
  if (!settled(in)) {
    waited_ = dwelt_ = sum_ = early_ = earlyTime_ = perturbationSum_ = 0.0;
    return trying_;
  }
  waited_ += in.dt;
  const double turns = options_.turns / toHertz(in.present).value;  // [s]
  if (waited_ < std::min(options_.wait.value, 0.5 * turns)) return trying_;
  dwelt_ += in.dt;
  sum_ += in.level * in.dt;
  if (std::isfinite(in.perturbation)) perturbationSum_ += std::max(0.0, in.perturbation) * in.dt;
  const double dwell = std::min(options_.dwell.value, turns);
  if (dwelt_ <= 0.5 * dwell) {
    early_ = sum_;
    earlyTime_ = dwelt_;
  }
  if (dwelt_ > 0.5 * dwell && nearChatter()) {
    closeThisSide({});
  } else if (dwelt_ >= dwell) {
    evaluateTrial({trying_, sum_ / dwelt_, perturbationSum_ / dwelt_, true});
  }
  return trying_;
}

bool MinimumSearch::settled(const Input& in) STILLCUT_RT {
  const double step = options_.step * base_.value;
  const double apart = std::abs((in.present - trying_).value);
  const bool stands = std::abs((in.present - stood_).value) <= kSettledShare * step;
  stoodFor_ = stands ? stoodFor_ + in.dt : 0.0;
  if (!stands) stood_ = in.present;
  return apart <= kSettledShare * step || (apart <= kBesideShare * step && stoodFor_ >= kStood);
}

bool MinimumSearch::nearChatter() const STILLCUT_RT {
  return best_.known && best_.perturbation > 0.0 && perturbationSum_ > kNearChatter * best_.perturbation * dwelt_;
}

// Fraction by which the level has changed since the trial before, from the two halves of this one.
double MinimumSearch::drift() STILLCUT_RT {
  const double lateTime = dwelt_ - earlyTime_;
  if (!(earlyTime_ > 0.0) || !(lateTime > 0.0) || !(early_ > 0.0)) return 0.0;
  const double early = early_ / earlyTime_, late = (sum_ - early_) / lateTime;
  const double before = growth_;
  growth_ = (late - early) / (0.5 * (early + late)) / (0.5 * dwelt_);
  return std::clamp(std::min(growth_, before) * sinceJudged_, -kMostDrift, kMostDrift);
}

void MinimumSearch::evaluateTrial(const Point& point) STILLCUT_RT {
  const double since = 1.0 + drift();
  sinceJudged_ = 0.0;
  for (Point* p : {&best_, &below_, &above_}) p->level *= since;
  if (!best_.known) {
    best_ = point;
  } else {
    const bool better = point.level < best_.level * (1.0 - options_.worthIt);
    const Point old = best_;
    if (better) best_ = point;
    // The worse of the two is the neighbour on its side; that side needs no further try.
    const Point& worse = better ? old : point;
    const bool above = worse.speed > best_.speed;
    (above ? above_ : below_) = worse;
    (above ? closedAbove_ : closedBelow_) = true;
  }
  next();
}

void MinimumSearch::next() STILLCUT_RT {
  const Rpm step = base_ * options_.step;
  for (int turn = 0; turn < 2; ++turn, way_ = -way_) {
    bool& closed = way_ > 0 ? closedAbove_ : closedBelow_;
    const Rpm candidate = best_.speed + step * way_;
    if (!closed && !reach_.contains(candidate)) closed = true;
    if (!closed && trials_ < kMostTrials) {
      tryAt(candidate);
      return;
    }
  }
  state_ = State::Done;
  trying_ = inside();
}

Rpm MinimumSearch::inside() const STILLCUT_RT {
  const double apart = (best_.speed - chatter_).value;
  const bool atLimit = chatter_.value > 0.0 && std::abs(apart) < kNextTo * options_.step * base_.value;
  const Point& away = apart > 0.0 ? above_ : below_;
  return atLimit && away.known ? away.speed : vertex();
}

bool MinimumSearch::chattered() STILLCUT_RT {
  if (state_ != State::Idle && closeThisSide(trying_)) return true;
  forget();
  return false;
}

// A neighbour without a level: the bracket stays open on that side. False: it is the best speed itself.
bool MinimumSearch::closeThisSide(Rpm chatter) STILLCUT_RT {
  if (!best_.known || trying_ == best_.speed) return false;
  if (chatter.value > 0.0) chatter_ = chatter;
  (trying_ > best_.speed ? closedAbove_ : closedBelow_) = true;
  next();
  return true;
}

// Through three points at their own distances; inside the bracket by construction, because the middle one is lowest.
Rpm MinimumSearch::vertex() const STILLCUT_RT {
  if (!below_.known || !above_.known) return best_.speed;
  const double x1 = (below_.speed - best_.speed).value;
  const double x2 = (above_.speed - best_.speed).value;
  const double y1 = below_.level - best_.level;
  const double y2 = above_.level - best_.level;
  const double determinant = x1 * x2 * (x1 - x2);
  const double curvature = (y1 * x2 - y2 * x1) / determinant;
  const double slope = (y2 * x1 * x1 - y1 * x2 * x2) / determinant;
  if (!(curvature > 0.0)) return best_.speed;
  const double shift = -slope / (2.0 * curvature);
  return Rpm(best_.speed.value + std::clamp(shift, 0.5 * x1, 0.5 * x2));
}

}  // namespace stillcut::control
