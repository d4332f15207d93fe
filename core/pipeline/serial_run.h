// SerialRun: the same parts as the engine's in one thread and in a fixed order: read, step, link. What it does is a
// function of its inputs alone: simulations, analyses of recordings, and tests.
// Thread: the caller's.
#pragma once

#include "core/base/time.h"
#include "core/daq/daq_source.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/step_loop.h"
#include "core/pipeline/step_source.h"

namespace stillcut::pipeline {

struct SerialParts {
  StepSource& source;
  daq::SourceFormat format;
  StepLoop& loop;
  LinkRunner* link = nullptr;    // nullptr: no machine
  ManualClock* clock = nullptr;  // set to the end of each block
};

class SerialRun {
 public:
  explicit SerialRun(const SerialParts& parts) : parts_(parts) {
    input_.block.allocate(static_cast<int>(parts.format.channels.size()), parts.format.blockFrames);
  }

  // One block. nullptr: the source has ended. Good until the next call.
  const Chain::Step* next() noexcept {
    if (!parts_.source.read(input_)) return nullptr;
    if (parts_.clock != nullptr) parts_.clock->set(input_.block.end());
    const Chain::Step& done = parts_.loop.step(input_);
    if (parts_.link != nullptr) parts_.link->tick(input_.block.end());
    return &done;
  }
  // The block of the last next(), with its machine state and inputs.
  const StepInput& input() const { return input_; }

 private:
  SerialParts parts_;
  StepInput input_;
};

}  // namespace stillcut::pipeline
