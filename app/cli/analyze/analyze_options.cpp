#include "app/cli/analyze/analyze_options.h"

#include <filesystem>
#include <utility>

#include "app/cli/out_path.h"
#include "app/compose/profile_rig.h"
#include "app/compose/resource_folder.h"
#include "core/config/nearest_word.h"
#include "core/detect/registry.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

constexpr int kMostTeeth = 64;
constexpr double kHighestSpeed = 1e6;  // [rpm]

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

Status checkOutputs(const AnalyzeOptions& given) {
  const std::pair<const char*, const std::string*> outs[] = {
      {"--events", &given.events}, {"--series", &given.series}, {"--labels", &given.labels}};
  for (const auto& [option, path] : outs) {
    if (path->empty()) continue;
    if (given.recordings.size() > 1) {
      std::error_code unknown;
      if (std::filesystem::is_directory(*path, unknown)) continue;
      return Error{*path, message("cannot be written"),
                   message("%1 of several recordings needs a folder that is there", option)};
    }
    if (Status usable = checkOutPath(*path, given.recordings.front()); !usable) return usable;
    for (const auto& [other, same] : outs) {
      if (path == same || *path != *same) continue;
      return Error{*path, message("cannot be written"), message("%1 and %2 name the same file", option, other)};
    }
  }
  return Done{};
}

Status checkDetector(const std::string& id) {
  if (id.empty() || id == "all") return Done{};
  std::vector<std::string_view> ids;
  std::string all = "all";
  for (const auto& row : detect::detectorTable()) {
    if (row.id == id) return Done{};
    ids.push_back(row.id);
    all += ", " + std::string(row.id);
  }
  const Message near = config::didYouMean(id, ids);
  return Error{"--detector", message("'%1' is no detector", id), near.empty() ? message("choices: %1", all) : near};
}

Status checkOptions(const AnalyzeOptions& given) {
  if (given.teethGiven && (given.teeth < 1 || given.teeth > kMostTeeth)) {
    return Error{"--teeth", message("%1 is out of range", std::to_string(given.teeth)),
                 message("allowed: 1 to %1", std::to_string(kMostTeeth))};
  }
  if (given.speedGiven && !(given.speed > 0.0 && given.speed <= kHighestSpeed)) {
    return Error{"--speed", message("the speed must be above zero and at most 1e6 rpm")};
  }
  if (Status known = checkDetector(given.detector); !known) return known;
  return checkOutputs(given);
}

Status takeProfile(const AnalyzeOptions& given, RecordingOptions& options, std::string& detector) {
  if (given.profile.empty()) return Done{};
  const std::string path = foundFile(given.profile);
  const auto profile = config::loadProfile(path, pipeline::fullCatalog(), knownIds());
  if (!profile) return profile.error();
  detector = profile->detector;
  return addProfile(*profile, path, options);
}

}  // namespace

void AnalyzeOptions::add(CLI::App& command) {
  command.add_option("RECORDING", recordings, "Sound file, text table, or Stillcut session; - is the standard input")
      ->required();
  command.add_option("--teeth", teeth, "Number of teeth");
  auto* speedGivenBy = command.add_option("--speed", speed, "Spindle speed as programmed [rpm]");
  command.add_option("--speed-log", speedLog, "Measured spindle speed: CSV with the header t,rpm")
      ->excludes(speedGivenBy);
  command.add_option("--profile", profile, "Tool, speed, parameters, limits and lobes of this profile (.toml)");
  reading.add(command);
  command.add_option("--detector", detector, "Detector, or all")->type_name(detectorWords(true));
  command.add_option("--events", events, "Write every change of state to OUT.json");
  command.add_option("--series", series, "Write state, speed and indicators of every block to OUT.csv");
  command.add_option("--labels", labels, "Write alarms and what was not judged to OUT.txt, as labels of Audacity");
  command.add_flag("--values", values, "Also print what the program set itself, and why");
  command.add_flag("--truth", truth, "Compare with what is known of it: TRUTH.csv or NAME_truth.csv beside it");
  command.add_flag("--strict", strict, "End with exit code 1 also where a recording could not be judged");
  command.add_flag("--json", json, "Print one JSON object a recording, each in a line");
  command.add_flag("--lines", lines, "With --json: a line for every change of state before it, while it runs");
  settings.add(command);
}

Result<RecordingOptions> AnalyzeOptions::understand() const {
  if (const Status usable = checkOptions(*this); !usable) return usable.error();
  RecordingOptions options;
  options.teeth = teeth;
  options.speed = Rpm(speed);
  auto read = reading.understand();
  if (!read) return read.error();
  options.read = std::move(read).value();
  if (!speedLog.empty()) {
    auto log = readSpeedLog(speedLog);
    if (!log) return log.error();
    options.log = std::move(log).value();
  }
  std::string ofProfile;
  if (const Status taken = takeProfile(*this, options, ofProfile); !taken) return taken.error();
  auto set = settings.read(options.params);
  if (!set) return set.error();
  options.methods.detectors = detectorsFor(detector, set->detector.empty() ? ofProfile : set->detector);
  options.params = std::move(set->params);
  return options;
}

std::string AnalyzeOptions::outPath(const std::string& wanted, const std::string& recording,
                                    const std::string& ending) const {
  if (wanted.empty() || recordings.size() == 1) return wanted;
  const std::string name = recording == "-" ? "stdin" : std::filesystem::path(recording).filename().string();
  return (std::filesystem::path(wanted) / (name + ending)).string();
}

}  // namespace stillcut::app
