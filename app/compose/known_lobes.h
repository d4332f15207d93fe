// Stable speeds of a scenario's own model, for strategies that check their target against the lobes.
// Thread: set-up; a second or less.
#pragma once

#include <optional>

#include "core/milling/scenario.h"
#include "core/model/cut_setup.h"

namespace stillcut::app {

// At the deepest and widest that the programme cuts, within what the speed override reaches. Empty: nothing is cut, the
// speed cannot be changed, or the model is beyond the lobes.
std::optional<StableSpeeds> stableSpeeds(const milling::Scenario& scenario);

}  // namespace stillcut::app
