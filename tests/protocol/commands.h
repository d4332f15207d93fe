// Commands as only the gate can make them, for tests of what links do with them.
#pragma once

#include <cmath>
#include <stdexcept>

#include "tests/support/gate_harness.h"

namespace stillcut::cnc::testing {

// The gate commands both overrides to `percent` of the programmed values (80 to 105).
class CommandMaker {
 public:
  OverrideCommand set(double percent) {
    gate_.settleAt(10000.0 * percent / 100.0, 1000.0 * percent / 100.0);
    for (int i = 0; i < 500; ++i) {
      const safety::GateOutput out = gate_.step();
      if (out.command && std::abs(out.command->speed().value - percent / 100.0) < 0.001) return *out.command;
    }
    throw std::runtime_error("the gate does not reach this speed");
  }
  OverrideCommand relinquish() {
    for (int i = 0; i < 500; ++i) {
      const safety::GateOutput out = gate_.authority(Authority::Off);
      if (out.command && out.command->kind() == CommandKind::Release) return *out.command;
    }
    throw std::runtime_error("the gate does not let go");
  }

 private:
  safety::testing::GateHarness gate_;
};

}  // namespace stillcut::cnc::testing
