// One simulated cut under one strategy, wired as the program wires it (source, chain, gate, link in one thread and in
// order), with the detector of choice: the program's own, or one that knows the truth. For tests and tables.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/cnc/simulated_machine.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/evaluate/simulation_report.h"
#include "core/milling/simulation/scenario.h"
#include "core/model/cut_setup.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/machine_state_source.h"
#include "core/pipeline/serial_run.h"
#include "core/pipeline/step_loop.h"

namespace stillcut::test {

struct LoopOptions {
  std::string strategy = "stable-pocket";
  std::string detector;                      // empty: the program's default one
  bool ideal = false;                        // the truth instead
  std::optional<StableSpeeds> stableSpeeds;  // empty: the modes are not known
  config::ParamSet params;
  Authority authority = Authority::Auto;  // from the start
  // What a test puts around detector and strategy; empty: nothing.
  std::function<std::unique_ptr<detect::Detector>(std::unique_ptr<detect::Detector>)> wrapDetector;
  std::function<std::unique_ptr<control::Strategy>(std::unique_ptr<control::Strategy>)> wrapStrategy;
};

class LoopRun {
 public:
  // Throws std::runtime_error with one line.
  LoopRun(const milling::Scenario& scenario, const LoopOptions& options);

  // One block under Auto. False: the cut is over.
  bool advance();
  void toEnd();

  const evaluate::SimulationHistory& history() const { return history_; }
  const milling::SimulatedCut& plant() const { return source_.plant(); }
  const pipeline::StepLoop& loop() const { return *loop_; }
  const pipeline::Chain& chain() const { return *chain_; }
  const pipeline::Chain::Step& last() const { return *done_; }
  const StepInput& input() const { return serial_->input(); }
  cnc::SimulatedMachine& machine() { return machine_; }
  void send(const OperatorInput& input) { inputs_.push(input); }
  safety::FlightRecorder& flights() { return chain_->flights(); }
  // The machine goes on telling the speed that it has now.
  void freezeSpeed() { feed_.frozen = input().machine.actualSpeed; }

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
  pipeline::ChainParts parts(const LoopOptions& options);

  std::shared_ptr<milling::PlantPort> port_;
  daq::SimulatedSource source_;
  cnc::SimulatedMachine machine_;
  rt::Mailbox<OverrideCommand> commands_;
  rt::Mailbox<MachineState> states_;
  rt::SpscRing<OperatorInput> inputs_{8};
  Feed feed_;
  pipeline::DeviceStepSource steps_;
  ManualClock clock_;
  std::unique_ptr<pipeline::Chain> chain_;
  std::unique_ptr<pipeline::StepLoop> loop_;
  std::unique_ptr<pipeline::LinkRunner> link_;
  std::unique_ptr<pipeline::SerialRun> serial_;
  const pipeline::Chain::Step* done_ = nullptr;
  evaluate::SimulationHistory history_;
};

// One of resources/scenarios, without its folder and ending. Throws std::runtime_error with one line.
milling::Scenario scenarioNamed(const std::string& name);

// The whole cut, and what became of it against `alone`, the same cut under "monitor".
evaluate::SimulationReport runLoop(const milling::Scenario& scenario, const LoopOptions& options,
                                   const evaluate::SimulationHistory& alone);
evaluate::SimulationHistory runAlone(const milling::Scenario& scenario);

}  // namespace stillcut::test
