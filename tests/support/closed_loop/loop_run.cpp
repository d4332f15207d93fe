#include "tests/support/closed_loop/loop_run.h"

#include <stdexcept>
#include <utility>

#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/safety/gate_limits.h"
#include "tests/support/closed_loop/ideal_detector.h"

namespace stillcut::test {
namespace {

template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().line());
  return std::move(result).value();
}

}  // namespace

LoopRun::LoopRun(const milling::Scenario& scenario, const LoopOptions& options)
    : port_(std::make_shared<milling::PlantPort>()),
      source_(scenario, 0, port_),
      machine_(scenario, port_),
      feed_(states_, inputs_),
      steps_(source_) {
  CutSetup setup = scenario.cutSetup();
  setup.stableSpeeds = options.stableSpeeds;
  config::ParamSet params = options.params;
  const cnc::LinkInfo machine = machine_.describe();
  const config::MachineOverrides reach{machine.lowestSpeed, machine.highestSpeed, machine.lowestFeed,
                                       machine.highestFeed};
  if (const Status s = config::narrowToMachine(params, reach, "machine"); !s) {
    throw std::runtime_error(s.error().line());
  }
  safety::GateLimits limits = must(safety::gateLimits(params, setup, "settings"));
  limits.autoAllowed = true;
  const daq::SourceFormat format = must(source_.open());
  chain_ = std::make_unique<pipeline::Chain>(parts(options));
  chain_->prepare(setup, params, limits);
  loop_ = std::make_unique<pipeline::StepLoop>(
      pipeline::StepLoopParts{*chain_, feed_, commands_, nullptr, nullptr, clock_});
  link_ = std::make_unique<pipeline::LinkRunner>(machine_, commands_, states_);
  serial_ = std::make_unique<pipeline::SerialRun>(pipeline::SerialParts{steps_, format, *loop_, link_.get(), &clock_});
  if (options.authority != Authority::Off) send({OperatorAction::SetAuthority, options.authority});
}

pipeline::ChainParts LoopRun::parts(const LoopOptions& options) {
  pipeline::ChainParts parts;
  if (options.ideal) {
    parts.detectors.push_back(std::make_unique<IdealDetector>(source_.plant()));
  } else {
    const std::string id = options.detector.empty() ? std::string(detect::kDefaultDetector) : options.detector;
    parts.detectors.push_back(must(detect::makeDetector(id)));
  }
  parts.strategy = must(control::makeStrategy(options.strategy));
  const std::string needed(parts.strategy->describe().requiredDetector);
  if (!options.ideal && !needed.empty() && needed != parts.detectors.front()->describe().id) {
    parts.detectors.push_back(must(detect::makeDetector(needed)));
  }
  if (options.wrapDetector) parts.detectors.front() = options.wrapDetector(std::move(parts.detectors.front()));
  if (options.wrapStrategy) parts.strategy = options.wrapStrategy(std::move(parts.strategy));
  return parts;
}

bool LoopRun::advance() {
  done_ = serial_->next();
  if (done_ == nullptr) {
    history_.finish(source_.plant());
    return false;
  }
  history_.observe(serial_->input(), done_->output, source_.plant());
  return true;
}

void LoopRun::toEnd() {
  while (advance()) {
  }
}

milling::Scenario scenarioNamed(const std::string& name) {
  return must(milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/" + name + ".toml"));
}

evaluate::SimulationReport runLoop(const milling::Scenario& scenario, const LoopOptions& options,
                                   const evaluate::SimulationHistory& alone) {
  LoopRun run(scenario, options);
  run.toEnd();
  evaluate::SimulationReport result = evaluate::report(run.history(), alone, run.plant());
  result.strategy = options.strategy;
  return result;
}

evaluate::SimulationHistory runAlone(const milling::Scenario& scenario) {
  LoopOptions options;
  options.strategy = "monitor";
  options.ideal = true;
  LoopRun run(scenario, options);
  run.toEnd();
  return run.history();
}

}  // namespace stillcut::test
