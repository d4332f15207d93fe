// LinuxCncLink: a machine run by LinuxCNC. Two conversations with linuxcncrsh, one that commands and one that watches
// (an override's ACK takes 100 ms, a get 0.05 ms), and one with halrmt for the spindle's measured speed.
//   control   takes control ("set enable") with the first command, sets the two overrides, gives control back
//   watch     overrides, program, S and F words, machine on
//   hal       spindle.0.speed-in, speed-out, at-speed; motion.current-vel, feed-hold, adaptive-feed
// Only one of the first two has a request under way at any time: linuxcncrsh serves each client on a thread of its own
// and may take requests apart in memory that they share: with two links at once under load the machine was seen to go
// down. The cause was not traced, so this keeps clear of it.
// The ACK is not believed: under M49 and M51 P0 a set is acknowledged and even read back, and only speed-out tells.
// The overrides stay where they are when we die: describe() says that the machine has no watchdog of its own.
// Thread: as CncLink says. A tick waits for replies at most kWait; release() at most kReleaseTime.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/cnc/cnc_link.h"
#include "core/cnc/emc_session.h"
#include "core/cnc/emc_status.h"
#include "core/cnc/shared_knob.h"

namespace stillcut::cnc {

struct LinuxCncSettings {
  WireAddress rsh{.host = "localhost", .port = 5007, .device = {}};
  WireAddress hal{.host = "localhost", .port = 5006, .device = {}};
  std::string password = "EMC";            // of the connection
  std::string controlPassword = "EMCTOO";  // of "set enable"
  // linuxcncrsh enforces no limit of its own, so these are the machine's [DISPLAY] limits, %.
  int lowestSpeed = 50, highestSpeed = 150, lowestFeed = 0, highestFeed = 150;
};

class LinuxCncLink final : public CncLink {
 public:
  struct Wires {
    std::unique_ptr<ByteChannel> control, watch, hal;
  };
  // `clock` bounds what open() and release() wait.
  LinuxCncLink(const LinuxCncSettings& settings, Wires wires, const Clock& clock);
  ~LinuxCncLink() override;

  LinkInfo describe() const override;
  // Connects, greets and reads once; then lets go of the wires, which the link thread takes up anew.
  Status open() override;
  MachineState read(Instant now) noexcept override;
  void apply(const OverrideCommand& command, Instant now) noexcept override;
  void release(Instant now) noexcept override;
  void close() noexcept override;

  static constexpr Duration kWait = std::chrono::milliseconds(2);
  static constexpr Duration kReleaseTime = std::chrono::milliseconds(1500);

 private:
  enum class Asked : std::uint8_t { Nothing, Enable, WaitMode, Speed, Feed, GiveBack, Standing };

  void watchMachine(Instant now) noexcept;
  void command(Instant now) noexcept;
  void commandReply(std::string_view line, Instant now) noexcept;
  void askCommand(Asked what, std::string_view request, Instant now) noexcept;
  void setOverride(Asked what, SharedKnob& knob, Instant now) noexcept;
  MachineState state(Instant now) noexcept;
  void judgeEffect(MachineState& state, Instant now) noexcept;

  LinuxCncSettings settings_;
  const Clock& clock_;
  EmcSession control_, watch_, hal_;
  EmcStatus status_;
  SharedKnob speed_, feed_;
  std::string enable_;
  bool wanted_ = false;     // commands are to be sent: control is needed
  bool inControl_ = false;  // as far as we know
  bool waitModeSet_ = false;
  std::optional<Instant> lostAt_;  // another client took it
  Asked asked_ = Asked::Nothing;
  std::size_t nextWatch_ = 0, nextHal_ = 0;
  std::optional<Instant> mismatch_;  // since when the read-back and the spindle disagree
  bool locked_ = false;              // M49, M51 P0
};

}  // namespace stillcut::cnc
