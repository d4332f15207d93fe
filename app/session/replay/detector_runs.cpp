#include "app/session/replay/detector_runs.h"

#include <map>
#include <utility>

#include "app/compose/recording_score.h"
#include "app/session/session_view.h"
#include "core/detect/registry.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

std::vector<std::string> allDetectors() {
  std::vector<std::string> all;
  for (const auto& row : detect::detectorTable()) all.emplace_back(row.id);
  return all;
}

QString labelOf(const std::string& id) {
  for (const auto& row : detect::detectorTable()) {
    if (row.id == id) return viewText(row.make()->describe().label);
  }
  return QString::fromStdString(id);
}

std::vector<ui::AlarmSpan> spansOf(const std::vector<evaluate::Alarm>& alarms) {
  std::vector<ui::AlarmSpan> spans;
  spans.reserve(alarms.size());
  for (const evaluate::Alarm& alarm : alarms) spans.push_back({alarm.begin, alarm.end});
  return spans;
}

ui::ScoreLine lineOf(const std::string& detector, const evaluate::AlarmScore& s) {
  return {labelOf(detector), s.spans, s.found, s.alarms, s.falseAlarms, s.falsePerHour(), s.delayQuantile(0.5)};
}

// Of a work of equal pieces, each a `share` of it: that after the first `from`.
std::function<bool(double)> told(BackgroundTask::Progress& progress, double from, double share) {
  return [&progress, from, share](double part) {
    progress.part.store((from + part) * share, std::memory_order_relaxed);
    return !progress.stopped();
  };
}

// Nothing: nobody has marked anything in it.
Result<std::optional<FileScore>> scoreOne(const std::string& file, const ScoreRequest& request) {
  const auto truth = evaluate::truthOf(file);
  if (!truth) return truth.error();
  if (!truth.value()) return std::optional<FileScore>();
  auto scored = scoreRecording(file, *truth.value(), request);
  if (!scored) return scored.error();
  return std::optional(std::move(*scored));
}

}  // namespace

Result<std::vector<ui::DetectorTrack>> trackDetectors(const std::string& file, const std::vector<std::string>& settings,
                                                      BackgroundTask::Progress& progress) {
  const auto truth = evaluate::truthIn(file);
  const evaluate::RecordedTruth known = truth && truth.value() ? *truth.value() : evaluate::RecordedTruth{};
  const bool compared = !settings.empty();
  const double share = compared ? 0.5 : 1.0;
  ScoreRequest request;
  request.detectors = allDetectors();
  request.goOn = told(progress, 0.0, share);
  const auto before = scoreRecording(file, known, request);
  if (!before) return before.error();
  request.goOn = told(progress, 1.0, share);
  request.settings = settings;
  const auto after = compared ? scoreRecording(file, known, request) : before;
  if (!after) return after.error();
  std::vector<ui::DetectorTrack> tracks;
  for (const std::string& id : request.detectors) {
    tracks.push_back({labelOf(id), spansOf(before->alarms.at(id)), spansOf(after->alarms.at(id)), compared,
                      before->byDetector.at(id).falseAlarms, after->byDetector.at(id).falseAlarms});
  }
  return tracks;
}

Result<Scores> scoreFiles(const std::vector<std::string>& files, BackgroundTask::Progress& progress) {
  Scores scores;
  std::map<std::string, evaluate::AlarmScore> sums;
  ScoreRequest request;
  request.detectors = allDetectors();
  const double share = 1.0 / static_cast<double>(files.size());
  double done = 0.0;
  for (const std::string& file : files) {
    request.goOn = told(progress, done, share);
    const auto scored = scoreOne(file, request);
    if (!scored && (files.size() == 1 || progress.stopped())) return scored.error();
    if (!scored) scores.notScored.push_back(ui::sayError(scored.error()));
    if (scored && scored.value()) {
      for (const auto& [id, one] : scored.value()->byDetector) sums[id].add(one);
    }
    done += 1.0;
  }
  if (sums.empty() && !scores.notScored.isEmpty()) return Error{{}, foreign(scores.notScored.front().toStdString())};
  if (sums.empty())
    return Error{message("score"), message("nothing is marked here"), message("mark true and false alarms first")};
  for (const std::string& id : request.detectors) scores.lines.push_back(lineOf(id, sums[id]));
  return scores;
}

}  // namespace stillcut::app
