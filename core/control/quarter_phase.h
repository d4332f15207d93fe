// quarter-phase: Liao 1996, eq. 3 with the phase factor nu = 0.25: n + 1/4 waves between two cuts, at the speed closest
// to the present one. Equations and departures: resources/manual/developers/laws.md#quarter-phase. Thread: as Strategy.
#pragma once

#include "core/control/frequency_rule.h"

namespace stillcut::control {

config::ParamTable quarterPhaseParams();

enum class SpeedDirection { Nearest, Down, Up };

struct QuarterTarget {
  Rpm speed{};
  double waves = 0.0;  // n + nu; 0: none in the reach
};

// The rule itself. A speed within `reach`, in the wanted direction, closest to the present one. Real-time.
QuarterTarget quarterPhaseSpeed(Hertz chatter, int teeth, Rpm present, double phase, SpeedDirection direction,
                                const config::SpeedRange& reach) STILLCUT_RT;

class QuarterPhase final : public FrequencyRule {
 public:
  StrategyInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  void retune(const config::ParamSet& params) override;

 private:
  Aim aim(const RuleView& view) override;

  double phase_ = 0.25;
  SpeedDirection direction_ = SpeedDirection::Nearest;
};

}  // namespace stillcut::control
