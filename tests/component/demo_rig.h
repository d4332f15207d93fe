// The demo's cut on the simulated machine, as a rig's parts; tests add what they ask of it.
#pragma once

#include <memory>

#include "app/compose/rig.h"
#include "core/cnc/simulated_machine.h"
#include "core/daq/simulated/simulated_source.h"
#include "tests/support/demo_cut.h"

namespace stillcut::test {

inline app::RigSpec demoRig() {
  const milling::Scenario cut = demoCut();
  auto port = std::make_shared<milling::PlantPort>();
  app::RigSpec spec;
  spec.device = std::make_unique<daq::SimulatedSource>(cut, 0, port, daq::SimulatedPace{});
  spec.link = std::make_unique<cnc::SimulatedMachine>(cut, port);
  spec.setup = cut.cutSetup();
  return spec;
}

}  // namespace stillcut::test
