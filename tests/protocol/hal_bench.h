// A LinuxCNC link with stillcut-hal beside the machine, all in memory and on virtual time.
#pragma once

#include <memory>

#include "core/cnc/linuxcnc/linuxcnc_link.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/fake_hal.h"

namespace stillcut::cnc::testing {

struct HalBench {
  static constexpr double kStep = 0.002;

  explicit HalBench(bool adaptiveFeed = false) {
    LinuxCncLink::Wires wires;
    const auto wire = [&](Peer& peer, WireFaults& its) { return std::make_unique<ScriptedWire>(clock, its, peer); };
    auto control = wire(hal, faults);
    component = control.get();
    wires.control = std::move(control);
    auto seen = wire(watch, watchFaults);
    watchWire = seen.get();
    wires.watch = std::move(seen);
    wires.hal = wire(halrmt, faults);
    LinuxCncSettings settings;
    settings.component.port = 5008;
    settings.adaptiveFeed = adaptiveFeed;
    link = std::make_unique<LinuxCncLink>(settings, std::move(wires), clock);
    for (int i = 0; i < 700; ++i) machine();  // long enough for the watchdog to be seen acting
  }
  void machine() {
    clock.advance(Seconds(kStep));
    hal.tick();
  }
  MachineState run(double seconds) {
    MachineState m;
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end; machine()) {
      m = link->read(clock.now());
    }
    return m;
  }
  // The machine alone: Stillcut hangs.
  void leave(double seconds) {
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end;) machine();
  }
  void engage(double percent) {
    run(0.2);
    link->apply(gate.set(percent), clock.now());
    run(0.3);
  }

  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults, watchFaults;
  FakeMill mill;
  FakeEmcClient watch{mill}, halrmt{mill};
  FakeHal hal{mill, clock};
  ScriptedWire *component = nullptr, *watchWire = nullptr;
  CommandMaker gate;
  std::unique_ptr<LinuxCncLink> link;
};

}  // namespace stillcut::cnc::testing
