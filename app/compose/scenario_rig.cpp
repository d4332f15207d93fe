#include "app/compose/scenario_rig.h"

#include <utility>

#include "app/compose/known_lobes.h"
#include "core/cnc/simulated_machine.h"

namespace stillcut::app {

Result<ScenarioRig> buildScenarioRig(const milling::Scenario& scenario, const ScenarioOptions& options) {
  auto port = std::make_shared<milling::PlantPort>();
  auto source = std::make_unique<daq::SimulatedSource>(scenario, options.seed, port,
                                                       daq::SimulatedPace{.realTime = options.live});
  const daq::SimulatedSource* plant = source.get();

  RigSpec spec;
  spec.device = std::move(source);
  spec.link = std::make_unique<cnc::SimulatedMachine>(scenario, port);
  spec.setup = scenario.cutSetup();
  if (options.modesKnown) spec.setup.stableSpeeds = stableSpeeds(scenario);
  spec.params = options.params;
  spec.methods = options.methods;
  if (spec.methods.strategy.empty()) spec.methods.strategy = scenario.strategy;
  spec.autoAllowed = scenario.grantsAuto;
  spec.watched = options.watched;
  spec.deterministic = !options.live;
  auto rig = Rig::build(std::move(spec));
  if (!rig) return rig.error();
  return ScenarioRig{std::move(rig).value(), plant};
}

}  // namespace stillcut::app
