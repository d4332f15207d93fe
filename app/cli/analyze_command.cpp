// stillcut-cli analyze RECORDING ...: the detectors on a recording, side by side.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/setting_options.h"
#include "app/compose/recording_rig.h"
#include "app/compose/series_log.h"
#include "app/compose/verdict_log.h"
#include "core/base/atomic_file.h"
#include "core/detect/registry.h"

namespace stillcut::app {
namespace {

struct AnalyzeOptions {
  std::string recording, speedLog, quantity, detector, events, series;
  int teeth = 0;
  double speed = 0.0, rate = 0.0, scale = 0.0;
  std::vector<int> channels;
  bool json = false, teethGiven = false, speedGiven = false, rateGiven = false, scaleGiven = false;
  SettingOptions settings;
};

std::vector<std::string> detectorsFor(const std::string& wanted) {
  if (wanted.empty()) return {std::string(detect::kDefaultDetector)};
  if (wanted != "all") return {wanted};
  std::vector<std::string> all{std::string(detect::kDefaultDetector)};
  for (const auto& row : detect::detectorTable()) {
    if (row.id != detect::kDefaultDetector) all.emplace_back(row.id);
  }
  return all;
}

Result<RecordingOptions> understand(const AnalyzeOptions& given) {
  RecordingOptions options;
  if (given.teethGiven && (given.teeth < 1 || given.teeth > 64)) {
    return Error{"--teeth", std::to_string(given.teeth) + " is out of range", "allowed: 1 to 64"};
  }
  if (given.speedGiven && !(given.speed > 0.0)) return Error{"--speed", "the speed must be above zero", ""};
  if (given.rateGiven && !(given.rate > 0.0)) return Error{"--rate", "the rate must be above zero", ""};
  if (given.scaleGiven && !(std::isfinite(given.scale) && given.scale != 0.0)) {
    return Error{"--scale", "the scale must be a number other than zero", ""};
  }
  options.teeth = given.teeth;
  options.speed = Rpm(given.speed);
  if (given.rateGiven) options.read.rate = Hertz(given.rate);
  if (given.scaleGiven) options.read.scale = given.scale;
  options.read.channels = given.channels;
  if (!given.quantity.empty()) {
    options.read.quantity = sensorQuantityFromName(given.quantity);
    if (!options.read.quantity) {
      return Error{"--quantity", "'" + given.quantity + "' is unknown",
                   "choices: acceleration, velocity, displacement, sound, force, current, speed"};
    }
  }
  if (!given.speedLog.empty()) {
    auto log = readSpeedLog(given.speedLog);
    if (!log) return log.error();
    options.log = std::move(log).value();
  }
  auto params = given.settings.params();
  if (!params) return params.error();
  options.params = std::move(params).value();
  options.methods.detectors = detectorsFor(given.detector);
  return options;
}

void printTable(const record::RecordingFormat& format, const std::vector<VerdictLog>& logs) {
  std::printf("%s, %zu channel(s) at %.6g Hz, %.3f s\n", format.kind.c_str(), format.channels.size(), format.rate.value,
              format.length().value);
  std::printf("%-14s %7s %12s %12s %14s %12s %10s\n", "detector", "alarms", "first alarm", "in alarm", "in chatter",
              "frequency", "worst ER");
  for (const VerdictLog& log : logs) {
    const VerdictLog::Summary s = log.summary();
    if (s.alarms > 0) {
      std::printf("%-14s %7d %10.3f s %10.3f s %12.3f s %9.1f Hz %10.2f\n", s.detector.c_str(), s.alarms,
                  s.firstAlarm_s, s.alarmTime_s, s.chatterTime_s, s.frequency_Hz, s.worstSeverity);
    } else {
      std::printf("%-14s %7d %12s\n", s.detector.c_str(), 0, "-");
    }
    if (s.validTime_s <= 0.0 && !s.lastReason.empty()) {
      std::printf("%-14s no valid verdict: %s\n", "", s.lastReason.c_str());
    }
  }
}

void printJson(const std::string& path, const record::RecordingFormat& format, const std::vector<VerdictLog>& logs) {
  nlohmann::json object{{"recording", path},
                        {"kind", format.kind},
                        {"rate_hz", format.rate.value},
                        {"channels", format.channels.size()},
                        {"length_s", format.length().value},
                        {"detectors", nlohmann::json::array()}};
  for (const VerdictLog& log : logs) {
    nlohmann::json row;
    toJson(row, log.summary());
    object["detectors"].push_back(row);
  }
  std::printf("%s\n", object.dump(2).c_str());
}

int analyze(const AnalyzeOptions& given) {
  const auto options = understand(given);
  if (!options) return fail(options.error());
  auto built = buildRecordingRig(given.recording, *options);
  if (!built) return fail(built.error());
  Rig& rig = *built->rig;

  std::vector<detect::DetectorInfo> infos;
  for (const auto& detector : rig.chain().parts().detectors) infos.push_back(detector->describe());
  std::vector<VerdictLog> logs;
  std::optional<SeriesLog> series;
  rig.runToEnd([&](const StepInput& in, const StepOutput& out) {
    if (logs.empty()) {
      for (const auto& info : infos) logs.emplace_back(info.id, in.block.firstSample);
      if (!given.series.empty()) series.emplace(infos, in.block.firstSample);
    }
    for (std::size_t d = 0; d < logs.size(); ++d) logs[d].observe(out.verdicts[d]);
    if (series) series->observe({out.verdicts.data(), logs.size()});
  });
  if (const std::string fault = rig.device().fault(); !fault.empty()) return fail({fault, "", ""});

  if (!given.events.empty()) {
    nlohmann::json array = nlohmann::json::array();
    for (const VerdictLog& log : logs) log.appendEvents(array);
    if (const Status s = writeFileAtomically(given.events, array.dump(1) + "\n"); !s) return fail(s.error());
  }
  if (series) {
    if (const Status s = series->write(given.series); !s) return fail(s.error());
  }
  if (given.json) {
    printJson(given.recording, built->format, logs);
  } else {
    printTable(built->format, logs);
  }
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
  command->add_option("--quantity", o->quantity,
                      "acceleration, velocity, displacement, sound, force, current or speed");
  command->add_option("--channel", o->channels, "Channels, counted from 0: N[,N]")->delimiter(',');
  auto* rate = command->add_option("--rate", o->rate, "Sampling rate of a text file without times [Hz]");
  auto* scale = command->add_option("--scale", o->scale, "SI units per full scale or per unit of the file");
  command->add_option("--detector", o->detector, "Detector id, or all");
  command->add_option("--events", o->events, "Write every change of state to OUT.json");
  command->add_option("--series", o->series, "Write the indicators of every block to OUT.csv");
  command->add_flag("--json", o->json, "Print one JSON object");
  o->settings.add(*command);
  command->callback([o, teeth, speed, rate, scale, &exitCode] {
    o->teethGiven = teeth->count() > 0;
    o->speedGiven = speed->count() > 0;
    o->rateGiven = rate->count() > 0;
    o->scaleGiven = scale->count() > 0;
    exitCode = analyze(*o);
  });
}

}  // namespace stillcut::app
