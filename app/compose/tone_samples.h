// Samples of a calibrator's tone, as a channel delivers them: from a profile's device, or from a recording.
// Thread: set-up; waits for the device.
#pragma once

#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "core/config/profile.h"
#include "core/record/recording_reader.h"

namespace stillcut::app {

struct ToneSamples {
  std::vector<float> samples;  // in one piece: what came before a gap is not there [device units]
  Hertz rate{};
  ChannelInfo channel;
};

// `path`: of the profile, for the files it names. `fault` says whether the device or the settings are to blame.
Result<ToneSamples> listenToTone(const config::Profile& profile, const std::string& path, int channel, Seconds length,
                                 SetUpFault& fault);
// Of the first of the channels that `options` choose.
Result<ToneSamples> readTone(const std::string& recording, const record::ReadOptions& options);

}  // namespace stillcut::app
