// What the chosen sensors are asked by hand: a calibrator's tone on one, knocks along the axis of one.
// Thread: any one; takes some seconds, less once `ended` is set. The device is closed again.
#pragma once

#include <atomic>
#include <string>

#include "core/config/profile.h"
#include "ui/facade/setup_controller.h"

namespace stillcut::app {

// `level`: "94 dB", "1 g", "10", rms.
ui::SensorTrial calibrateChannel(const config::Profile& profile, const std::string& path, int channel,
                                 const std::string& level, Hertz frequency, const std::atomic<bool>& ended);
// Whether it is `channel` that lies along its axis.
ui::SensorTrial knockAlong(const config::Profile& profile, const std::string& path, int channel,
                           const std::atomic<bool>& ended);

}  // namespace stillcut::app
