// stillcut-cli score PATH ...: detectors against marked truth, over one recording or all below a folder.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "app/cli/setting_options.h"
#include "app/compose/recording_score.h"
#include "core/detect/registry.h"

namespace stillcut::app {
namespace {

struct ScoreOptions {
  std::string path, detector = "all";
  int teeth = 0;
  double speed = 0.0;
  bool json = false, files = false;
  SettingOptions settings;
};

struct Totals {
  std::vector<FileScore> files;
  std::map<std::string, evaluate::AlarmScore> byDetector;

  void add(FileScore score) {
    for (const auto& [detector, s] : score.byDetector) byDetector[detector].add(s);
    files.push_back(std::move(score));
  }
};

struct Outcome {
  Totals now;     // with --set
  Totals before;  // without; empty when nothing was set
  std::vector<std::string> unmarked;
  std::vector<Error> unreadable;  // of a folder: one bad file is no reason to score none
};

std::vector<std::string> detectorsFor(const std::string& wanted) {
  if (wanted != "all") return {wanted};
  std::vector<std::string> all;
  for (const auto& row : detect::detectorTable()) all.emplace_back(row.id);
  return all;
}

Result<ScoreRequest> understand(const ScoreOptions& given) {
  constexpr int kMostTeeth = 64;
  if (given.teeth < 0 || given.teeth > kMostTeeth)
    return Error{"--teeth", message("is out of range"), message("allowed: 1 to 64")};
  if (given.speed < 0.0 || !std::isfinite(given.speed)) return Error{"--speed", message("must be above zero")};
  const auto settings = given.settings.read();  // checks --set as well
  if (!settings) return settings.error();
  ScoreRequest request;
  request.detectors = detectorsFor(given.detector);
  SettingOptions configOnly = given.settings;
  configOnly.settings.clear();
  auto base = configOnly.read();
  if (!base) return base.error();
  request.params = std::move(base->params);
  request.ownParams = given.settings.config.empty();
  request.teeth = given.teeth;
  request.speed = Rpm(given.speed);
  return request;
}

Status scoreOne(const std::string& file, const std::vector<std::string>& settings, ScoreRequest& request,
                Outcome& outcome) {
  const auto truth = evaluate::truthOf(file);
  if (!truth) return truth.error();
  if (!truth.value()) {
    outcome.unmarked.push_back(file);
    return Done{};
  }
  std::optional<FileScore> before;
  if (!settings.empty()) {
    request.settings.clear();
    auto scored = scoreRecording(file, *truth.value(), request);
    if (!scored) return scored.error();
    before = std::move(*scored);
  }
  request.settings = settings;
  auto now = scoreRecording(file, *truth.value(), request);
  if (!now) return now.error();
  if (before) outcome.before.add(std::move(*before));
  outcome.now.add(std::move(*now));
  return Done{};
}

Result<Outcome> scoreAll(const ScoreOptions& given, ScoreRequest request) {
  std::error_code problem;
  const bool folder = std::filesystem::is_directory(given.path, problem);
  const std::vector<std::string> files = folder ? recordingsIn(given.path) : std::vector{given.path};
  if (!folder && !std::filesystem::exists(given.path, problem))
    return Error{given.path, message("there is no such file")};
  Outcome outcome;
  for (const std::string& file : files) {
    const Status scored = scoreOne(file, given.settings.settings, request, outcome);
    if (scored) continue;
    if (!folder) return scored.error();
    outcome.unreadable.push_back(scored.error());
  }
  if (outcome.now.files.empty() && !outcome.unreadable.empty()) return outcome.unreadable.front();
  if (outcome.now.files.empty()) {
    return Error{given.path, message("nothing to score"),
                 message("no session with markers, no TRUTH.csv, no case beside a recording")};
  }
  return outcome;
}

nlohmann::json toJson(const evaluate::AlarmScore& s) {
  const auto number = [](double value) { return std::isfinite(value) ? nlohmann::json(value) : nullptr; };
  return {{"spans", s.spans},
          {"found", s.found},
          {"missed", s.missed()},
          {"alarms", s.alarms},
          {"false_alarms", s.falseAlarms},
          {"quiet_s", s.quiet.value},
          {"false_per_hour", number(s.falsePerHour())},
          {"delay_median_s", number(s.delayQuantile(0.5))},
          {"delay_p95_s", number(s.delayQuantile(0.95))}};
}

nlohmann::json toJson(const std::map<std::string, evaluate::AlarmScore>& byDetector) {
  nlohmann::json json;
  for (const auto& [detector, score] : byDetector) json[detector] = toJson(score);
  return json;
}

std::vector<std::string> sentences(const Outcome& outcome) {
  std::vector<std::string> lines;
  for (const auto& [detector, after] : outcome.now.byDetector) {
    const auto before = outcome.before.byDetector.find(detector);
    if (before != outcome.before.byDetector.end()) lines.push_back(whatIfSentence(detector, before->second, after));
  }
  return lines;
}

void printAnswer(const Outcome& outcome, const std::vector<std::string>& settings) {
  nlohmann::json json = jsonObject("score", "answer");
  json["detectors"] = toJson(outcome.now.byDetector);
  if (!settings.empty()) {
    json["what_if"] = {{"set", settings}, {"before", toJson(outcome.before.byDetector)}, {"words", sentences(outcome)}};
  }
  json["files"] = nlohmann::json::array();
  for (const FileScore& f : outcome.now.files) {
    json["files"].push_back(
        {{"file", f.file}, {"truth", f.truth.from}, {"length_s", f.length.value}, {"detectors", toJson(f.byDetector)}});
  }
  json["without_truth"] = outcome.unmarked;
  json["unreadable"] = nlohmann::json::array();
  for (const Error& problem : outcome.unreadable) json["unreadable"].push_back(problem.line());
  printJson(json);
}

std::string figure(double value, const char* format) {
  if (!std::isfinite(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void printRow(const std::string& detector, const evaluate::AlarmScore& s) {
  std::printf("%-14s %6d %6d %7d %6d %8.4f %9s %10s %10s\n", detector.c_str(), s.spans, s.found, s.missed(),
              s.falseAlarms, s.quiet.value / 3600.0, figure(s.falsePerHour(), "%.1f").c_str(),
              figure(s.delayQuantile(0.5), "%.3f s").c_str(), figure(s.delayQuantile(0.95), "%.3f s").c_str());
}

void printTable(const Outcome& outcome, const ScoreOptions& given) {
  std::printf("%zu recording(s) with truth, %zu without\n", outcome.now.files.size(), outcome.unmarked.size());
  for (const Error& problem : outcome.unreadable) std::printf("not scored: %s\n", problem.line().c_str());
  std::printf("%-14s %6s %6s %7s %6s %8s %9s %10s %10s\n", "detector", "spans", "found", "missed", "false", "quiet h",
              "false/h", "delay", "p95");
  for (const auto& [detector, score] : outcome.now.byDetector) printRow(detector, score);
  if (given.files) {
    for (const FileScore& file : outcome.now.files) {
      std::printf("%s\n", file.file.c_str());
      for (const auto& [detector, score] : file.byDetector) printRow(detector, score);
    }
    for (const std::string& file : outcome.unmarked) std::printf("%s: no truth\n", file.c_str());
  }
  if (given.settings.settings.empty()) return;
  std::string set;
  for (const std::string& s : given.settings.settings) set += (set.empty() ? "" : ", ") + s;
  std::printf("with %s:\n", set.c_str());
  for (const std::string& line : sentences(outcome)) std::printf("  %s\n", line.c_str());
}

int score(const ScoreOptions& given) {
  auto request = understand(given);
  if (!request) return fail(request.error());
  const auto outcome = scoreAll(given, std::move(*request));
  if (!outcome) return fail(outcome.error());
  if (given.json) {
    printAnswer(outcome.value(), given.settings.settings);
  } else {
    printTable(outcome.value(), given);
  }
  return kExitDone;
}

}  // namespace

void addScore(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<ScoreOptions>();
  CLI::App* command = app.add_subcommand("score", "Hold the detectors against marked truth");
  command->add_option("PATH", o->path, "A recording, or a folder of them")->required();
  command->add_option("--detector", o->detector, "Detector id, or all");
  command->add_option("--teeth", o->teeth, "Number of teeth, where nothing else says it");
  command->add_option("--speed", o->speed, "Spindle speed [rpm], instead of what the truth says");
  command->add_flag("--files", o->files, "Every recording by itself as well");
  command->add_flag("--json", o->json, "Print one JSON object");
  o->settings.add(*command);
  command->callback([o, &exitCode] { exitCode = score(*o); });
}

}  // namespace stillcut::app
