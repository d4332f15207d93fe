#include "core/pipeline/machine_state_source.h"

#include <algorithm>

namespace stillcut::pipeline {

void LiveStateSource::complete(StepInput& step) noexcept {
  const auto newest = states_.latest();
  step.machine = newest ? *newest : MachineState{};
  step.inputCount = 0;
  while (step.inputCount < kMaxInputsPerStep) {
    const OperatorInput* input = inputs_.front();
    if (input == nullptr) break;
    step.inputs[static_cast<std::size_t>(step.inputCount++)] = *input;
    inputs_.pop();
  }
}

void TunedStateSource::complete(StepInput& step) noexcept {
  inner_->complete(step);
  while (step.inputCount < kMaxInputsPerStep) {
    const OperatorInput* input = inputs_.front();
    if (input == nullptr) break;
    if (input->action == OperatorAction::SetParameter) {
      step.inputs[static_cast<std::size_t>(step.inputCount++)] = *input;
    }
    inputs_.pop();
  }
}

void SpeedLogSource::complete(StepInput& step) noexcept {
  step.machine = MachineState{};
  step.inputCount = 0;
  if (!began_) began_ = step.block.firstSample;
  if (log_.empty()) return;
  const double t = secondsBetween(*began_, step.block.end()).value;
  const auto after =
      std::lower_bound(log_.begin(), log_.end(), t, [](const Point& p, double time) { return p.time.value < time; });
  double speed = log_.back().speed.value;
  if (after == log_.begin()) {
    speed = log_.front().speed.value;
  } else if (after != log_.end()) {
    const Point& b = *after;
    const Point& a = *(after - 1);
    const double share = (t - a.time.value) / (b.time.value - a.time.value);
    speed = a.speed.value + share * (b.speed.value - a.speed.value);
  }
  step.machine.time = step.block.end();
  step.machine.valid = true;
  step.machine.linkUp = true;  // the log stands for the machine; without a link nobody would believe its speed
  step.machine.programmedSpeed = Rpm(speed);
  step.machine.actualSpeed = Rpm(speed);
}

}  // namespace stillcut::pipeline
