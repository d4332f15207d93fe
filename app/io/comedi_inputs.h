// What a Comedi card's inputs can do, and how their codes become volts. In a build with Comedi alone.
// Thread: that of ComediDriver; volts() is real-time.
#pragma once

#ifdef STILLCUT_COMEDI
#include <comedilib.h>

#include <string>
#include <vector>

#include "core/base/message.h"

namespace stillcut::app {

// By channel from 0 on: by the card's calibration where its inputs are calibrated in software (NI's newer cards), else
// from end to end of the range. `doubt`: one line where they should be calibrated and no calibration is found.
std::vector<comedi_polynomial_t> converters(comedi_t* card, unsigned subdevice, unsigned channels, unsigned range,
                                            Message& doubt);
double volts(const comedi_polynomial_t& converter, lsampl_t code) noexcept;

// "0 to 15 ('inputs'), up to 250000 Hz for one, 16 bits; 'range' 0: -10 to 10 V, 1: -5 to 5 V"
std::string rangeOf(comedi_t* card, unsigned subdevice);

}  // namespace stillcut::app
#endif
