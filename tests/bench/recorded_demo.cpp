#include "tests/bench/recorded_demo.h"

#include "core/cnc/simulated_machine.h"
#include "core/control/registry.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/detect/registry.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/step_loop.h"
#include "core/sensing/conditioner.h"
#include "tests/support/demo_cut.h"

namespace stillcut::bench {
namespace {

KeptBlock keep(const detect::ConditionedBlock& block) {
  KeptBlock kept;
  kept.block = block;
  kept.samples.assign(block.samples, block.samples + block.channels * block.stride);
  kept.angle.assign(block.angle, block.angle + block.frames);
  kept.angleStep.assign(block.angleStep, block.angleStep + block.frames);
  return kept;
}

RecordedDemo record() {
  RecordedDemo demo;
  demo.scenario = test::demoCut();
  demo.setup = demo.scenario.cutSetup();
  demo.limits = safety::gateLimits({}, demo.setup, "bench").value();
  demo.limits.autoAllowed = true;

  auto port = std::make_shared<milling::PlantPort>();
  daq::SimulatedSource source(demo.scenario, 0, port);
  (void)source.open();
  cnc::SimulatedMachine machine(demo.scenario, port);
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  rt::SpscRing<OperatorInput> operatorInputs(4);
  operatorInputs.push({OperatorAction::SetAuthority, Authority::Auto});
  pipeline::LiveStateSource feed(states, operatorInputs);
  pipeline::Chain chain(everyDetector());
  chain.prepare(demo.setup, {}, demo.limits);
  detect::Conditioner conditioner;
  conditioner.prepare(demo.setup, {});
  const SteadyClock clock;
  pipeline::StepLoop loop({chain, feed, commands, nullptr, nullptr, clock});
  pipeline::LinkRunner link(machine, commands, states);

  StepInput input;
  input.block.allocate(static_cast<int>(demo.setup.channels.size()), demo.setup.blockFrames);
  while (source.read(input.block)) {
    demo.steps.push_back(loop.step(input));
    demo.inputs.push_back(input);
    demo.conditioned.push_back(keep(conditioner.process(input.block, input.machine)));
    link.tick(input.block.end());
  }
  for (KeptBlock& kept : demo.conditioned) {
    kept.block.samples = kept.samples.data();
    kept.block.angle = kept.angle.data();
    kept.block.angleStep = kept.angleStep.data();
  }
  return demo;
}

}  // namespace

const RecordedDemo& recordedDemo() {
  static const RecordedDemo kDemo = record();
  return kDemo;
}

pipeline::ChainParts everyDetector() {
  pipeline::ChainParts parts;
  for (const auto& row : detect::detectorTable()) {
    if (row.id == detect::kDefaultDetector) parts.inCharge = static_cast<int>(parts.detectors.size());
    parts.detectors.push_back(row.make());
  }
  parts.strategy = control::makeStrategy(control::kDefaultStrategy).value();
  return parts;
}

}  // namespace stillcut::bench
