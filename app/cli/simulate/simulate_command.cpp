// stillcut-cli simulate SCENARIO.toml [--strategy ID[,ID]] [--detector ID] [--seed N] [--out FILE.h5|.wav]
//                       [--series OUT.csv|FOLDER] [--json]

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "app/cli/out_path.h"
#include "app/cli/setting_options.h"
#include "app/cli/simulate/simulate_active.h"
#include "app/cli/simulate/simulated_files.h"
#include "app/compose/resource_folder.h"
#include "app/compose/scenario_rig.h"
#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/evaluate/simulation_report.h"
#include "core/milling/simulation/scenario.h"
#include "core/session/session_folder.h"

namespace stillcut::app {
namespace {

struct SimulateOptions {
  std::string scenario, out, pathRecord, detector, series;
  std::vector<std::string> strategies;  // empty: the scenario's own
  std::uint64_t seed = 0;
  bool json = false;
  bool modesKnown = false;
  SettingOptions settings;

  // Of several strategies each has a file of its own in the folder.
  std::string seriesOf(const std::string& strategy) const {
    const bool folder = !series.empty() && strategies.size() > 1;
    return folder ? (std::filesystem::path(series) / (strategy + ".csv")).string() : series;
  }
};

struct FinishedRun {
  ScenarioRig built;
  evaluate::SimulationHistory history;
};

struct RunFiles {
  std::string out, series;
};

Result<FinishedRun> runOnce(const milling::Scenario& scenario, const ScenarioOptions& options, const RunFiles& files) {
  auto built = buildScenarioRig(scenario, options);
  if (!built) return built.error();
  FinishedRun run{std::move(built).value(), {}};
  const milling::SimulatedCut& plant = run.built.source->plant();
  auto file = SimulatedFile::open(files.out, *run.built.rig, milling::scenarioText(scenario));
  if (!file) return file.error();
  SimulatedSeries series;
  // The machine exists only in this program: what is tried on it can be left to the strategy.
  run.built.rig->send({OperatorAction::GrantBySimulation, Authority::Auto});
  run.built.rig->runToEnd([&](const StepInput& input, const StepOutput& output) {
    run.history.observe(input, output, plant);
    if (!files.series.empty()) series.observe(input, output, plant, run.built.rig->chain());
    file->add(input.block, plant);
  });
  run.history.finish(plant);
  Status closed = file->close(plant);
  if (closed) closed = series.write(files.series);
  if (!closed) {
    std::remove(files.out.c_str());  // a session grows in place, and half of one is not what was asked for
    return closed.error();
  }
  return run;
}

Status checkStrategy(const std::string& id) {
  if (id == "active") return Done{};
  const auto strategy = control::makeStrategy(id);
  return strategy ? Status(Done{}) : Status(strategy.error());
}

Status checkSeries(const SimulateOptions& options) {
  if (options.series.empty()) return Done{};
  if (options.strategies.size() == 1) return checkOutPath(options.series, options.scenario);
  std::error_code unknown;
  if (std::filesystem::is_directory(options.series, unknown)) return Done{};
  return Error{options.series, message("cannot be written"),
               message("%1 of several strategies needs a folder that is there", "--series")};
}

// What can be known to be wrong before the cut is run.
Status check(const SimulateOptions& options, const milling::Scenario& scenario) {
  for (const std::string& id : options.strategies) {
    if (Status known = checkStrategy(id); !known) return known;
  }
  if (Status known = checkStrategy(scenario.strategy); !known) return known;
  if (!options.out.empty() && !options.out.ends_with(".wav") && !options.out.ends_with(".h5")) {
    return Error{options.out, message("cannot be written"), message("the suffix must be .h5 or .wav")};
  }
  if (!options.out.empty() && options.strategies.size() > 1)
    return Error{"--out", message("records one cut"), message("name one strategy")};
  const bool active = options.strategies == std::vector<std::string>{"active"};
  if (!options.pathRecord.empty() && !active)
    return Error{"--path-record", message("needs --strategy active"), message("no other strategy identifies a path")};
  if (!options.series.empty() && std::count(options.strategies.begin(), options.strategies.end(), "active") > 0)
    return Error{"--series", message("is not written of --strategy active"), message("no detector runs in its loop")};
  if (Status usable = checkSeries(options); !usable) return usable;
  if (Status usable = checkOutPath(options.pathRecord, options.out); !usable) return usable;
  if (Status usable = checkOutPath(options.out); !usable) return usable;
  return record::checkReplaceable(options.out, record::MayReplace::SimulatedSession);
}

// The same cut with one strategy after the other, each against the cut left alone.
class Comparison {
 public:
  Comparison(const SimulateOptions& given, const milling::Scenario& scenario, const config::ParamSet& params,
             const std::string& detector)
      : given_(given), scenario_(scenario) {
    options_.seed = given.seed;
    options_.params = params;
    if (!detector.empty()) options_.methods.detectors = {detector};
  }

