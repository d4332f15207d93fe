// The source "joined" from a profile: 1_id = "alsa", 1_device = ..., 2_id = "serial" and so on; N_channels says how
// many of the [[channels]] are that device's (1 unless given), N_delay_ms by how much its samples are stamped too late.
// Thread: set-up.
#pragma once

#include <memory>

#include "core/daq/registry.h"

namespace stillcut::daq {

Result<std::unique_ptr<DaqSource>> makeJoined(const SourceRequest& request);

}  // namespace stillcut::daq
