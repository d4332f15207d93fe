// What a calibrator says of a sensor: a tone of known level at a known frequency (a pistonphone: 94 dB, 1 Pa, at 1 kHz;
// a hand-held shaker: 10 m/s2 at 159.2 Hz) gives the SI units of one device unit, and with the input's range the
// sensitivity. The tone is fitted by least squares, its frequency found near the given one, in pieces of a quarter of a
// second: their scatter is its own, and shows a moved sensor. Levels are root mean squares, as calibrators have
// them.
// Thread: any; allocates.
#pragma once

#include <span>
#include <string>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/model/channel.h"

namespace stillcut::daq {

struct CalibratorTone {
  Hertz frequency{1000.0};
  double level = 1.0;  // rms, SI unit of the quantity
};

// "94 dB" (re 20 uPa; sound only), "1 g" (acceleration only), "10": SI units, rms.
Result<double> levelFrom(const std::string& text, SensorQuantity quantity);

struct Calibration {
  double rms = 0.0;      // of the tone [device units]
  double scale = 0.0;    // SI units per device unit
  double scaleSd = 0.0;  // its standard deviation
  Hertz frequency{};     // as found
  double pure = 0.0;     // part of the power around the mean that is the tone
};

// `samples` as the device delivers them, two seconds or more. Error, one line that says what was measured instead: too
// short; no tone within 5 % of the frequency; less than 0.9 of the power is the tone; it is cut off at the input's
// limit; its level moves by more than 5 %.
Result<Calibration> calibrate(std::span<const float> samples, Hertz rate, const CalibratorTone& tone);

// `channel` with what was found: its sensitivity where it has one (mV per g, Pa, N at its `volts`), and its scale.
void applyCalibration(const Calibration& found, ChannelInfo& channel);

}  // namespace stillcut::daq
