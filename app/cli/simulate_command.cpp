// stillcut-cli simulate SCENARIO.toml [--strategy ID] [--seed N] [--out FILE.h5|.wav] [--json]

#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/out_path.h"
#include "app/cli/setting_options.h"
#include "app/cli/simulate_active.h"
#include "app/compose/resource_folder.h"
#include "app/compose/scenario_rig.h"
#include "core/control/registry.h"
#include "core/evaluate/simulation_report.h"
#include "core/formats/sound/wav_reader.h"
#include "core/milling/simulation/scenario.h"
#include "core/session/session_folder.h"

namespace stillcut::app {
namespace {

struct SimulateOptions {
  std::string scenario, out, pathRecord;
  std::string strategy{control::kDefaultStrategy};
  std::uint64_t seed = 0;
  bool json = false;
  bool modesKnown = false;
  SettingOptions settings;
};

// What `--out` names: a session (.h5) takes everything and the truth, a sound file (.wav) the samples in SI.
class OutFile {
 public:
  static Result<OutFile> open(const std::string& path, Rig& rig, const std::string& configuration) {
    OutFile out;
    if (path.empty()) return out;
    if (path.ends_with(".wav")) {
      const CutSetup& setup = rig.setup();
      auto wav = record::WavWriter::create(path, static_cast<int>(setup.channels.size()), setup.rate);
      if (!wav) return wav.error();
      out.wav_ = std::move(wav).value();
      for (const ChannelInfo& channel : setup.channels) out.scale_.push_back(channel.scale);
    } else if (path.ends_with(".h5")) {
      if (const Status s = rig.recordTo(path, configuration); !s) return s.error();
      out.session_ = rig.recorder();
    }
    return out;
  }
  void add(const SampleBlock& block, const milling::SimulatedCut& plant) {
    if (wav_ && status_) status_ = wav_->write(block, scale_);
    if (session_ != nullptr && session_->writer() != nullptr && status_) {
      const milling::ChatterTruth& truth = plant.truth();
      status_ = session_->writer()->addTruth("chatter_ratio", block.end(), truth.ratio());
      if (status_) status_ = session_->writer()->addTruth("chatter_counted", block.end(), truth.chatterRatio());
    }
  }
  Status close(const milling::SimulatedCut& plant) {
    if (wav_ && status_) status_ = wav_->finish();
    if (session_ != nullptr && status_) status_ = addTruth(plant);
    if (session_ != nullptr && status_) status_ = session_->finish();
    return status_;
  }

 private:
  Status addTruth(const milling::SimulatedCut& plant) {
    record::SessionWriter* writer = session_->writer();
    if (writer == nullptr) return Error{session_->status().path, session_->status().fault};
    const milling::ChatterOnset onset = plant.truth().onset();
    const std::pair<const char*, double> known[] = {{"onset_1pct_s", onset.at1},
                                                    {"onset_20pct_s", onset.at20},
                                                    {"onset_50pct_s", onset.at50},
                                                    {"chatter_hz", plant.truth().chatterFrequency().value},
                                                    {"chatter_kind", static_cast<double>(plant.truth().kind())},
                                                    {"peak_ratio", plant.truth().peakRatio()},
                                                    {"marked_m", plant.truth().marked().value}};
    for (const auto& [name, value] : known) {
      if (Status s = writer->addTruth(name, value); !s) return s;
    }
    return Done{};
  }

