// A rig on a recording: the methods run on what was measured, nothing is commanded.
// Thread: set-up.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "core/record/recording_reader.h"

namespace stillcut::app {

struct RecordingOptions {
  record::ReadOptions read;
  int teeth = 0;                                   // 0: as the recording says, or unknown
  Rpm speed{};                                     // 0: as the recording says, or unknown
  std::vector<pipeline::SpeedLogFeed::Point> log;  // measured speed; empty: none
  Methods methods{.detectors = {"energy-ratio"}, .strategy = "monitor"};
  config::ParamSet params;
};

struct RecordingRig {
  std::unique_ptr<Rig> rig;
  record::RecordingFormat format;
};

Result<RecordingRig> buildRecordingRig(const std::string& path, const RecordingOptions& options);

// CSV with the header t,rpm; times rising.
Result<std::vector<pipeline::SpeedLogFeed::Point>> readSpeedLog(const std::string& path);

}  // namespace stillcut::app
