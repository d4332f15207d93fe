// FrequencyRule: what the rules that turn a chatter frequency into a spindle speed have in common. The frequency is
// low-passed; the target is recomputed while chatter is marked, and the last one is kept once it clears (option: frozen
// at the actual speed); another programmed speed forgets everything; feed follows speed, so that the feed per tooth
// stays within the override's range.
#pragma once

#include "core/control/strategy.h"
#include "core/control/target_speed.h"

namespace stillcut::control {

struct RuleOptions {
  Seconds smoothing{};          // of the frequency
  bool waitForChatter = false;  // act on full chatter only, not at its onset
  bool freeze = false;          // once quiet, stay at the actual speed
};

// What a rule sees each time.
struct RuleView {
  Instant now{};
  Seconds dt{};
  Hertz chatter{};  // low-passed; 0 when quiet
  int teeth = 0;
  Rpm present{};               // measured, or commanded where the machine does not measure
  Rpm programmed{};            // times the operator's knob
  double level = 0.0;          // perturbation power, any unit (StrategyInput::perturbation, else the severity)
  Seconds effect{};            // from an order to the overrides in force; 0: unknown
  double vibration = -1.0;     // StrategyInput::vibration
  double perturbation = -1.0;  // StrategyInput::perturbation
  bool air = false;            // no verdict on a cut
  config::SpeedRange reach;
};

// Where to go; a speed of 0 leaves the target as it is, a reason without a code what was said.
struct Aim {
  Rpm speed{};
  Reason reason;
};

class FrequencyRule : public Strategy {
 public:
  OverrideRequest decide(const StrategyInput& input) final;
  void reset() final;

 protected:
  // From the rule's own prepare(); throws std::runtime_error where the override limits contradict each other.
  void prepareRule(const CutSetup& setup, const config::ParamSet& params);
  void setOptions(const RuleOptions& options) { options_ = options; }

  // Chatter is marked. Real-time.
  virtual Aim aim(const RuleView& view) = 0;
  // Quiet, and a target of ours exists. Real-time.
  virtual Aim whenQuiet(const RuleView& view);
  // Forget what the rule itself remembers. Real-time.
  virtual void forget() {}

 private:
  void smooth(const Verdict& verdict, Seconds dt, Hertz toothPass);
  RuleView look(const StrategyInput& input, Rpm present) const;
  void take(const Aim& aim);

  config::OverrideLimits limits_;
  RuleOptions options_;
  int teeth_ = 0;

  Rpm programmed_{};
  Hertz chatter_{};  // low-passed; 0: none yet in this episode
  Hertz heard_{};    // the last one, kept when quiet
  Rpm target_{};     // 0: none
  bool alarmed_ = false;
  Reason reason_;
};

}  // namespace stillcut::control
