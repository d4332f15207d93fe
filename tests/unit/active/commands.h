// Commands as only the gate can make them, for tests of what devices do with them.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "core/safety/actuator_gate.h"

namespace stillcut::active {

// Values up to 10, sample by sample.
inline std::vector<safety::ActuatorCommand> commanded(std::initializer_list<double> values) {
  constexpr Hertz kRate{1000.0};
  safety::ActuatorGate gate;
  EXPECT_TRUE(gate.prepare({.amplitude = 10.0, .slew = 1e6, .rampIn = Seconds(0.001)}, kRate).ok());
  gate.engage();
  gate.drive(0.0, 1.0);
  std::vector<safety::ActuatorCommand> commands;
  for (const double value : values) {
    gate.renew();
    commands.push_back(gate.drive(value, static_cast<double>(commands.size())));
    EXPECT_EQ(commands.back().value(), value);
  }
  return commands;
}

}  // namespace stillcut::active
