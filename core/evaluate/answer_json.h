// The answer about a recording as scripts get it; every field: resources/manual/scripts.md.
// Thread: any; not the sample path.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/model/recording_answer.h"

namespace stillcut::evaluate {

nlohmann::json toJson(const RecordingAnswer& answer);
nlohmann::json toJson(const SpeedAnswer& advice);
// What a detector's row shares with the answer.
void addJudged(nlohmann::json& row, const RecordingAnswer& answer);

}  // namespace stillcut::evaluate
