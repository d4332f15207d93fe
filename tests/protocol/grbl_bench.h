// A GRBL link on a scripted controller, on virtual time. Thread: one.
#pragma once

#include <memory>

#include "core/cnc/grbl/grbl_link.h"
#include "tests/protocol/commands.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc::testing {

// boot: s that the controller is deaf after its port is opened.
struct GrblBench {
  explicit GrblBench(double boot = 0.0, const GrblSettings& settings = {}) {
    grbl.boot = boot;
    auto made = std::make_unique<ScriptedWire>(clock, faults, grbl);
    wire = made.get();
    link = std::make_unique<GrblLink>(settings, std::move(made), clock);
  }
  MachineState run(double seconds) {
    const Instant until = clock.now() + toDuration(Seconds(seconds));
    MachineState m;
    while (clock.now() < until) {
      m = link->read(clock.now());
      clock.advance(Seconds(0.005));
    }
    return m;
  }
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeGrbl grbl;
  ScriptedWire* wire = nullptr;
  CommandMaker gate;
  std::unique_ptr<GrblLink> link;
};

}  // namespace stillcut::cnc::testing
