// PlantPort: how the simulated source and the simulated machine share one plant without locks. The source's thread owns
// the plant and advances it; the machine's thread leaves what is asked of the plant here and finds the plant's state.
// Used alternately in one thread it does the same, reproducibly.
// Thread: order/knobs and state side on the link thread, serve() and publish() on the driver thread. Real-time safe.
#pragma once

#include <optional>

#include "core/base/time.h"
#include "core/milling/simulation/simulated_cut.h"
#include "core/model/machine_state.h"
#include "core/rt/mailbox.h"

namespace stillcut::milling {

// Everything the machine's side wants, whole each time, so that the newest one is enough.
struct PlantCommand {
  Instant when{};  // of the newest change of the overrides
  Ratio speed{1.0}, feed{1.0};
  Ratio operatorSpeedFactor{1.0}, operatorFeedFactor{1.0};
  bool overridesEnabled = true;
  bool feedHold = false;
  bool operator==(const PlantCommand&) const = default;
};

class PlantPort {
 public:
  // Link thread.
  void order(const PlantCommand& wanted) noexcept { orders_.post(wanted); }
  std::optional<MachineState> state() noexcept { return states_.latest(); }

  // Driver thread.
  void serve(SimulatedCut& plant) noexcept {
    const std::optional<PlantCommand> o = orders_.take();
    if (!o) return;
    if (o->speed != served_.speed || o->feed != served_.feed) plant.setOverrides(o->speed, o->feed, o->when);
    plant.setOperatorOverrides(o->operatorSpeedFactor, o->operatorFeedFactor);
    plant.setOverridesEnabled(o->overridesEnabled);
    plant.setFeedHold(o->feedHold);
    served_ = *o;
  }
  void publish(const SimulatedCut& plant) noexcept { states_.post(plant.machineState()); }

 private:
  rt::Mailbox<PlantCommand> orders_;
  rt::Mailbox<MachineState> states_;
  PlantCommand served_;  // driver thread's
};

}  // namespace stillcut::milling
