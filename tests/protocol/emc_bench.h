// A LinuxCNC link through linuxcncrsh to a scripted machine, all in memory and on virtual time.
#pragma once

#include <memory>

#include "core/cnc/linuxcnc/linuxcnc_link.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/fake_emc.h"

namespace stillcut::cnc::testing {

struct EmcBench {
  EmcBench() {
    auto make = [&](FakeEmcClient& client, ScriptedWire*& seen) {
      auto wire = std::make_unique<ScriptedWire>(clock, faults, client);
      seen = wire.get();
      return wire;
    };
    LinuxCncLink::Wires wires;
    wires.control = make(control, controlWire);
    wires.watch = make(watch, watchWire);
    wires.hal = make(hal, halWire);
    link = std::make_unique<LinuxCncLink>(LinuxCncSettings{}, std::move(wires), clock);
  }
  // The link thread's ticks; the spindle follows with a time constant of 0.1 s.
  MachineState run(double seconds) {
    const Instant until = clock.now() + toDuration(Seconds(seconds));
    MachineState m;
    while (clock.now() < until) {
      const Instant before = clock.now();
      m = link->read(before);
      clock.advance(Seconds(0.005));
      mill.actual += (mill.commanded() - mill.actual) * secondsBetween(before, clock.now()).value / 0.1;
    }
    return m;
  }

  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeMill mill;
  FakeEmcClient control{mill}, watch{mill}, hal{mill}, other{mill};
  ScriptedWire *controlWire = nullptr, *watchWire = nullptr, *halWire = nullptr;
  CommandMaker gate;
  std::unique_ptr<LinuxCncLink> link;
};

}  // namespace stillcut::cnc::testing
