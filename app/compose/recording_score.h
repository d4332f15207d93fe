// Every detector on a recording, against what is known about it; and what a changed parameter would have changed.
// Thread: set-up (runs the recording as fast as it can, in the caller's thread).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/config/param_set.h"
#include "core/evaluate/recorded_truth.h"

namespace stillcut::app {

struct ScoreRequest {
  std::vector<std::string> detectors;
  config::ParamSet params;            // of recordings that are no sessions
  bool ownParams = true;              // sessions: begin with their own parameters
  std::vector<std::string> settings;  // KEY=VALUE on top of all
  int teeth = 0;                      // 0: as the truth or the recording says
  Rpm speed{};                        // likewise
  std::function<bool(double)> goOn;   // gets the fraction done, 0 .. 1; false: stop with an error. Empty: to the end
};

struct FileScore {
  std::string file;
  evaluate::RecordedTruth truth;
  Seconds length{};
  std::map<std::string, evaluate::AlarmScore> byDetector;
  std::map<std::string, std::vector<evaluate::Alarm>> alarms;
};

// Without spans of truth only the alarms are counted.
Result<FileScore> scoreRecording(const std::string& path, const evaluate::RecordedTruth& truth,
                                 const ScoreRequest& request);

// "energy-ratio would have alarmed 3 times, 2 of them marked false; before 5 times, 4 of them marked false"
std::string whatIfSentence(const std::string& detector, const evaluate::AlarmScore& before,
                           const evaluate::AlarmScore& after);

// Recordings below `folder`, by name; tables of truth and other by-files left out. `goOn`: asked at each file; false:
// stop with what there is. Empty: to the end.
std::vector<std::string> recordingsIn(const std::string& folder, const std::function<bool()>& goOn = {});

}  // namespace stillcut::app
