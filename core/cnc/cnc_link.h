// CncLink: the wire to one machine. How to add one: core/cnc/ADDING.md.
// Thread: describe() and open() at set-up; the rest on the link thread, which reads every few milliseconds and may
// block for at most the link's own time-out. Never touched by the worker: commands come through a mailbox, states go
// back through one.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/model/machine_state.h"
#include "core/model/override_command.h"

namespace stillcut::cnc {

struct LinkInfo {
  std::string_view id;  // "simulated", "linuxcnc"
  std::string_view label;
  bool simulated = false;        // only such a machine takes a replay or a simulated cut
  bool machineWatchdog = false;  // the machine itself restores 100 % when we fall silent
  bool kept = false;             // another process brings the operator's values back when this program dies or hangs
  Ratio lowestSpeed{1.0}, highestSpeed{1.0};  // what the machine's override can do
  Ratio lowestFeed{1.0}, highestFeed{1.0};
  // Longest time between two readings of the same quantity while all is well: what "stale" is measured by.
  Seconds period{};
};

class CncLink {
 public:
  virtual ~CncLink() = default;
  virtual LinkInfo describe() const = 0;  // known before open()
  virtual Status open() = 0;              // one line when it cannot begin; the machine may still be away
  // Reads the machine. `now` is the link thread's stream time; the state carries the time it was read.
  virtual MachineState read(Instant now) noexcept = 0;
  // Sends a command. The caller (LinkRunner) has checked its lease.
  virtual void apply(const OverrideCommand& command, Instant now) noexcept = 0;
  // Brings the programmed values back. Called on lease expiry, on every end, and by the destructor of the runner.
  // Must work without a command: safety does not wait for the gate.
  virtual void release(Instant now) noexcept = 0;
  // Before a release(): what stands in the overrides named was left by a program of ours that died, and this is what
  // the operator had: home. Sends nothing. A link whose overrides are registers of its own takes it that they hold
  // something of ours, and home is 100 %; one that writes on open() needs none.
  virtual void adopt(std::optional<Ratio> /*speed*/, std::optional<Ratio> /*feed*/) noexcept {}
  // The last call on the link thread: lets go of wires, which belong to the thread that used them.
  virtual void close() noexcept {}
};

}  // namespace stillcut::cnc
