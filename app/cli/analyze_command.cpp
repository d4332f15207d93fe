// stillcut-cli analyze RECORDING ...: the detectors on a recording, side by side.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/analysis_table.h"
#include "app/cli/command.h"
#include "app/cli/out_path.h"
#include "app/cli/reading_options.h"
#include "app/cli/setting_options.h"
#include "app/compose/recording_rig.h"
#include "core/detect/registry.h"
#include "core/evaluate/auto_value_log.h"
#include "core/evaluate/series_log.h"
#include "core/evaluate/verdict_log.h"
#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

constexpr int kMostTeeth = 64;
constexpr double kHighestSpeed = 1e6;  // [rpm]

struct AnalyzeOptions {
  std::string recording, speedLog, detector, events, series;
  int teeth = 0;
  double speed = 0.0;
  bool json = false, values = false, truth = false, teethGiven = false, speedGiven = false;
  ReadingOptions reading;
  SettingOptions settings;
};

std::vector<std::string> detectorsFor(const std::string& wanted, const std::string& configured) {
  const std::string inCharge = configured.empty() ? std::string(detect::kDefaultDetector) : configured;
  if (wanted.empty()) return {inCharge};
  if (wanted != "all") return {wanted};
  std::vector<std::string> all{inCharge};
  for (const auto& row : detect::detectorTable()) {
    if (row.id != inCharge) all.emplace_back(row.id);
  }
  return all;
}

Status checkOptions(const AnalyzeOptions& given) {
  if (given.teethGiven && (given.teeth < 1 || given.teeth > kMostTeeth)) {
    return Error{"--teeth", message("%1 is out of range", std::to_string(given.teeth)),
                 message("allowed: 1 to %1", std::to_string(kMostTeeth))};
  }
  if (given.speedGiven && !(given.speed > 0.0 && given.speed <= kHighestSpeed)) {
    return Error{"--speed", message("the speed must be above zero and at most 1e6 rpm")};
  }
  if (Status events = checkOutPath(given.events, given.recording); !events) return events;
  if (Status series = checkOutPath(given.series, given.recording); !series) return series;
  if (!given.events.empty() && given.events == given.series) {
    return Error{given.events, message("cannot be written"), message("--events and --series name the same file")};
  }
  return Done{};
}

Result<RecordingOptions> understand(const AnalyzeOptions& given) {
  if (const Status usable = checkOptions(given); !usable) return usable.error();
  RecordingOptions options;
  options.teeth = given.teeth;
  options.speed = Rpm(given.speed);
  auto reading = given.reading.understand();
  if (!reading) return reading.error();
  options.read = std::move(reading).value();
  if (!given.speedLog.empty()) {
    auto log = readSpeedLog(given.speedLog);
    if (!log) return log.error();
    options.log = std::move(log).value();
  }
  auto settings = given.settings.read();
  if (!settings) return settings.error();
  options.methods.detectors = detectorsFor(given.detector, settings->detector);
  options.params = std::move(settings->params);
  return options;
}

// What the answer rests on that nobody has told.
std::vector<std::string> remarks(const CutSetup& setup, const record::RecordingFormat& format, bool measuredSpeed,
                                 const std::vector<evaluate::VerdictLog>& logs) {
  std::vector<std::string> lines;
  for (const Message& note : format.notes) lines.push_back(text(note));
  if (setup.teeth <= 0) lines.emplace_back("teeth not told (--teeth): judged by spindle harmonics alone");
  if (setup.nominalSpeed.value > 0.0 || measuredSpeed) return lines;
  const double found_Hz = logs.empty() ? 0.0 : logs.front().summary().spindle_Hz;
  char text[96];
  std::snprintf(text, sizeof text, "taken from the signal, on average %.0f rpm", 60.0 * found_Hz);
  lines.push_back("speed not told (--speed, --speed-log): " +
                  std::string(found_Hz > 0.0 ? text : "none found in the signal, nothing can be judged against it"));
  return lines;
}

