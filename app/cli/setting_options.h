// --set KEY=VALUE and --config FILE, which every command takes that runs a method.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/config/param_set.h"

namespace stillcut::app {

struct SettingOptions {
  std::vector<std::string> settings;
  std::string config;

  void add(CLI::App& command);
  // Defaults, then the file, then --set.
  Result<config::ParamSet> params() const;
};

}  // namespace stillcut::app
