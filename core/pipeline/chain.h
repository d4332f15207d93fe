// Chain: hops 2 to 5 of the way of one block, one call after another on the worker thread:
// conditioner, every enabled detector, the strategy in charge, the gate.
// Thread: prepare() and the constructor on the set-up thread; process() on the worker, real-time.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/config/param_set.h"
#include "core/control/standing_advice.h"
#include "core/control/strategy.h"
#include "core/detect/detector.h"
#include "core/model/cut_setup.h"
#include "core/model/sensor_status.h"
#include "core/model/step_record.h"
#include "core/safety/flight_recorder.h"
#include "core/safety/override_gate.h"
#include "core/sensing/conditioner.h"

namespace stillcut::pipeline {

struct ChainParts {
  std::vector<std::unique_ptr<detect::Detector>> detectors;  // 1 .. kMaxDetectors
  int inCharge = 0;                                          // whose verdict the strategy follows
  int fallback = -1;  // who follows when it fails; -1: nobody, verdicts become invalid
  std::unique_ptr<control::Strategy> strategy;
  std::vector<const config::ParamDecl*> tunable;  // may be changed by OperatorAction::SetParameter; live for good
};

class Chain {
 public:
  explicit Chain(ChainParts parts);

  // Sizes everything. May allocate and throw std::runtime_error with one clear line.
  void prepare(const CutSetup& setup, const config::ParamSet& params, const safety::GateLimits& limits);

  struct Step {
    StepOutput output;
    safety::GateOutput gate;    // authority, advice, holds
    double vibrationRms = 0.0;  // first channel, SI
    MetresPerSecond feed{};     // the machine's, or as set up; 0: unknown
    SpeedAdvice advice;         // under every authority, and without a machine
    const SensorStatus* sensors = nullptr;
    bool strategyFailed = false;  // now or earlier: monitoring only until the next prepare()
    bool detectorFailed = false;
    int eventsLost = 0;  // for want of room; the most important were kept
  };
  // One block with its machine state and operator inputs. The result is good until the next call.
  const Step& process(const StepInput& input) noexcept;

  const ChainParts& parts() const { return parts_; }
  const detect::Conditioner& conditioner() const { return conditioner_; }
  int inCharge() const { return inCharge_; }
  // The last seconds before each fault, refusal and change of authority; one other thread takes and writes them.
  safety::FlightRecorder& flights() { return flights_; }

 private:
  void takeParameters(const StepInput& input) noexcept;
  void failDetector(int detector, Instant now) noexcept;
  void runDetectors(const detect::ConditionedBlock& block) noexcept;
  void updateStrategyAuthority(const StepInput& input) noexcept;
  OverrideRequest askStrategy(const StepInput& input) noexcept;
  void reportDetectorFault(int detector, Instant now) noexcept;
  void keep(const Event& event) noexcept;
  struct Indicator {
    std::size_t detector = 0, index = 0;
    bool known = false;
  };
  Indicator findIndicator(std::string_view name) const;
  // Its newest value where the detector's verdict is valid; negative: unknown.
  double read(const Indicator& indicator) const noexcept;
  void runGate(const StepInput& input) noexcept;
  MachineState machineSeenByRequests(const Verdict& verdict, Instant now) const noexcept;
  void advise(const control::StrategyInput& seen, const OverrideRequest& asked) noexcept;

  ChainParts parts_;
  config::ParamSet params_;  // of the tunable ones, every key set
  CutSetup setup_;
  control::StandingAdvice advice_;
  detect::Conditioner conditioner_;
  safety::OverrideGate gate_;
  struct GateSaid {
    Authority authority = Authority::Off;
    bool autoAllowed = false;
    std::optional<safety::WishKnobs> knobs;
  } gateSaid_;  // in the step before
  safety::FlightRecorder flights_;
  int inCharge_ = 0;
  bool strategyFailed_ = false;
  Indicator perturbation_, coherence_, energy_;  // what strategies weigh besides the verdict in charge
  std::array<bool, kMaxDetectors> saidFault_{};  // of each detector, once
  std::array<bool, kMaxDetectors> dead_{};       // a detector that cannot be reset: not asked until the next prepare()
  bool started_ = false;
  Instant previous_{};  // end of the previous block
  Seconds dt_{};
  MachineState machine_;  // of this step; invalid when what was read makes no sense
  Step step_;
};

}  // namespace stillcut::pipeline
