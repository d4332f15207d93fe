// LinuxCncLink: a machine run by LinuxCNC. One conversation with linuxcncrsh watches, one with halrmt measures, and a
// hand turns the knobs: linuxcncrsh's own, or stillcut-hal beside the machine, which has a watchdog.
//   watch     overrides, program, S and F words, machine on
//   hal       spindle.0.speed-in, speed-out, at-speed; motion.current-vel, feed-hold, adaptive-feed
//   hand      RshBackend (an override's ACK takes 100 ms, a get 0.05 ms) or HalBackend
// At most one request to linuxcncrsh is under way at any time: with two links under load the machine was seen to go
// down. Not caught in the act; likely, as its sources (emcrsh.cc) split the requests of all clients, each on a thread
// of its own, with strtok, whose place is shared. Told to end it may hang, as it frees what those threads still read:
// nothing here waits for it longer than kReleaseTime.
// It is asked kQuestionsPerSecond times a second at most, and whatever the hand has to say goes before any question
// while commands end: a question that is slow to be answered must not keep a release from the machine.
// An ACK is not believed: under M49, M50 P0 and M51 P0 a set is acknowledged and even read back, and only speed-out and
// current-vel tell; under M52 P0 adaptive-feed has no effect.
// Thread: as CncLink says. A tick waits for replies at most kWait; all of letting go takes at most kReleaseTime, and
// ends earlier where a server that was up falls silent.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/cnc/cnc_link.h"
#include "core/cnc/delay_gauge.h"
#include "core/cnc/linuxcnc/emc_backend.h"
#include "core/cnc/linuxcnc/emc_session.h"
#include "core/cnc/linuxcnc/emc_status.h"
#include "core/cnc/linuxcnc/override_lock_detector.h"
#include "core/cnc/release_budget.h"
#include "core/cnc/shared_override.h"

namespace stillcut::cnc {

struct LinuxCncSettings {
  WireAddress rsh{.host = "localhost", .port = 5007, .device = {}};
  WireAddress hal{.host = "localhost", .port = 5006, .device = {}};
  // stillcut-hal; port 0: there is none, and linuxcncrsh turns the knobs.
  WireAddress component{.host = "localhost", .port = 0, .device = {}};
  bool adaptiveFeed = false;               // with stillcut-hal: the feed by motion.adaptive-feed, which reduces only
  bool inches = false;                     // [TRAJ] LINEAR_UNITS = inch
  std::string password = "EMC";            // of the connection
  std::string controlPassword = "EMCTOO";  // of "set enable"
  // linuxcncrsh enforces no limit of its own, so these are the machine's [DISPLAY] limits, %.
  int lowestSpeed = 50, highestSpeed = 150, lowestFeed = 0, highestFeed = 150;
};

class LinuxCncLink final : public CncLink {
 public:
  struct Wires {
    std::unique_ptr<ByteChannel> control, watch, hal;  // control: to linuxcncrsh, or to stillcut-hal
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
  void adopt(std::optional<Ratio> speed, std::optional<Ratio> feed) noexcept override {
    if (speed) overrides_.speed.adopt(*speed);
    if (feed) overrides_.feed.adopt(*feed);
  }
  void close() noexcept override;

  static constexpr Duration kWait = std::chrono::milliseconds(2);
  static constexpr Duration kReleaseTime = std::chrono::milliseconds(1500);

 private:
  struct Question {
    std::string_view text;
    Duration every{};
    std::optional<Instant> asked{};  // none: at once
  };
  void watchMachine(Instant now) noexcept;
  void askOne(Instant now) noexcept;
  bool mayAsk(Instant now) noexcept;
  void command(Instant now) noexcept;
  Error backendFault() const;
  MachineState state(Instant now) noexcept;
  void checkEffect(MachineState& state, Instant now) noexcept;
  OverrideInhibit block(const MachineState& state, Instant now) const noexcept;

  LinuxCncSettings settings_;
  const Clock& clock_;
  std::unique_ptr<EmcBackend> backend_;
  EmcSession watch_, hal_;
  EmcStatus status_;
  EmcOverrides overrides_;
  bool wanted_ = false;  // commands are to be sent
  // The two overrides have been read since the hand spoke: commands that come with every tick must not keep the watch
  // from looking. On the way home the hand does not wait for it.
  bool handsTurn_ = false;
  int readSinceHand_ = 0;
  bool yielded_ = false;  // the watch, to a hand that is not connected
  std::array<Question, 5> questions_;
  double tokens_ = 0.0;  // questions that may be asked now
  Instant tokensAt_{};
  std::optional<Instant> halRound_;
  std::size_t nextHal_ = 0;
  DelayGauge look_;  // of a get
  OverrideLockDetector speedLock_, feedLock_, adaptiveLock_;
  ReleaseBudget releaseBudget_;
};

}  // namespace stillcut::cnc
