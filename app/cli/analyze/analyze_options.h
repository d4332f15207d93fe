// What `analyze` is given: options, checked and understood, one set for all its recordings.
// Thread: main.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/reading_options.h"
#include "app/cli/setting_options.h"
#include "app/compose/recording/recording_profile.h"

namespace stillcut::app {

struct AnalyzeOptions {
  std::vector<std::string> recordings;  // "-": the standard input
  std::string speedLog, detector, profile;
  std::string events, series, labels;  // files to write; a folder where there are several recordings
  int teeth = 0;
  double speed = 0.0;
  bool json = false, lines = false, values = false, strict = false, truth = false;
  bool teethGiven = false, speedGiven = false;
  ReadingOptions reading;
  SettingOptions settings;

  void add(CLI::App& command);
  // Everything but the recording itself. One line for what is wrong.
  Result<RecordingOptions> understand() const;
  // Where `wanted` (events, series or labels) is written for this recording; empty: nowhere.
  std::string outPath(const std::string& wanted, const std::string& recording, const std::string& ending) const;
};

}  // namespace stillcut::app
