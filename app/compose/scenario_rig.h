// A rig on the simulated machine of a scenario.
// Thread: set-up.
#pragma once

#include <memory>
#include <string>

#include "app/compose/rig.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::app {

struct ScenarioOptions {
  Methods methods;  // strategy empty: the scenario's own
  config::ParamSet params;
  std::uint64_t seed = 0;   // 0: the scenario's own
  bool modesKnown = false;  // strategies get the stability lobes of the scenario's own model
  bool live = false;        // paced to the steady clock, on threads; otherwise deterministic
  bool watched = false;     // a screen reads snapshots
};

struct ScenarioRig {
  std::unique_ptr<Rig> rig;
  const daq::SimulatedSource* source = nullptr;  // owned by the rig; its plant knows the truth
};

// Auto may be chosen where the scenario grants it; what chooses it is the caller.
Result<ScenarioRig> buildScenarioRig(const milling::Scenario& scenario, const ScenarioOptions& options);

}  // namespace stillcut::app
