// OverrideCommand: the one value a machine link obeys. Only safety::OverrideGate can construct one (house rule 3).
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/reason.h"

namespace stillcut {

namespace safety {
class OverrideGate;
}

enum class CommandKind : std::uint8_t {
  Set,      // drive the overrides to `speed` and `feed`
  Release,  // bring the programmed values back and let go
};

// The same content as a plain record, for screens and files: it cannot be sent to a link.
struct CommandRecord {
  Instant time{};
  std::uint64_t sequence = 0;
  CommandKind kind = CommandKind::Release;
  Ratio speed{1.0};
  Ratio feed{1.0};
  Duration lease{};
  Reason reason;
  // Counts how often the overrides were taken from 100 %. A lease that ran out ends its engagement: the link obeys no
  // further Set of the same number, so that a worker that wakes up cannot jump back to where it was.
  std::uint64_t engagement = 0;
};

class OverrideCommand {
 public:
  // Stream time of the decision.
  Instant time() const { return record_.time; }
  // Counts commands; a link that sees the same number twice has nothing new.
  std::uint64_t sequence() const { return record_.sequence; }
  CommandKind kind() const { return record_.kind; }
  // Our factor on the programmed value; the machine multiplies with the operator's own knob. Finite, inside limits.
  Ratio speed() const { return record_.speed; }
  Ratio feed() const { return record_.feed; }
  // How long it may stay in force without being renewed by a newer command.
  Duration lease() const { return record_.lease; }
  std::uint64_t engagement() const { return record_.engagement; }
  const CommandRecord& record() const { return record_; }

 private:
  friend class safety::OverrideGate;
  explicit OverrideCommand(const CommandRecord& record) : record_(record) {}

  CommandRecord record_;
};

}  // namespace stillcut
