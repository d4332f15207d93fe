// Units and names as file headers spell them. Pure: any thread; set-up, not real-time.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/model/channel.h"

namespace stillcut::record {

enum class UnitKind {
  Sensor,   // a quantity this program knows
  Voltage,  // an uncalibrated sensor
  Time,     // seconds and their parts
  Other,    // recognised, and certainly no vibration: degrees, percent, hertz
};

struct UnitMeaning {
  UnitKind kind = UnitKind::Other;
  std::optional<SensorQuantity> quantity;
  double toSi = 1.0;  // SI units (seconds for Time) per unit
};

// "m/s^2", "m/s²", "g", "um", "µm", "[N]", "(s)", "Volts" ...; nothing when the text is no unit we know.
std::optional<UnitMeaning> unitFromText(std::string_view text);

// "Accel X (m/s^2)" becomes name "Accel X" and unit "m/s^2"; without a trailing bracket the unit is empty. "Accel [V]
// (100 mV/g)" becomes "Accel (100 mV/g)" and "V".
struct NameAndUnit {
  std::string name;
  std::string unit;
};
NameAndUnit splitNameAndUnit(std::string_view text);

// What a column's name says about it when no unit does.
enum class NameMeaning { Unknown, Time, Acceleration, Sound, Force, SpindleSpeed, NoSignal };
NameMeaning meaningOfName(std::string_view name);
// "x", "y", "z" when the name ends in it as a word or after a sensor letter ("Accel X", "Fx"), else empty.
std::string axisOfName(std::string_view name);

std::string_view trimmed(std::string_view text);

}  // namespace stillcut::record
