// What sensors deliver, to be judged as a whole: of a profile's device, or of a recording.
// Thread: set-up; waits for the device.
#pragma once

#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "core/config/profile.h"
#include "core/record/recording_reader.h"

namespace stillcut::app {

struct HeardSamples {
  std::vector<std::vector<float>> samples;  // by channel, in one piece: what came before a gap is not there
  Hertz rate{};
  std::vector<ChannelInfo> channels;
};

// All channels of the device, which has to have `channel`. `path`: of the profile, for the files it names. `fault` says
// whether the device or the settings are to blame.
Result<HeardSamples> hearDevice(const config::Profile& profile, const std::string& path, int channel, Seconds length,
                                SetUpFault& fault);
// The channels that `options` choose, a minute at most.
Result<HeardSamples> hearRecording(const std::string& recording, const record::ReadOptions& options);
// A channel that is not there: one line.
Status checkChannel(std::size_t channels, const std::string& where, int channel);

}  // namespace stillcut::app
