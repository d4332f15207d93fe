// What sensors deliver, to be judged as a whole: of a profile's device, or of a recording.
// Thread: set-up; waits for the device.
#pragma once

#include <atomic>
#include <string>

#include "app/compose/rig.h"
#include "core/config/profile.h"
#include "core/daq/measured_samples.h"
#include "core/formats/recording_reader.h"

namespace stillcut::app {

// All channels of the device, which has to have `channel`. `path`: of the profile, for the files it names. `fault` says
// whether the device or the settings are to blame. `ended`: see daq::MeasureRequest.
Result<daq::MeasuredSamples> measureDevice(const config::Profile& profile, const std::string& path, int channel,
                                           Seconds length, SetUpFault& fault, const std::atomic<bool>* ended = nullptr);
// The channels that `options` choose, a minute at most.
Result<daq::MeasuredSamples> measureRecording(const std::string& recording, const record::ReadOptions& options);
// A channel that is not there: one line.
Status checkChannel(std::size_t channels, const std::string& where, int channel);

}  // namespace stillcut::app
