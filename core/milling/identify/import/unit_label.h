// Unit labels of measured functions, as files and people write them: what quantity, and the factor to SI.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <optional>
#include <string_view>

#include "core/milling/identify/frf.h"

namespace stillcut::identify {

struct ResponseUnit {
  FrfQuantity quantity = FrfQuantity::Compliance;
  double factor = 1.0;  // to m, m/s or m/s^2 (per N where a force is part of the label)
};

// "mm", "m/s", "g", "(m/s^2)", "in/s^2" ...; empty when not known. UTF-8 or Latin-1.
std::optional<ResponseUnit> responseUnit(std::string_view label);
// Factor of a force unit to N: "N", "Newtons", "kN", "lbf", "kgf".
std::optional<double> forceUnit(std::string_view label);
// A whole FRF unit: "m/N", "(m/s^2)/N", "1/N*(m/s2)", "g/lbf", "1/kg" ...
std::optional<ResponseUnit> frfUnit(std::string_view label);
// Force over response, as dynamic stiffness "N/um", apparent mass "kg" and impedance "N s/m" are measured: the unit
// that one over it has.
std::optional<ResponseUnit> inverseFrfUnit(std::string_view label);
// "dB", "dB re 1e-12 m/N", "dB (m/s^2)/N". The reference is left out where the label does not say it.
struct Decibels {
  std::optional<ResponseUnit> reference;  // what 0 dB is
};
std::optional<Decibels> decibels(std::string_view label);
// Factor to Hz: "Hz", "kHz", "rad/s", "1/min".
std::optional<double> frequencyUnit(std::string_view label);
// Factor to V: "V", "mV", "Volts".
std::optional<double> voltageUnit(std::string_view label);
// Factor to rad: "deg", "rad".
std::optional<double> angleUnit(std::string_view label);

// "2.25 mV/N", "100mV/g", "10.2 mV/(m/s^2)".
struct Sensitivity {
  double voltsPerUnit = 0.0;                 // [V per N, m, m/s or m/s^2]
  std::optional<FrfQuantity> response = {};  // empty: a force
};
std::optional<Sensitivity> sensitivityFromText(std::string_view text);

}  // namespace stillcut::identify