// Both or neither.
Status writeFiles(const AnalyzeOptions& given, const std::vector<evaluate::VerdictLog>& logs,
                  const std::optional<evaluate::SeriesLog>& series) {
  if (!given.events.empty()) {
    nlohmann::json array = nlohmann::json::array();
    for (const evaluate::VerdictLog& log : logs) log.appendEvents(array);
    if (Status s = writeFileAtomically(given.events, array.dump(1) + "\n"); !s) return s;
  }
  if (series) {
    if (Status s = series->write(given.series); !s) {
      if (!given.events.empty()) std::remove(given.events.c_str());
      return s;
    }
  }
  return Done{};
}

int analyze(const AnalyzeOptions& given) {
  const auto options = understand(given);
  if (!options) return fail(options.error());
  auto built = buildRecordingRig(given.recording, *options);
  if (!built) return fail(built.error());
  Rig& rig = *built->rig;

  auto truth = given.truth ? evaluate::truthOf(given.recording) : evaluate::truthIn(given.recording);
  if (!truth) return fail(truth.error());
  std::vector<detect::DetectorInfo> infos;
  for (const auto& detector : rig.chain().parts().detectors) infos.push_back(detector->describe());
  std::vector<evaluate::VerdictLog> logs;
  std::vector<evaluate::AlarmList> alarms(infos.size());
  std::optional<evaluate::SeriesLog> series;
  std::optional<Instant> begin;
  evaluate::AutoValueLog own(rig.chain());
  rig.runToEnd([&](const StepInput& in, const StepOutput& out) {
    if (!begin) {
      begin = in.block.firstSample;
      for (const auto& info : infos) logs.emplace_back(info.id, *begin);
      if (!given.series.empty()) series.emplace(infos, *begin);
    }
    for (std::size_t d = 0; d < logs.size(); ++d) {
      logs[d].observe(out.verdicts[d]);
      alarms[d].observe(secondsBetween(*begin, out.verdicts[d].time), out.verdicts[d]);
    }
    if (series) series->observe({out.verdicts.data(), logs.size()});
    own.observe();
  });
  if (const Message fault = rig.device().fault(); !fault.empty()) return fail(Error{{}, fault});

  if (const Status s = writeFiles(given, logs, series); !s) return fail(s.error());
  Analysis analysis{
      given.recording, built->format, remarks(rig.setup(), built->format, !options->log.empty(), logs), {}, {}, {}};
  analysis.truth = std::move(truth).value();
  for (std::size_t d = 0; d < logs.size(); ++d) {
    analysis.detectors.push_back(logs[d].summary());
    if (analysis.truth) analysis.scores.push_back(evaluate::scoreAlarms(analysis.truth->spans, alarms[d].alarms()));
  }
  if (given.values || given.json) analysis.own = own.entries();
  given.json ? printJson(analysis) : printTable(analysis);
  return kExitDone;
}

}  // namespace

void addAnalyze(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<AnalyzeOptions>();
  CLI::App* command = app.add_subcommand("analyze", "Run the detectors on a recording");
  command->add_option("RECORDING", o->recording, "Sound file, text table, or Stillcut session")->required();
  auto* teeth = command->add_option("--teeth", o->teeth, "Number of teeth");
  auto* speed = command->add_option("--speed", o->speed, "Spindle speed as programmed [rpm]");
  command->add_option("--speed-log", o->speedLog, "Measured spindle speed: CSV with the header t,rpm")->excludes(speed);
  o->reading.add(*command);
  command->add_option("--detector", o->detector, "Detector id, or all");
  command->add_option("--events", o->events, "Write every change of state to OUT.json");
  command->add_option("--series", o->series, "Write the indicators of every block to OUT.csv");
  command->add_flag("--values", o->values, "Also print what the program set itself, and why");
  command->add_flag("--truth", o->truth, "Compare with what is known of it: TRUTH.csv or NAME_truth.csv beside it");
  command->add_flag("--json", o->json, "Print one JSON object");
  o->settings.add(*command);
  command->callback([o, teeth, speed, &exitCode] {
    o->teethGiven = teeth->count() > 0;
    o->speedGiven = speed->count() > 0;
    exitCode = analyze(*o);
  });
}

}  // namespace stillcut::app
