// The engine's options of a work-holder and the parameters in force, and the device that a profile names for it.
// Thread: set-up.
#pragma once

#include <memory>

#include "core/active/active_engine.h"
#include "core/config/param_set.h"
#include "core/config/profile.h"
#include "core/milling/simulation/work_holder.h"

namespace stillcut::app {

active::ActiveEngineOptions activeOptions(const milling::WorkHolderSettings& holder, const config::ParamSet& params);

struct ActiveParts {
  std::unique_ptr<active::DuplexDevice> device;
  active::ActiveEngineOptions options;
};
// Of [active] in a profile. Settings of "alsa": device, rate_hz, block_frames; input_x, input_y, output_x, output_y
// (channels from 0); sensor_x, sensor_y (SI of the sensor at full scale); full_stroke_um (stroke at full scale of the
// output); stroke_um, slew_m_per_s (limits); quieten_hz ("339, 1024").
Result<ActiveParts> makeActiveParts(const config::Profile& profile);

}  // namespace stillcut::app
