#include "core/safety/intervention_judge.h"

#include <algorithm>
#include <cmath>

namespace stillcut::safety {

void InterventionJudge::forget() STILLCUT_RT {
  open_ = false;
  withoutHelp_ = 0;
  level_ = loudest_ = levelBefore_ = 0.0;
  quiet_ = 1e9;
}

void InterventionJudge::listen(const InterventionStep& step) STILLCUT_RT {
  if (!step.heard) return;
  if (std::isfinite(step.vibration) && step.vibration >= 0.0) {
    level_ += (step.vibration - level_) * (level_ > 0.0 ? step.dt / (step.dt + kLevelTime) : 1.0);
  }
  quiet_ = step.alarming ? 0.0 : quiet_ + step.dt;
  loudest_ = alarmedLately() ? std::max(loudest_, level_) : level_;
  if (quiet_ > rules_.proven.value) withoutHelp_ = 0;
}

bool InterventionJudge::creeps(const Factors& from, const Factors& to) const STILLCUT_RT {
  const auto further = [this](double before, double at, double next) {
    return (at - before) * (next - at) >= 0.0 && std::abs(next - at) <= rules_.creeps;
  };
  return further(before_.speed, from.speed, to.speed) && further(before_.feed, from.feed, to.feed);
}

Outcome InterventionJudge::begin(const Factors& before, const Factors& after) STILLCUT_RT {
  if (open_ && (standing_ < rules_.listens.value || creeps(before, after))) {
    goOn();
    return Outcome::None;
  }
  const Outcome last = open_ && alarmedLately() ? end(Outcome::NotHelped) : Outcome::None;
  open_ = true;
  before_ = before;
  levelBefore_ = loudest_;
  since_ = standing_ = 0.0;
  return last;
}

Outcome InterventionJudge::judge(const InterventionStep& step) STILLCUT_RT {
  if (!open_ || !step.heard) return Outcome::None;
  since_ += step.dt;
  if (underWay() && since_ > rules_.arrivesWithin.value) return end(Outcome::NotHelped);
  // Thrown off its speed or its override again, it is not what was moved to.
  if (!step.arrived) return Outcome::None;
  standing_ += step.dt;
  if (step.alarming && standing_ > rules_.helpsWithin.value) {
    return end(louder() ? Outcome::Louder : Outcome::NotHelped);
  }
  const bool away = std::min(standing_, quiet_) >= rules_.staysAway.value;
  return away ? end(Outcome::Helped) : Outcome::None;
}

Outcome InterventionJudge::fault() STILLCUT_RT {
  return end(Outcome::NotHelped);
}

Outcome InterventionJudge::end(Outcome outcome) STILLCUT_RT {
  open_ = false;
  if (outcome != Outcome::Helped) ++withoutHelp_;
  return outcome;
}

}  // namespace stillcut::safety
