// quarter-phase: Liao 1996, eq. 3 with the phase factor nu = 0.25:
//   Z N / 60 = f_c / (n + nu), n = 0, 1, 2, ... chosen for the speed closest to the present one.
// Departures, with their reasons:
// - Eq. 3 prints Z N = 1 / T with N in revolutions per second; here N is in rev/min, hence the 60.
// - nu is a parameter, because figure 4 compares several; 0.25 is the default, as section 2 derives it (eq. 8: the work
//   per cycle is least at sin(phi) = 1).
// - n = 0 is allowed where nu lets it; a target out of the override's reach is not asked for, and said.
// - The paper decides once per 512-point spectrum (1.2 s); here the rule is recomputed while chatter is marked, with
//   the frequency low-passed (frequency_rule.h).
// - No quarter wave is promised to be stable: eq. 8 counts the energy of a vibration that is there, not the lobes. On
//   van Dijk's ramp its target lies outside the stable pocket (tests/component/control_loop_test.cpp).
//
// A quarter wave between two cuts takes the most energy out of the vibration in each period. The paper's machine could
// only go slower, so the direction is an option: nearest, down, up. "Slower" includes what the rule already reached:
// a target that the frequency's noise puts a hair above the present speed is not a reason to jump a whole pocket.
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
  void retune(const config::ParamSet& params) noexcept override;

 private:
  Aim aim(const RuleView& view) noexcept override;

  double phase_ = 0.25;
  SpeedDirection direction_ = SpeedDirection::Nearest;
};

}  // namespace stillcut::control
