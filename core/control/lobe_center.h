// lobe-center: van Dijk 2010, section 4.1. The tooth-passing frequency, or a harmonic, is put on the chatter frequency:
//   p = max(1, round(60 f_c / (Z Omega))), Omega_new = 60 f_c / (p Z)                                     (eq. 29, 30)
// f_c is low-passed first; the target is recomputed while chatter is marked, and the last one is kept once it clears
// (option: frozen at the actual speed, for narrow lobes). Feed follows speed, so that the feed per tooth stays.
//
// A detector may name any member of the chatter's family f_c + k f_tp as the dominant one; the members differ in p and,
// at the present speed, by whole waves, but 60 (f_c + k f_tp) / ((p + k) Z) is a different speed for each k. The rule
// takes the dominant one as given, as the paper does. Where the override does not reach the rule's target, the nearest
// neighbouring pocket that it reaches is taken; where there is none, nothing is asked and the reason says so.
#pragma once

#include "core/control/strategy.h"
#include "core/control/target_speed.h"

namespace stillcut::control {

config::ParamTable lobeCenterParams();

class LobeCenter final : public Strategy {
 public:
  StrategyInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  OverrideRequest decide(const StrategyInput& input) noexcept override;
  void reset() noexcept override;

 private:
  void follow(const Verdict& verdict, Seconds dt, Hertz toothPass) noexcept;
  void aim(const StrategyInput& input, Rpm present) noexcept;
  OverrideRequest answer(const StrategyInput& input) const noexcept;

  config::OverrideLimits limits_;
  int teeth_ = 0;
  Seconds smoothing_{};
  bool waitForChatter_ = false;
  bool freeze_ = false;

  Rpm programmed_{};
  Hertz chatter_{};  // low-passed; 0: none yet in this episode
  Rpm target_{};     // 0: none
  bool alarmed_ = false;
  Reason reason_;
};

}  // namespace stillcut::control
