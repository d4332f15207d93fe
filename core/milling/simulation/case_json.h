// Import of the shared reference cuts (JSON) as scenarios. Two sensors x, y of acceleration. What the file does not say
// and what stands in for it: resources/manual/developers/laws.md#reference-cuts.
// Thread: set-up. Errors: one line with file, place and cause.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::milling {

Result<Scenario> loadCaseJson(const std::string& path);

}  // namespace stillcut::milling
