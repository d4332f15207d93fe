#include "core/pipeline/chain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/control/common_reasons.h"
#include "core/model/event_slots.h"
#include "core/safety/gate_checks.h"

namespace stillcut::pipeline {
namespace {

double rms(std::span<const double> x) {
  double sum = 0.0;
  for (double v : x) sum += v * v;
  return x.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(x.size()));
}

// A verdict with a number that is not one must not reach the strategy, whatever it claims.
bool sound(const Verdict& v) {
  return isFinite(v.frequency) && isFinite(v.frequencySd) && isFinite(v.severity) && isFinite(v.spindle) &&
         isFinite(v.sinceOnset) && isFinite(v.feedSinceOnset);
}

// One number that is none would stay in every filter that follows the machine. The gate sees what was really read.
MachineState believable(const MachineState& m) {
  if (safety::plausible(m)) return m;
  MachineState unknown;
  unknown.time = m.time;
  unknown.linkUp = m.linkUp;
  return unknown;
}

Verdict faultVerdict(const detect::ConditionedBlock& block, int detector) {
  Verdict v;
  v.time = block.end();
  v.blockSequence = block.sequence;
  v.phase = block.phase;
  v.reason = {ReasonCode::DetectorFault, {static_cast<double>(detector), 0.0, 0.0, 0.0}};
  return v;
}

// A method may throw in any of its calls; a fault of one is no end of the program. False: it did.
template <class Call>
bool withoutThrow(Call&& call) noexcept {
  try {
    call();
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace

Chain::Chain(ChainParts parts) : parts_(std::move(parts)), inCharge_(parts_.inCharge) {
  const auto count = static_cast<int>(parts_.detectors.size());
  if (count < 1 || count > kMaxDetectors) throw std::runtime_error("a chain needs 1 to 6 detectors");
  if (parts_.inCharge < 0 || parts_.inCharge >= count || parts_.fallback >= count) {
    throw std::runtime_error("the detector in charge or its fallback is not among the enabled ones");
  }
  if (!parts_.strategy) throw std::runtime_error("a chain needs a strategy");
}

void Chain::prepare(const CutSetup& setup, const config::ParamSet& params, const safety::GateLimits& limits) {
  params_ = params;
  for (const config::ParamDecl* decl : parts_.tunable) {
    if (const Status set = params_.set(*decl, params.real(*decl), "chain"); !set)
      throw std::runtime_error(set.error().line());
  }
  conditioner_.prepare(setup, params);
  for (auto& detector : parts_.detectors) detector->prepare(setup, params);
  parts_.strategy->prepare(setup, params);
  setup_ = setup;
  advice_.prepare(setup, params, parts_.strategy->describe().id);
  gate_.prepare(limits);
  gateSaid_ = {};
  gateSaid_.autoAllowed = limits.autoAllowed;
  flights_.prepare(Seconds(setup.blockFrames / setup.rate.value));
  inCharge_ = parts_.inCharge;
  perturbation_ = findIndicator("h");
  coherence_ = findIndicator("gamma_max");
  energy_ = findIndicator("energy");
  strategyFailed_ = false;
  saidFault_.fill(false);
  dead_.fill(false);
  started_ = false;
}

Chain::Indicator Chain::findIndicator(std::string_view name) const {
  for (std::size_t d = 0; d < parts_.detectors.size(); ++d) {
    const auto names = parts_.detectors[d]->describe().indicators;
    const auto at = std::find(names.begin(), names.end(), name);
    if (at != names.end()) return {d, static_cast<std::size_t>(at - names.begin()), true};
  }
  return {};
}

double Chain::read(const Indicator& indicator) const noexcept {
  if (!indicator.known) return -1.0;
  const Verdict& verdict = step_.output.verdicts[indicator.detector];
  const double value = verdict.indicators[indicator.index];
  return verdict.valid && std::isfinite(value) ? value : -1.0;
}

const Chain::Step& Chain::process(const StepInput& input) noexcept {
  step_ = Step{};
  dt_ = started_ ? secondsBetween(previous_, input.block.end()) : Seconds(input.block.frames / input.block.rate.value);
  previous_ = input.block.end();
  started_ = true;

  takeParameters(input);
  machine_ = believable(input.machine);
  const detect::ConditionedBlock& block = conditioner_.process(input.block, machine_);
  step_.vibrationRms = rms(block.channel(0));
  step_.feed = block.feed;
  step_.sensors = &conditioner_.sensors();
  runDetectors(block);
  updateStrategyAuthority(input);
  step_.output.request = askStrategy(input);
  step_.strategyFailed = strategyFailed_;
  runGate(input);
  return step_;
}

// What is no parameter of ours, locked or out of range changes nothing.
void Chain::takeParameters(const StepInput& input) noexcept {
  bool changed = false;
  for (int i = 0; i < input.inputCount; ++i) {
    const OperatorInput& asked = input.inputs[static_cast<std::size_t>(i)];
    if (asked.action != OperatorAction::SetParameter) continue;
    for (const config::ParamDecl* decl : parts_.tunable) {
      if (config::parameterId(decl->key) == asked.parameter) changed = params_.replace(*decl, asked.value) || changed;
    }
  }
  if (!changed) return;
  conditioner_.retune(params_);
  for (int i = 0; i < static_cast<int>(parts_.detectors.size()); ++i) {
    if (!withoutThrow([&] { parts_.detectors[static_cast<std::size_t>(i)]->retune(params_); })) {
      failDetector(i, input.block.end());
    }
  }
  strategyFailed_ = !withoutThrow([&] {
    parts_.strategy->retune(params_);
    advice_.retune(params_);
  }) || strategyFailed_;
}

void Chain::runDetectors(const detect::ConditionedBlock& block) noexcept {
  StepOutput& out = step_.output;
  out.verdictCount = static_cast<int>(parts_.detectors.size());
  for (int i = 0; i < out.verdictCount; ++i) {
    Verdict& verdict = out.verdicts[static_cast<std::size_t>(i)];
    const auto k = static_cast<std::size_t>(i);
    const bool ran = !dead_[k] && withoutThrow([&] { verdict = parts_.detectors[k]->process(block); });
    if (ran && sound(verdict)) continue;
    verdict = faultVerdict(block, i);
    failDetector(i, block.end());
  }
  out.inCharge = inCharge_;
}

void Chain::failDetector(int detector, Instant now) noexcept {
  const auto k = static_cast<std::size_t>(detector);
  step_.detectorFailed = true;
  reportDetectorFault(detector, now);
  dead_[k] = dead_[k] || !withoutThrow([&] { parts_.detectors[k]->reset(); });
  if (detector == inCharge_ && parts_.fallback >= 0 && parts_.fallback != detector) inCharge_ = parts_.fallback;
}

void Chain::reportDetectorFault(int detector, Instant now) noexcept {
  bool& said = saidFault_[static_cast<std::size_t>(detector)];
  if (said) return;
  said = true;
  const Reason why{ReasonCode::DetectorFault, {static_cast<double>(detector)}};
  keep({.time = now, .number = 0, .level = EventLevel::Fault, .reason = why});
}

void Chain::keep(const Event& event) noexcept {
  step_.eventsLost += addEvent(step_.output.events, step_.output.eventCount, event);
}

void Chain::updateStrategyAuthority(const StepInput& input) noexcept {
  for (int i = 0; i < input.inputCount; ++i) {
    const OperatorInput& asked = input.inputs[static_cast<std::size_t>(i)];
    const Authority granted = asked.action == OperatorAction::GrantBySimulation ? Authority::Auto : asked.authority;
    const bool asksFor =
        asked.action == OperatorAction::SetAuthority || asked.action == OperatorAction::GrantBySimulation;
    // The same again, or one that the gate refuses, changes nothing: what is in force keeps its author.
    const bool another = asksFor && granted != gateSaid_.authority && safety::grants(granted, gateSaid_.autoAllowed);
    if (another || asked.action == OperatorAction::BackToProgrammed) {
      strategyFailed_ = !withoutThrow([&] { parts_.strategy->relinquish(); }) || strategyFailed_;
    }
  }
}

OverrideRequest Chain::askStrategy(const StepInput& input) noexcept {
  const Verdict& verdict = step_.output.verdicts[static_cast<std::size_t>(inCharge_)];
  const control::StrategyInput seen{.now = input.block.end(),
                                    .dt = dt_,
                                    .verdict = verdict,
                                    .machine = machineSeenByRequests(verdict, input.block.end()),
                                    .perturbation = read(perturbation_),
                                    .vibration = step_.vibrationRms,
                                    .coherence = read(coherence_),
                                    .energy = read(energy_)};
  if (!strategyFailed_) {
    OverrideRequest request;
    if (withoutThrow([&] { request = parts_.strategy->decide(seen); })) {
      advise(seen, request);
      return request;
    }
    strategyFailed_ = true;  // never asked again; the gate lets go at once
  }
  OverrideRequest none;
  none.time = input.block.end();
  none.reason = control::monitoringAt(seen);
  return none;
}

// A fault of who only advises is a fault of the strategy: nobody knows what else it got wrong.
void Chain::advise(const control::StrategyInput& seen, const OverrideRequest& asked) noexcept {
  strategyFailed_ = !withoutThrow([&] { step_.advice = advice_.look(seen, asked); }) || strategyFailed_;
}

// Without a machine the cut is as it was set up, for a strategy whose advice a user may follow; the gate sees what was
// really read.
MachineState Chain::machineSeenByRequests(const Verdict& verdict, Instant now) const noexcept {
  if (control::neverRead(machine_)) return control::machineAsSetUp(setup_, verdict.spindle, now);
  MachineState seen = machine_;
  if (gateSaid_.knobs) {
    seen.operatorSpeed = gateSaid_.knobs->speed;
    seen.operatorFeed = gateSaid_.knobs->feed;
  }
  return seen;
}

void Chain::runGate(const StepInput& input) noexcept {
  StepOutput& out = step_.output;
  const std::span<const OperatorInput> inputs(input.inputs.data(), static_cast<std::size_t>(input.inputCount));
  const safety::GateInput in{.now = input.block.end(),
                             .dt = dt_,
                             .request = out.request,
                             .verdict = out.verdicts[static_cast<std::size_t>(inCharge_)],
                             .machine = input.machine,
                             .vibration = step_.vibrationRms,
                             .strategyFailed = strategyFailed_,
                             .inputs = inputs};
  step_.gate = gate_.step(in);
  const safety::GateOutput& gate = step_.gate;
  gateSaid_ = {gate.authority, gate.autoAllowed, gate.knobs};
  flights_.push(safety::flightEntry(in, gate));
  // So far the step has reported the detectors only; the gate's own cause follows.
  for (int i = 0; i < out.eventCount; ++i) flights_.capture(out.events[static_cast<std::size_t>(i)].reason, in.now);
  if (gate.flight) flights_.capture(gate.flightCause, in.now);
  if (gate.adviceOpen) step_.advice = advice_.take(gate.advice, machine_);
  out.authority = gate.authority;
  out.hasCommand = gate.command.has_value();
  if (gate.command) out.command = gate.command->record();
  step_.eventsLost += gate.eventsLost;
  for (int i = 0; i < gate.eventCount; ++i) keep(gate.events[static_cast<std::size_t>(i)]);
}

}  // namespace stillcut::pipeline
