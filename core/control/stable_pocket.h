// stable-pocket: the default strategy. van Dijk 2010, section 4.1 chooses where to go (eq. 29, 30); this is what it
// takes to leave the rule on without watching it:
//   watch   the cut; an alarm must stand for a moment at one frequency (chatter_confirmation.h)
//   move    once, to a target that no longer changes; where modes are known it is checked against the lobes
//   settle  until the spindle is there and what chattered has had time to ring down. There is also where it stands
//           although the order is in force: slip under load is not waited for. A target that a turned knob has put out
//           of reach is given up
//   judge   with fresh verdicts: quiet, or an onset that does not grow: stay. Chatter again: the next pocket
//           The gate has let go of the speed while it chattered (a sensor at its limit): that speed is not gone to
//           again
//   resign  after a few speeds, or where none is left: back to the programmed values, saying which depth would do: the
//           lobes' where they are known. Without them no depth can be worked out (chatter's frequencies give the shape
//           of the lobes, never their scale); what was seen bounds it: less than where the chatter began
// Ours are the waiting, the memory of speeds that chattered, the lobes and the resigning; the paper recomputes its
// target while chatter is marked, which on a spindle that takes longer to move than the chatter to change hunts.
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
  void retune(const config::ParamSet& params) noexcept override;
  OverrideRequest decide(const StrategyInput& input) noexcept override;
  void reset() noexcept override;
  void relinquish() noexcept override;

 private:
  enum class Phase { Watch, Settle, Resigned };

  void watchLetGo(const Verdict& verdict, const MachineState& machine, Rpm present) noexcept;
  void giveUpTarget() noexcept;
  void listen(const StrategyInput& input) noexcept;
  void settle(const StrategyInput& input, Rpm present) noexcept;
  bool standsAsOrdered(const StrategyInput& input, Rpm present) noexcept;
  void choose(const MachineState& machine, Rpm present) noexcept;
  void resign(const Reason& why) noexcept;
  Reason nothingQuiet(Hertz chatter) const noexcept;
  OverrideRequest answer(const StrategyInput& input) const noexcept;

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
