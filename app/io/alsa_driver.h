// AlsaDriver: a PcmDriver on alsa-lib. hw: devices deliver what the converter made; resampling is switched off on
// everything else as well. Null in a build without alsa-lib.
// Thread: as PcmDriver says.
#pragma once

#include <memory>
#include <vector>

#include "core/daq/pcm_driver.h"

namespace stillcut::app {

std::unique_ptr<daq::PcmDriver> makeAlsaDriver();
// What can record here, with its ranges.
std::vector<daq::PcmDevice> alsaDevices();

}  // namespace stillcut::app
