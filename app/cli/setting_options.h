// --set KEY=VALUE and --config FILE, which every command takes that runs a method. The file holds parameters alone, a
// table a part ([energy-ratio] chatter = 0.2), or is a whole profile (it has a `version`): then its parameters count,
// and the detector it puts in charge.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/config/param_set.h"

namespace stillcut::app {

struct Settings {
  config::ParamSet params;
  std::string detector;  // in charge; empty: nothing said
};

struct SettingOptions {
  std::vector<std::string> settings;
  std::string config;

  void add(CLI::App& command);
  // `base` (defaults, or those of a profile), then the file, then --set.
  Result<Settings> read(const config::ParamSet& base = {}) const;
};

// What an option takes, as its help and the completion of shells say it: "TEXT:{energy-ratio,spectral,all}".
std::string detectorWords(bool all);
std::string strategyWords();

}  // namespace stillcut::app
