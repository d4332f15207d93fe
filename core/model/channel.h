// What a channel measures. The quantity decides detector profile and Caliskan's integration factor. Any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillcut {

enum class SensorQuantity { Acceleration, Velocity, Displacement, Sound, Force, Current, SpindleSpeed };

// Names as the command line spells them: acceleration velocity displacement sound force current speed.
std::string_view name(SensorQuantity q);
std::optional<SensorQuantity> sensorQuantityFromName(std::string_view text);
// SI unit the conditioner makes: m/s2 m/s m Pa N A rev/min.
std::string_view siUnit(SensorQuantity q);
// Caliskan 2018 eq. 28: eta = 1 displacement, 0 velocity, sound, speed, current (and force), -1 acceleration.
int integrationFactor(SensorQuantity q);

struct ChannelInfo {
  std::string name;  // "x", "mic"
  SensorQuantity quantity = SensorQuantity::Acceleration;
  double scale = 1.0;  // SI units per device unit
  std::string axis;    // "x", "y", "z", or empty
  // As given in a profile; the scale follows from the two numbers where they are given.
  double sensitivity = 0.0;  // mV per unit of the data sheet: g for acceleration, else the SI unit; 0: not given
  double volts = 0.0;        // of one device unit
  std::string coupling{};    // "iepe", "ac", "dc", or empty
  std::string place{};       // "spindle nose"
};

// SI units per device unit of a sensor with `sensitivity` mV per g, Pa, N ... on an input of `volts` V per device unit.
double scaleOf(SensorQuantity q, double sensitivity, double volts);

}  // namespace stillcut
