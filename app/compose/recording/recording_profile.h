// What a profile adds to the reading of a recording. Thread: set-up.
#pragma once

#include <string>

#include "app/compose/recording_rig.h"
#include "core/config/profile.h"

namespace stillcut::app {

// Tool, programmed speed, parameters, detector, override limits and lobes of the profile; teeth, speed and `named`
// detectors of `options` that are there already stay. Error: the profile contradicts itself, or its model cannot be
// read.
Status addProfile(const config::Profile& profile, const std::string& path, RecordingOptions& options);

}  // namespace stillcut::app
