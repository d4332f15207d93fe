// StandingAdvice: the one speed that is advised, made of what the strategy in charge asks for in each block. It stands
// still while the request stays alike, goes when another program word comes or when the cut has been stable at another
// speed for a while, and is there under every authority and without a machine. Beside a strategy that only monitors it
// asks one of its own (stable-pocket). Thread: prepare() at set-up, the rest on the worker, real-time.
#pragma once

#include <string_view>

#include "core/control/stable_pocket.h"
#include "core/control/strategy.h"
#include "core/model/speed_advice.h"

namespace stillcut::control {

// A spindle without a machine that tells of it: as set up, and as fast as the vibration says. Invalid where the nominal
// speed is not known. `spindle`: estimated, 0: as set up.
MachineState machineAsSetUp(const CutSetup& setup, Hertz spindle, Instant now);

// Nothing was ever read: there is no machine, or it has not answered yet.
bool neverRead(const MachineState& machine);

class StandingAdvice {
 public:
  // Throws std::runtime_error as StablePocket does. `strategy`: the id of the one in charge.
  void prepare(const CutSetup& setup, const config::ParamSet& params, std::string_view strategy);
  void retune(const config::ParamSet& params);
  // As after prepare().
  void reset();

  // One block: `asked` is the answer of the strategy in charge to `input`.
  const SpeedAdvice& look(const StrategyInput& input, const OverrideRequest& asked);
  // What the operator is asked to accept goes before what would be said.
  const SpeedAdvice& take(const OverrideRequest& pending, const MachineState& machine);

 private:
  void watchCut(const StrategyInput& input);
  void put(const SpeedAdvice& next);

  bool monitors_ = false;
  StablePocket own_;  // of a strategy that asks for nothing
  SpeedAdvice advice_;
  Rpm programmed_{};
  double stable_ = 0.0;   // [s] judged, without an alarm, at another speed than the advised one
  bool expired_ = false;  // until the next alarm
};

}  // namespace stillcut::control
