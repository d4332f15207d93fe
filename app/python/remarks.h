// What an answer about samples assumes because it was not given, and what the program set itself: the fields remarks
// and own_values of `stillcut-cli analyze --json`. Thread: any.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/evaluate/auto_value_log.h"
#include "core/model/cut_setup.h"

namespace stillcut::app {

// Shape: samples[frame * channels + channel], as they were judged. `spindle`: found in them; 0: not found.
std::vector<std::string> remarks(const CutSetup& setup, std::span<const float> samples, Hertz spindle);

nlohmann::json toJson(const std::vector<evaluate::AutoValueLog::Entry>& values);

}  // namespace stillcut::app
