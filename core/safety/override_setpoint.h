// OverrideSetpoint: the factors that the gate is on its way to, and whether a new wish for others counts as a change of
// the machine (change_budget.h). Thread: worker. Real-time after prepare().
#pragma once

#include <cmath>

#include "core/safety/change_budget.h"
#include "core/safety/override_ramp.h"

namespace stillcut::safety {

// GoesOn: in the direction of the move in hand. Taken: from rest, or turned back.
enum class Proposal { Same, GoesOn, Taken, Refused };

class OverrideSetpoint {
 public:
  void prepare(const GateLimits& limits) {
    deadband_ = limits.deadband;
    budget_.prepare(limits.changesPerMinute, limits.coolDown);
    restart();
  }
  // At rest at 100 %. What was counted stays counted.
  void restart() STILLCUT_RT { stopAt({}); }
  void stopAt(const Factors& f) STILLCUT_RT {
    target_ = f;
    speedWay_ = feedWay_ = 0;
  }
  void advance(double dt, bool arrived) STILLCUT_RT {
    budget_.advance(dt);
    still_ = arrived ? still_ + dt : 0.0;
    if (still_ > kRest) speedWay_ = feedWay_ = 0;
  }

  // `free`: the operator's own decision, or the way back to 100 %: counted where there is room, never refused.
  Proposal propose(const Factors& wanted, bool free) STILLCUT_RT {
    const int speedWay = way(wanted.speed - target_.speed);
    const int feedWay = way(wanted.feed - target_.feed);
    if (speedWay == 0 && feedWay == 0) return Proposal::Same;
    const bool goesOn = speedWay != 0 ? speedWay == speedWay_ : feedWay == feedWay_;
    if (!goesOn && free) budget_.count();
    if (!goesOn && !free && !budget_.take()) return Proposal::Refused;
    if (speedWay != 0) target_.speed = wanted.speed;
    if (feedWay != 0) target_.feed = wanted.feed;
    if (speedWay != 0) speedWay_ = speedWay;
    if (feedWay != 0) feedWay_ = feedWay;
    still_ = 0.0;
    return goesOn ? Proposal::GoesOn : Proposal::Taken;
  }
  // Whether it would be another move than the one in hand.
  bool turns(const Factors& wanted) const STILLCUT_RT {
    const int speedWay = way(wanted.speed - target_.speed);
    const int feedWay = way(wanted.feed - target_.feed);
    return speedWay != 0 ? speedWay != speedWay_ : feedWay != feedWay_ && feedWay != 0;
  }
  // The way back to exactly 100 %, from inside the dead band as well: it must arrive. Never refused.
  void goBack() STILLCUT_RT {
    propose({}, true);
    target_ = {};
  }
  // Wanted is where we already are, within the dead band.
  bool near(const Factors& wanted) const STILLCUT_RT {
    return way(wanted.speed - target_.speed) == 0 && way(wanted.feed - target_.feed) == 0;
  }

  const Factors& target() const STILLCUT_RT { return target_; }
  const ChangeBudget& budget() const STILLCUT_RT { return budget_; }
  void forgiveChanges() STILLCUT_RT { budget_.clear(); }

 private:
  static constexpr double kRest = 0.5;  // [s] after which the next move is a new one

  int way(double difference) const STILLCUT_RT {
    if (!(std::abs(difference) > deadband_)) return 0;
    return difference > 0.0 ? 1 : -1;
  }

  double deadband_ = 0.0;
  Factors target_;
  int speedWay_ = 0, feedWay_ = 0;  // direction of the move in hand; 0: at rest
  double still_ = 0.0;
  ChangeBudget budget_;
};

}  // namespace stillcut::safety
