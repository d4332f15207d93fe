// stable-pocket: the default strategy: goes once to the pocket that van Dijk 2010, section 4.1 chooses, waits, looks,
// and resigns after a few speeds. Its states and what is ours in it: resources/manual/developers/laws.md#stable-pocket.
// Thread: as Strategy.
#pragma once

#include "core/control/chatter_confirmation.h"
#include "core/control/pocket_search.h"
#include "core/control/strategy.h"

namespace stillcut::control {

config::ParamTable stablePocketParams();

class StablePocket final : public Strategy {
 public:
  StrategyInfo describe() const override;
  // Throws std::runtime_error where the override limits contradict each other.
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  void retune(const config::ParamSet& params) override;
  OverrideRequest decide(const StrategyInput& input) override;
  void reset() override;
  void relinquish() override;

 private:
  enum class Phase { Watch, Settle, Resigned };

  void watchLetGo(const Verdict& verdict, const MachineState& machine, Rpm present);
  void giveUpTarget();
  void listen(const StrategyInput& input);
  void settle(const StrategyInput& input, Rpm present);
  bool standsAsOrdered(const StrategyInput& input, Rpm present);
  void choose(const MachineState& machine, Rpm present);
  void resign(const Reason& why);
  Reason nothingQuiet(Hertz chatter) const;
  OverrideRequest answer(const StrategyInput& input) const;

  config::OverrideLimits limits_;
  int teeth_ = 0;
  int mostMoves_ = 0;
  Seconds settle_{}, forget_{}, pause_{};

  ChatterConfirmation confirmation_;
  PocketSearch search_;
  Phase phase_ = Phase::Watch;
  Rpm programmed_{};
  Rpm target_{};  // 0: none
  Rpm from_{};    // where the move began
  Hertz movedFor_{};
  Rpm even_{};  // the measured speed, smoothed
  bool arrived_ = false;
  Hertz heardThere_{};  // of the last alarm at the target; 0: quiet since, or not there yet
  int moves_ = 0;
  double inPhase_ = 0.0;   // [s] in Settle at speed, or in Resigned
  double waiting_ = 0.0;   // [s] that the spindle has not begun to move
  Rpm stands_{};           // where it has stood
  double standing_ = 0.0;  // [s] ... with the order in force
  double quiet_ = 0.0;     // [s] without an alarm
  Metres path_{};          // of feed since the first alarm of what is being dealt with
  Reason reason_;
};

}  // namespace stillcut::control
