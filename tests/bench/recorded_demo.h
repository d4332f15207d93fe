// The demo's cut (entry, stable, chatter, change of speed) run once, kept hop by hop, so that each hop can be measured
// alone on what it gets in a real run.
#pragma once

#include <vector>

#include "core/milling/simulation/scenario.h"
#include "core/model/cut_setup.h"
#include "core/model/step_record.h"
#include "core/pipeline/chain.h"
#include "core/safety/gate_limits.h"
#include "core/sensing/conditioned_block.h"

namespace stillcut::bench {

// A conditioned block that owns what it points at.
struct KeptBlock {
  detect::ConditionedBlock block;
  std::vector<double> samples, angle, angleStep;
};

struct RecordedDemo {
  milling::Scenario scenario;
  CutSetup setup;
  safety::GateLimits limits;
  std::vector<StepInput> inputs;
  std::vector<KeptBlock> conditioned;
  std::vector<pipeline::Chain::Step> steps;
  double blockSeconds() const { return setup.blockFrames / setup.rate.value; }
};

// Made at the first call.
const RecordedDemo& recordedDemo();

// Every detector of the table in one chain, the default one in charge.
pipeline::ChainParts everyDetector();

}  // namespace stillcut::bench
