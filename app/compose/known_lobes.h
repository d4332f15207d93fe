// Stable speeds for strategies that check their target against the lobes: of a scenario's own model, or of the model
// file that a profile names.
// Thread: set-up; a second or less, some more for teeth of unlike pitch.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/config/override_limits.h"
#include "core/config/profile.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/lobe_case.h"
#include "core/model/cut_setup.h"

namespace stillcut::app {

// At the deepest and widest that the programme cuts, within what the speed override reaches. Empty: nothing is cut, the
// speed cannot be changed, or the model is beyond the lobes.
std::optional<StableSpeeds> stableSpeeds(const milling::Scenario& scenario);

// The cut of the model file that a profile names, with the profile's tool (its pitch; angles close exactly, which a
// catalogue's figures need not) and its material, unless `parts` has one. Error also: the teeth are not as many.
Result<milling::LobeCase> cutOfProfile(const config::Profile& profile, const std::string& modelPath,
                                       milling::ModelParts parts = {});
// As programmed; 0: speed or feed are not known.
Metres feedPerTooth(const config::Profile& profile, int teeth);

// At the profile's depth, within its override limits. Empty: it names no model or no speed, or the speed cannot be
// changed. Error: the file cannot be read, is no cut, or contradicts the profile.
Result<std::optional<StableSpeeds>> stableSpeeds(const config::Profile& profile, const std::string& modelPath);

// The largest stable depth at one speed, by the profile's model. 0: it names no model, or nothing limits the depth as
// far as four times the profile's own is looked at.
Result<Metres> stableDepth(const config::Profile& profile, const std::string& modelPath, Rpm speed);

// What the profile's limits leave around its programmed speed, before a machine has said more. Error: they contradict
// one another; `where` names the profile.
Result<config::SpeedRange> speedsInReach(const config::Profile& profile, const std::string& where);

}  // namespace stillcut::app
