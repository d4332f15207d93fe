// simulate --strategy active: the loop of the active work-holder (app/compose/active_run.h) on a scenario.
#pragma once

#include <cstdint>
#include <string>

#include "core/config/param_set.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::app {

struct ActiveFiles {
  std::string cut;         // a .wav of the controlled cut, or nothing
  std::string pathRecord;  // a .csv of what the paths were identified from, or nothing
};
// Prints what became of it, as text or as one JSON object.
int simulateActive(const milling::Scenario& scenario, const config::ParamSet& params, std::uint64_t seed,
                   const ActiveFiles& files, bool json);

}  // namespace stillcut::app
