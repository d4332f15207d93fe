// The table of strategies: a new one is a header, a source, a test, and one line in registry.cpp.
// Thread: set-up only.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/base/result.h"
#include "core/control/strategy.h"

namespace stillcut::control {

struct StrategyEntry {
  std::string_view id;
  std::unique_ptr<Strategy> (*make)();
  config::ParamTable params;  // its own declarations; the override limits' are in config::kOverrideLimitParams
};

std::span<const StrategyEntry> strategyTable();
inline constexpr std::string_view kDefaultStrategy = "stable-pocket";

// Not prepared yet. An unknown id names the nearest one.
Result<std::unique_ptr<Strategy>> makeStrategy(std::string_view id);

}  // namespace stillcut::control
