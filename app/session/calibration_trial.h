// A calibrator's tone on one channel of a profile's device: what it says of the channel's sensitivity.
// Thread: any one; takes some seconds. The device is closed again.
#pragma once

#include <string>

#include "core/config/profile.h"
#include "ui/models/setup_desk.h"

namespace stillcut::app {

// `level`: "94 dB", "1 g", "10", rms.
ui::CalibrationTrial calibrateChannel(const config::Profile& profile, const std::string& path, int channel,
                                      const std::string& level, Hertz frequency);

}  // namespace stillcut::app
