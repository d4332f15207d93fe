// The answer about one recording, from its file: what a report says, and what a profile adds to it.
// Thread: set-up; runs the recording as fast as it can in the caller's thread.
#pragma once

#include <functional>
#include <string>

#include "app/compose/recording_rig.h"
#include "core/config/profile.h"

namespace stillcut::app {

// Tool, programmed speed, parameters, detector, override limits and lobes of the profile; teeth, speed and `named`
// detectors of `options` that are there already stay. Error: the profile contradicts itself, or its model cannot be
// read.
Status addProfile(const config::Profile& profile, const std::string& path, RecordingOptions& options);

// Of the detector in charge. `goOn`: told the part that is done, 0 to 1; false: stop with an error. Empty: to the end.
Result<RecordingAnswer> answerRecording(const std::string& path, const RecordingOptions& options,
                                        const std::function<bool(double)>& goOn = {});

}  // namespace stillcut::app
