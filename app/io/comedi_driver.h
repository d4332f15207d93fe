// ComediDriver: a PcmDriver on the analog inputs of a Comedi card (NI and many others), by its streaming commands.
// Channels are the card's inputs from 0 on; a full scale is half of the range that was chosen, in volts.
// Null in a build without Comedi.
// Thread: as PcmDriver says.
#pragma once

#include <memory>
#include <string>

#include "core/daq/pcm_driver.h"

namespace stillcut::app {

// range: index of the card's ranges. reference: 0 ground, 1 common, 2 differential.
std::unique_ptr<daq::PcmDriver> makeComediDriver(int range, int reference);

}  // namespace stillcut::app
