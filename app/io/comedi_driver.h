// ComediDriver: a PcmDriver on the analog inputs of a Comedi card (NI and many others), by its streaming commands.
// Channels are the card's inputs from 0 on; a full scale is the larger end of the range that was chosen, in volts, by
// the card's own calibration where it has one. Null in a build without Comedi. Thread: as PcmDriver says.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/daq/pcm_driver.h"

namespace stillcut::app {

// range: index of the card's ranges. reference: 0 ground, 1 common, 2 differential.
std::unique_ptr<daq::PcmDriver> makeComediDriver(int range, int reference);
// The cards whose inputs stream, with inputs, rates and ranges. `devices`: the kernel's folder; tests have their own.
std::vector<daq::PcmDevice> comediDevices(const std::string& devices = "/dev");

}  // namespace stillcut::app
