#include "app/compose/recording_score.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "app/compose/recording_rig.h"
#include "app/compose/run_text.h"
#include "core/config/profile.h"
#include "core/evaluate/scenario_reader.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

std::string times(int n) {
  if (n == 0) return "not at all";
  return n == 1 ? "once" : std::to_string(n) + " times";
}

std::string counted(const evaluate::AlarmScore& s) {
  std::string text = times(s.alarms);
  if (s.alarms > 0)
    text += ", " + (s.falseAlarms == 0 ? "none" : std::to_string(s.falseAlarms)) + " of them marked false";
  return text;
}

Result<config::ParamSet> paramsFor(const std::string& path, const ScoreRequest& request) {
  config::ParamSet params = request.params;
  if (request.ownParams) {
    auto reader = evaluate::openCut(path);
    if (!reader) return reader.error();
    if ((*reader)->format().setup) {
      auto run = parseRunText((*reader)->format().configuration, path + " (configuration)");
      if (run) params = std::move(run->params);  // of another version: its defaults
    }
  }
  for (const std::string& setting : request.settings) {
    if (const Status s = config::applySetting(params, pipeline::fullCatalog(), setting); !s) return s.error();
  }
  return params;
}

}  // namespace

Result<FileScore> scoreRecording(const std::string& path, const evaluate::RecordedTruth& truth,
                                 const ScoreRequest& request) {
  RecordingOptions options;
  options.read.quantity = truth.quantity;
  options.read.scale = truth.scale;
  options.teeth = request.teeth > 0 ? request.teeth : truth.teeth;
  options.speed = request.speed.value > 0.0 ? request.speed : truth.speed;
  options.methods.detectors = request.detectors;
  auto params = paramsFor(path, request);
  if (!params) return params.error();
  options.params = std::move(params).value();
  auto built = buildRecordingRig(path, options);
  if (!built) return built.error();
  Rig& rig = *built->rig;
  std::vector<evaluate::AlarmList> lists(request.detectors.size());
  std::optional<Instant> begin;
  Instant end{};
  const auto observe = [&](const StepInput& in, const StepOutput& out) {
    if (!begin) begin = in.block.firstSample;
    end = in.block.end();
    for (std::size_t d = 0; d < lists.size(); ++d) {
      lists[d].observe(secondsBetween(*begin, out.verdicts[d].time), out.verdicts[d]);
    }
  };
  const double length = std::max(built->format.length().value, 1e-9);
  while (rig.advance(observe)) {
    if (request.goOn && !request.goOn(secondsBetween(*begin, end).value / length))
      return Error{path, message("stopped")};
  }
  if (const Message fault = rig.device().fault(); !fault.empty()) return Error{{}, fault};
  FileScore score{path, truth, begin ? secondsBetween(*begin, end) : Seconds(), {}, {}};
  for (std::size_t d = 0; d < lists.size(); ++d) {
    score.byDetector[request.detectors[d]] = evaluate::scoreAlarms(truth.spans, lists[d].alarms(), score.length);
    score.alarms[request.detectors[d]] = lists[d].alarms();
  }
  return score;
}

std::string whatIfSentence(const std::string& detector, const evaluate::AlarmScore& before,
                           const evaluate::AlarmScore& after) {
  return detector + " would have alarmed " + counted(after) + "; before " + counted(before);
}

std::vector<std::string> recordingsIn(const std::string& folder, const std::function<bool()>& goOn) {
  namespace fs = std::filesystem;
  constexpr auto kSuffixes =
      std::to_array<std::string_view>({".h5", ".hdf5", ".wav", ".rf64", ".flac", ".csv", ".txt", ".lvm", ".mat", ".uff",
                                       ".unv", ".npy", ".npz", ".mp3", ".m4a", ".mp4", ".mov"});
  std::vector<std::string> found;
  std::error_code problem;
  for (auto entry = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, problem);
       !problem && entry != fs::recursive_directory_iterator(); entry.increment(problem)) {
    if (goOn && !goOn()) break;
    std::string suffix = entry->path().extension().string();
    for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const std::string name = entry->path().filename().string();
    const bool known = std::find(kSuffixes.begin(), kSuffixes.end(), suffix) != kSuffixes.end();
    const bool byFile = name == "TRUTH.csv" || name.ends_with("_truth.csv");
    if (known && !byFile && entry->is_regular_file(problem)) found.push_back(entry->path().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace stillcut::app
