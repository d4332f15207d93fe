// simulate --strategy active: the loop of the active work-holder (app/compose/active_run.h) on a scenario.
#pragma once

#include <cstdint>
#include <string>

#include "core/config/param_set.h"
#include "core/milling/scenario.h"

namespace stillcut::app {

// Prints what became of it, as text or as one JSON object; `out` names a .wav of the controlled cut, or nothing.
int simulateActive(const milling::Scenario& scenario, const config::ParamSet& params, std::uint64_t seed,
                   const std::string& out, bool json);

}  // namespace stillcut::app
