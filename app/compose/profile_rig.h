// A rig from a machine's profile: its device, its link, its methods and limits. Live.
// Thread: set-up.
#pragma once

#include <memory>

#include "app/compose/rig.h"
#include "core/config/profile.h"

namespace stillcut::app {

// Ids that a profile may name.
config::KnownIds knownIds();

// The source "simulated" takes the setting `scenario`, a file; its machine is the link "simulated".
// `fault`: as for Rig::build.
Result<std::unique_ptr<Rig>> buildProfileRig(const config::Profile& profile, const std::string& path,
                                             SetUpFault* fault = nullptr);

}  // namespace stillcut::app
