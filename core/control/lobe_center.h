// lobe-center: van Dijk 2010, section 4.1. The tooth-passing frequency, or a harmonic, is put on the chatter frequency:
//   p = max(1, round(60 f_c / (Z Omega))), Omega_new = 60 f_c / (p Z)                                     (eq. 29, 30)
// f_c is low-passed first; the target is recomputed while chatter is marked, and the last one is kept once it clears
// (option: frozen at the actual speed, for narrow lobes). Feed follows speed, so that the feed per tooth stays.
//
// Eq. 28 is the waves that eq. 29 rounds. Departures, with their reasons:
// - Eq. 29 rounds to 0 where chatter lies below half the tooth passing, and eq. 30 would divide by it: p is at least 1.
// - Eq. 30 knows no limits: a target that the override does not reach is replaced as said below.
// - The paper waits for its detector's mark; which one of ours that is, onset or full chatter, is a parameter.
// - A frequency that jumps by a quarter of the tooth passing or more is taken at once: low-passing it would aim between
//   two members of one family.
// - Another programmed speed is another cut, and forgets the target.
// - Section 5.2 lets the feed follow within 0 .. 100 %; here within the limits of the gate.
//
// A detector may name any member of the chatter's family f_c + k f_tp as the dominant one. At the present speed they
// share the fraction of a wave, so all point the same way; but 60 (f_c + k f_tp) / ((p + k) Z) is a different speed for
// each k, nearer to the present one the higher k is. The rule takes the dominant one as given, as the paper does. Where
// the override does not reach the rule's target, the nearest neighbouring pocket that it reaches is taken; where there
// is none, nothing is asked and the reason says so. Thread: as Strategy.
#pragma once

#include "core/control/frequency_rule.h"

namespace stillcut::control {

config::ParamTable lobeCenterParams();

class LobeCenter final : public FrequencyRule {
 public:
  StrategyInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  void retune(const config::ParamSet& params) noexcept override;

 private:
  Aim aim(const RuleView& view) noexcept override;
};

}  // namespace stillcut::control
