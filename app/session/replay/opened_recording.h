// A recording made ready for a replay that a hand on the screen leads: what is known of it at once, and its rig, paused
// at the beginning. Thread: any; the disk may be slow.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "app/session/background_task.h"
#include "app/session/lobe_worker.h"
#include "core/daq/replay_control.h"
#include "core/model/marker.h"
#include "core/model/session_summary.h"

namespace stillcut::app {

struct OpenedRecording {
  std::string path;
  std::shared_ptr<const SessionSummary> summary;  // null: opened again
  Instant begin{};                                // of the first sample, on the recording's clock
  std::vector<Marker> markers;                    // of a session
  std::shared_ptr<daq::ReplayControl> control = std::make_shared<daq::ReplayControl>();
  std::unique_ptr<Rig> rig;
  std::unique_ptr<LobeWorker> lobes;  // null: opened again, or the modes are not known
};

// `clock`: of the replay's pace; outlives it.
Result<std::shared_ptr<OpenedRecording>> openRecording(const std::string& path, const Clock& clock,
                                                       BackgroundTask::Progress& progress);
// The same file, whose summary is known.
Result<std::shared_ptr<OpenedRecording>> openAgain(const std::string& path, bool session, const Clock& clock);

}  // namespace stillcut::app
