// Import of the shared reference cuts (JSON) as scenarios. Two sensors x, y of the quantity asked for.
// Thread: set-up. Errors: one line with file, place and cause.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/milling/scenario.h"

namespace stillcut::milling {

// A cut: modes, coefficients (Kt, Kn), tool, speed, `process` with its depth segments, entry and exit.
Result<Scenario> loadCaseJson(const std::string& path);

}  // namespace stillcut::milling
