// StepRecord: one step of the worker, complete: what went in (block, machine state, operator) and what came out.
// The recorder stores it; a replay feeds the first half back and must get the second half bit by bit.
#pragma once

#include <array>
#include <cstdint>

#include "core/model/event.h"
#include "core/model/machine_state.h"
#include "core/model/operator_input.h"
#include "core/model/override_command.h"
#include "core/model/override_request.h"
#include "core/model/sample_block.h"
#include "core/model/snapshot.h"
#include "core/model/verdict.h"

namespace stillcut {

inline constexpr int kMaxInputsPerStep = 4;
inline constexpr int kMaxEventsPerStep = 16;

struct StepInput {
  SampleBlock block;
  MachineState machine;
  int inputCount = 0;
  std::array<OperatorInput, kMaxInputsPerStep> inputs{};
};

struct StepOutput {
  int verdictCount = 0;
  int inCharge = 0;
  std::array<Verdict, kMaxDetectors> verdicts{};
  OverrideRequest request;
  bool hasCommand = false;
  CommandRecord command;
  Authority authority = Authority::Off;
  int eventCount = 0;
  std::array<Event, kMaxEventsPerStep> events{};
};

struct StepRecord {
  StepInput input;
  StepOutput output;
};

}  // namespace stillcut