  std::unique_ptr<record::WavWriter> wav_;
  std::vector<double> scale_;
  record::Recorder* session_ = nullptr;
  Status status_{Done{}};
};

struct FinishedRun {
  ScenarioRig built;
  evaluate::SimulationHistory history;
};

Result<FinishedRun> runOnce(const milling::Scenario& scenario, const ScenarioOptions& options, const std::string& out) {
  auto built = buildScenarioRig(scenario, options);
  if (!built) return built.error();
  FinishedRun run{std::move(built).value(), {}};
  const milling::SimulatedCut& plant = run.built.source->plant();
  auto file = OutFile::open(out, *run.built.rig, milling::scenarioText(scenario));
  if (!file) return file.error();
  // The machine exists only in this program: what is tried on it can be left to the strategy.
  run.built.rig->send({OperatorAction::GrantBySimulation, Authority::Auto});
  run.built.rig->runToEnd([&](const StepInput& input, const StepOutput& output) {
    run.history.observe(input, output, plant);
    file->add(input.block, plant);
  });
  run.history.finish(plant);
  if (const Status closed = file->close(plant); !closed) {
    std::remove(out.c_str());  // a session grows in place, and half of one is not what was asked for
    return closed.error();
  }
  return run;
}

Status checkStrategy(const std::string& id) {
  if (id == "active") return Done{};
  const auto strategy = control::makeStrategy(id);
  return strategy ? Status(Done{}) : Status(strategy.error());
}

// What can be known to be wrong before the cut is run. The scenario's own strategy is the desktop's; misspelt, it is
// said here as well.
Status check(const SimulateOptions& options, const milling::Scenario& scenario) {
  for (const std::string& id : {options.strategy, scenario.strategy}) {
    if (Status known = checkStrategy(id); !known) return known;
  }
  if (!options.out.empty() && !options.out.ends_with(".wav") && !options.out.ends_with(".h5")) {
    return Error{options.out, message("cannot be written"), message("the suffix must be .h5 or .wav")};
  }
  if (Status usable = checkOutPath(options.pathRecord, options.out); !usable) return usable;
  if (Status usable = checkOutPath(options.out); !usable) return usable;
  return record::checkReplaceable(options.out, record::MayReplace::SimulatedSession);
}

int simulate(const SimulateOptions& options) {
  auto scenario = milling::loadScenario(foundFile(options.scenario));
  if (!scenario) return fail(scenario.error());
  scenario->grantsAuto = true;
  const auto settings = options.settings.read();
  if (!settings) return fail(settings.error());
  if (const Status usable = check(options, *scenario); !usable) return fail(usable.error());

  if (options.strategy == "active") {
    return simulateActive(*scenario, settings->params, options.seed, {options.out, options.pathRecord}, options.json);
  }
  if (!options.pathRecord.empty()) {
    return fail(
        Error{"--path-record", message("needs --strategy active"), message("no other strategy identifies a path")});
  }
  const auto begin = std::chrono::steady_clock::now();
  ScenarioOptions run;
  run.seed = options.seed;
  run.params = settings->params;
  if (!settings->detector.empty()) run.methods.detectors = {settings->detector};
  run.methods.strategy = "monitor";
  const auto alone = runOnce(*scenario, run, "");
  if (!alone) return fail(alone.error());

  run.modesKnown = options.modesKnown;
  run.methods.strategy = options.strategy;
  const auto controlled = runOnce(*scenario, run, options.out);
  if (!controlled) return fail(controlled.error());
  evaluate::SimulationReport result = report(controlled->history, alone->history, controlled->built.source->plant());
  result.strategy = run.methods.strategy;
  if (options.json) {
    std::printf("%s\n", toJson(result).dump(2).c_str());
  } else {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    std::printf("%s", toText(result).c_str());
    std::printf("  %-26s %10.1f times real time\n", "both cuts simulated at",
                2.0 * scenario->programme.duration.value / taken.count());
    std::printf("(Auto is granted because this machine is simulated.)\n");
  }
  return kExitDone;
}

}  // namespace

void addSimulate(CLI::App& app, int& exitCode) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", "Run a simulated cut and say what became of it");
  command->add_option("SCENARIO", options->scenario, "Scenario (.toml)")->required();
  command->add_option("--strategy", options->strategy, "Strategy in charge; left out: the default one");
  command->add_option("--seed", options->seed, "Seed of the noise; left out: the scenario's own");
  command->add_option("--out", options->out, "Record to FILE.h5 (everything) or FILE.wav (samples)");
  command->add_option("--path-record", options->pathRecord,
                      "Of --strategy active: keep what the paths were identified from (.csv)");
  command->add_flag("--modes-known", options->modesKnown,
                    "The strategy knows the scenario's modes: it checks its targets against the stability lobes");
  command->add_flag("--json", options->json, "Print one JSON object");
  options->settings.add(*command);
  command->callback([options, &exitCode] { exitCode = simulate(*options); });
}

}  // namespace stillcut::app
