// What `learn` prints of a posterior: the words and the JSON. Thread: any.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/cli/learn/learn_options.h"
#include "core/learn/next_cut.h"

namespace stillcut::app {

nlohmann::json toJson(const learn::CutEvidence& cut);
nlohmann::json toJson(const learn::LearnedAdvice& advice);
nlohmann::json toJson(const learn::NextCut& next);
// Counts, the mean machine with its spread, limits over the speed, advice.
nlohmann::json postureJson(Learned& learned, double risk);
void printPosture(Learned& learned, double risk);

}  // namespace stillcut::app