  int run(const std::string& strategy) {
    if (strategy == "active")
      return simulateActive(scenario_, options_.params, given_.seed, {given_.out, given_.pathRecord}, given_.json);
    const auto begin = std::chrono::steady_clock::now();
    if (const Status left = leaveAlone(); !left) return fail(left.error());
    options_.modesKnown = given_.modesKnown;
    options_.methods.strategy = strategy;
    const auto controlled = runOnce(scenario_, options_, {given_.out, given_.seriesOf(strategy)});
    if (!controlled) return fail(controlled.error());
    evaluate::SimulationReport result = report(controlled->history, alone_->history, controlled->built.source->plant());
    result.strategy = strategy;
    if (given_.json) {
      printJsonLine(toJson(result));
      return kExitDone;
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    std::printf("%s", toText(result).c_str());
    if (given_.strategies.size() > 1) return kExitDone;
    std::printf("  %-26s %10.1f times real time\n", "both cuts simulated at",
                2.0 * scenario_.programme.duration.value / taken.count());
    std::printf("(Auto is granted because this machine is simulated.)\n");
    return kExitDone;
  }

 private:
  Status leaveAlone() {
    if (alone_) return Done{};
    options_.modesKnown = false;
    options_.methods.strategy = "monitor";
    auto alone = runOnce(scenario_, options_, {});
    if (!alone) return alone.error();
    alone_.emplace(std::move(alone).value());
    return Done{};
  }

  const SimulateOptions& given_;
  const milling::Scenario& scenario_;
  ScenarioOptions options_;
  std::optional<FinishedRun> alone_;
};

int simulate(SimulateOptions options) {
  auto scenario = milling::loadScenario(foundFile(options.scenario));
  if (!scenario) return fail(scenario.error());
  scenario->grantsAuto = true;
  if (options.strategies.empty()) options.strategies.push_back(scenario->strategy);
  const auto settings = options.settings.read();
  if (!settings) return fail(settings.error());
  if (const Status usable = check(options, *scenario); !usable) return fail(usable.error());
  const std::string detector = options.detector.empty() ? settings->detector : options.detector;
  if (!detector.empty()) {
    if (const auto known = detect::makeDetector(detector); !known) return fail(known.error());
  }
  Comparison comparison(options, *scenario, settings->params, detector);
  for (const std::string& strategy : options.strategies) {
    if (const int code = comparison.run(strategy); code != kExitDone) return code;
  }
  return kExitDone;
}

}  // namespace

void addSimulate(CLI::App& app, int& exitCode) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", "Run a simulated cut and say what became of it");
  command->add_option("SCENARIO", options->scenario, "Scenario (.toml)")->required();
  command
      ->add_option("--strategy", options->strategies,
                   "Strategy in charge, or several (A,B): one after the other; left out: the scenario's own")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name(strategyWords());
  command->add_option("--detector", options->detector, "Detector in charge; left out: the default one")
      ->type_name(detectorWords(false));
  command->add_option("--seed", options->seed, "Seed of the noise; left out: the scenario's own");
  command->add_option("--out", options->out, "Record to FILE.h5 (everything) or FILE.wav (samples)");
  command->add_option("--path-record", options->pathRecord,
                      "Of --strategy active: keep what the paths were identified from (.csv)");
  command->add_flag("--modes-known", options->modesKnown,
                    "The strategy knows the scenario's modes: it checks its targets against the stability lobes");
  command->add_option("--series", options->series,
                      "Write detectors, machine and cut of every block to OUT.csv; of several strategies: a folder");
  command->add_flag("--json", options->json, "Print one JSON object a strategy, each in a line");
  options->settings.add(*command);
  command->callback([options, &exitCode] { exitCode = simulate(*options); });
}

}  // namespace stillcut::app
