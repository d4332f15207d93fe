// Times without a unit: seconds, unless that would be far too few samples a second for vibration; then whoever opens
// the file is asked. Pure: any thread; set-up, not real-time.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"

namespace stillcut::record {

// Whether times in steps of `step`, whose unit nothing tells, can be seconds; an error asks for their unit and says
// which would be one of vibration. `where` names the file.
Status checkAssumedSeconds(const std::string& where, double step);

}  // namespace stillcut::record
