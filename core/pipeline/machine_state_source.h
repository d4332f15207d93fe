// MachineStateSource: completes a step's input with what is not in the samples: the machine's state and what the
// operator asked. Live it comes from the link thread and the screen; a recording carries it with the block. The worker
// does not know which (house rule 4). Thread: complete() on the worker, real-time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/model/machine_state.h"
#include "core/model/operator_input.h"
#include "core/model/step_record.h"
#include "core/rt/mailbox.h"
#include "core/rt/spsc_ring.h"

namespace stillcut::pipeline {

class MachineStateSource {
 public:
  virtual ~MachineStateSource() = default;
  // Fills the machine's state and the operator's inputs in; whoever has none leaves the state invalid.
  virtual void complete(StepInput& step) noexcept = 0;
};

// The machine's newest state as the link thread left it, and the operator's inputs in the order they came.
class LiveStateSource final : public MachineStateSource {
 public:
  LiveStateSource(rt::Mailbox<MachineState>& states, rt::SpscRing<OperatorInput>& inputs)
      : states_(states), inputs_(inputs) {}
  void complete(StepInput& step) noexcept override;

 private:
  rt::Mailbox<MachineState>& states_;
  rt::SpscRing<OperatorInput>& inputs_;
};

// The source has already filled everything in (a session being replayed).
class RecordedStateSource final : public MachineStateSource {
 public:
  void complete(StepInput& /*step*/) noexcept override {}
};

// Another feed, and what the operator sets on the screen: a replay takes new parameters and nothing else from there.
class TunedStateSource final : public MachineStateSource {
 public:
  TunedStateSource(std::unique_ptr<MachineStateSource> inner, rt::SpscRing<OperatorInput>& inputs)
      : inner_(std::move(inner)), inputs_(inputs) {}
  void complete(StepInput& step) noexcept override;

 private:
  std::unique_ptr<MachineStateSource> inner_;
  rt::SpscRing<OperatorInput>& inputs_;
};

// A recording without a machine: only the nominal or logged spindle speed is known.
class SpeedLogSource final : public MachineStateSource {
 public:
  struct Point {
    Seconds time;  // from the first sample
    Rpm speed;
  };
  // `log` sorted by time; between points the speed is interpolated, outside it is the nearest point's.
  // Empty: no machine at all, the state stays invalid and the nominal speed counts.
  explicit SpeedLogSource(std::vector<Point> log) : log_(std::move(log)) {}
  void complete(StepInput& step) noexcept override;

 private:
  std::vector<Point> log_;
  std::optional<Instant> began_;  // the first sample
};

}  // namespace stillcut::pipeline
