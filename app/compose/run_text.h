// RunText: how a run was wired, as text: which methods, whether Auto could be chosen, every parameter that differed
// from its default. A recording carries it as its configuration, and a replay is wired from it, so that it decides the
// same.
//   [methods]  detectors = "energy-ratio parametric", fallback, strategy, allow_auto
//   [parameters.energy-ratio]  chatter = 0.2
// followed by the scenario or profile the run was made from, as comments.
// Thread: set-up.
#pragma once

#include <string>
#include <string_view>

#include "app/compose/rig.h"
#include "core/base/result.h"

namespace stillcut::app {

struct RunText {
  Methods methods;
  bool autoAllowed = false;
  config::ParamSet params;
};

std::string runText(const RunText& run, std::string_view origin);
// The scenario or profile that a run with this text was made from; empty: it does not say.
std::string runOrigin(std::string_view content);
// `name` stands for the file in errors.
Result<RunText> parseRunText(std::string_view content, const std::string& name);

}  // namespace stillcut::app
