// A link to the real LinuxCNC while long.ngc cuts, for the tests against it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "app/io/wires.h"
#include "core/cnc/registry.h"
#include "tests/protocol/commands.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/linuxcnc/linuxcnc_peer.h"

namespace stillcut::cnc::testing {

inline std::unique_ptr<CncLink> linkToLinuxCnc(std::map<std::string, std::string> settings = {}) {
  static const SteadyClock clock;
  LinkRequest request;
  request.settings = std::move(settings);
  request.settings["host"] = "127.0.0.1";
  request.wires = app::makeWire;
  request.clock = &clock;
  return std::move(makeLink("linuxcnc", request)).value();
}

class LinuxCncBench : public ::testing::Test {
 protected:
  // long.ngc at its speed.
  static bool cutting(const MachineState& m) {
    return m.valid && m.programRunning && m.programmedSpeed.value == 8000.0 &&
           std::abs(m.actualSpeed.value - 8000.0) < 40.0;
  }
  static bool at(const MachineState& m, double share) {
    return m.valid && std::abs(m.speedOverride.value - share) < 1e-6 && std::abs(m.feedOverride.value - share) < 1e-6;
  }
  // Ticks of the link thread until `wanted`, or false after `seconds`.
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 8.0) {
    return within(Seconds(seconds), [&] {
      seen_ = link_->read(clock_.now());
      return wanted(seen_);
    });
  }
  // The same while `percent` is commanded. A stall of this host that is longer than the component's lease ends an
  // engagement, as it should: another begins.
  bool untilCommanding(double percent, const std::function<bool(const MachineState&)>& wanted) {
    for (int attempt = 0; attempt < 4; ++attempt) {
      const OverrideCommand command = gate_.set(percent);
      const auto commanded = [&](const MachineState& m) {
        link_->apply(command, clock_.now());
        return wanted(m);
      };
      if (until(commanded, 4.0)) return true;
      link_->apply(gate_.relinquish(), clock_.now());
      until([](const MachineState& m) { return at(m, 1.0); }, 2.0);
    }
    return false;
  }
  void apply(double percent) { link_->apply(gate_.set(percent), clock_.now()); }

  SteadyClock clock_;
  std::unique_ptr<CncLink> link_;
  CommandMaker gate_;
  MachineState seen_;
};

}  // namespace stillcut::cnc::testing
