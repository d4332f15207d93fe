// One simulated cut under Auto whose sensor or link is not to be believed: samples come late and in bursts, or are
// spoiled on their way; the machine tells a speed that it does not have. Wired as the program wires it, in virtual
// time: the link's thread goes on while the worker waits for samples. For tests.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cnc/simulated_machine.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/milling/simulation/scenario.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/machine_state_source.h"
#include "core/pipeline/step_loop.h"

namespace stillcut::test {

struct Roughness {
  std::string strategy = "stable-pocket";
  Seconds burst{};                                    // samples come together, once in this time; 0: each block at once
  std::function<void(SampleBlock&, double t)> spoil;  // t: of its first frame
  std::optional<double> speedFreezesAt;               // [s] the machine goes on telling the speed it has then
};

class RoughRun {
 public:
  // Throws std::runtime_error with one line.
  RoughRun(const milling::Scenario& scenario, Roughness roughness);

  void toEnd();

  // Ways away from 100 %, each from rest or after a way back: what a person at the machine calls a swing.
  int swings() const { return swings_; }
  int events(ReasonCode code) const;
  Authority authority() const { return done_ != nullptr ? done_->gate.authority : Authority::Off; }
  bool commanding() const { return done_ != nullptr && done_->gate.commanding; }
  MachineState machine() const { return *port_->state(); }
  std::string story() const { return story_; }  // its events, one a line

 private:
  struct Feed final : pipeline::MachineStateSource {
    Feed(rt::Mailbox<MachineState>& states, rt::SpscRing<OperatorInput>& inputs) : live(states, inputs) {}
    void complete(StepInput& step) noexcept override {
      live.complete(step);
      if (frozen) step.machine.actualSpeed = *frozen;
    }
    pipeline::LiveStateSource live;
    std::optional<Rpm> frozen;
  };
  void deliver();
  void process(StepInput& input);
  void countSwing(const CommandRecord& command);

  milling::Scenario scenario_;
  Roughness rough_;
  std::shared_ptr<milling::PlantPort> port_;
  daq::SimulatedSource source_;
  cnc::SimulatedMachine machine_;
  rt::Mailbox<OverrideCommand> commands_;
  rt::Mailbox<MachineState> states_;
  rt::SpscRing<OperatorInput> inputs_{8};
  Feed feed_;
  ManualClock clock_;
  std::unique_ptr<pipeline::Chain> chain_;
  std::unique_ptr<pipeline::StepLoop> loop_;
  std::unique_ptr<pipeline::LinkRunner> link_;
  std::vector<StepInput> waiting_;
  std::size_t waits_ = 0;
  const pipeline::Chain::Step* done_ = nullptr;
  std::vector<ReasonCode> said_;
  std::string story_;
  double last_ = 1.0;  // speed sent
  Instant moved_{};
  bool outward_ = false;
  int swings_ = 0;
};

}  // namespace stillcut::test
