#include "app/session/replay/opened_recording.h"

#include <utility>

#include "app/compose/recording_rig.h"
#include "app/session/replay/recorded_lobes.h"
#include "core/detect/registry.h"
#include "core/evaluate/session_summary_builder.h"
#include "core/session/file/session_markers.h"
#include "core/session/session_glance.h"

namespace stillcut::app {
namespace {

Result<std::unique_ptr<Rig>> replayRig(const std::string& path, const ReplayPacing& hand, bool session) {
  auto built = session ? buildReplayRig(path, hand) : [&] {
    RecordingOptions options;
    options.methods.detectors = {std::string(detect::kDefaultDetector)};
    options.hand = hand;
    return buildRecordingRig(path, options);
  }();
  if (!built) return built.error();
  return std::move(built->rig);
}

// Imported files begin at 0.
Result<Instant> beginOf(const std::string& path, bool session) {
  if (!session) return Instant{};
  const auto sketch = record::sketchSession(path, 0);
  if (!sketch) return sketch.error();
  return sketch->begin;
}

}  // namespace

Result<std::shared_ptr<OpenedRecording>> openRecording(const std::string& path, const Clock& clock,
                                                       BackgroundTask::Progress& progress) {
  auto summary = evaluate::glimpseOf(path);
  if (!summary) return summary.error();
  const auto begin = beginOf(path, summary->session);
  if (!begin) return begin.error();
  if (progress.stopped()) return Error{path, message("stopped")};
  auto opened = openAgain(path, summary->session, clock);
  if (!opened) return opened.error();
  (*opened)->begin = *begin;
  (*opened)->lobes = recordedLobes(path, summary->configuration);
  (*opened)->summary = std::make_shared<const SessionSummary>(std::move(summary).value());
  return opened;
}

Result<std::shared_ptr<OpenedRecording>> openAgain(const std::string& path, bool session, const Clock& clock) {
  auto opened = std::make_shared<OpenedRecording>();
  opened->path = path;
  opened->control->pause();
  if (session) {
    auto markers = record::readMarkers(path);
    if (!markers) return markers.error();
    opened->markers = std::move(markers).value();
  }
  auto rig = replayRig(path, {opened->control, &clock}, session);
  if (!rig) return rig.error();
  opened->rig = std::move(rig).value();
  return opened;
}

}  // namespace stillcut::app
