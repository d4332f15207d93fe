// OverrideArbiter: what stillcut-hal's pins show, from what the client asks and what the machine's watchdog answers.
// A lease: requests must keep coming, or the pins go home. Behind it stands the machine's own watchdog, which does the
// same when the heartbeat pin stops, whatever became of this program (packaging/linuxcnc/stillcut.hal). Nothing is
// taken before that watchdog was seen to act: armed with the knobs at home, left without a heartbeat, timed until it
// lets go.
// Several clients may look; one holds, and until it has let go nobody else's word counts.
// Thread: one. Real-time safe; knows no HAL.
#pragma once

#include <chrono>

#include "core/base/time.h"
#include "core/cnc/linuxcnc/hal_messages.h"

namespace stillcut::hal {

struct ArbiterInputs {
  bool watchdogOk = false;  // of the machine's watchdog: armed, and the heartbeat is in time
  bool permit = true;       // the operator's switch
};

struct ArbiterPins {
  bool active = false;     // arms the watchdog
  bool heartbeat = false;  // changes with every tick while active
  // The machine follows the two percentages only while these are set; they stay for a while after the end, so that the
  // way home is followed as well.
  bool speedEnable = false, feedEnable = false;
  int speed = 100, feed = 100;
  double adaptiveFeed = 1.0;
  int restoreSpeed = 100, restoreFeed = 100;  // what the machine takes when the watchdog is not ok
};

class OverrideArbiter {
 public:
  static constexpr Duration kLease = std::chrono::milliseconds(60);
  static constexpr Duration kPatience = std::chrono::milliseconds(100);  // for the watchdog to answer an arming
  // With halui's way home (up to 130 ms for both) within 300 ms. Measured by a program that this host may
  // hold up: one that takes longer is measured again.
  static constexpr Duration kLongestProof = std::chrono::milliseconds(70);
  static constexpr Duration kRetry = std::chrono::seconds(1);
  // halui takes up to 130 ms for both, on a busy computer longer; it sends a percentage once, when it changes, so that
  // a hand is not disturbed by knobs that are kept.
  static constexpr Duration kRestoreTime = std::chrono::milliseconds(1000);
  // The watchdog is armed by a rising edge: a few periods of the machine's thread must have seen the pin low.
  static constexpr Duration kRest = std::chrono::milliseconds(10);
  static constexpr Duration kShortestBeat = std::chrono::milliseconds(2);

  // `client`: any number above 0 that is one client's alone.
  void take(const cnc::HalRequest& request, int client, Instant now) noexcept;
  void clientGone(int client, Instant now) noexcept;
  // This program ends.
  void end(Instant now) noexcept;
  // Every few milliseconds; a heartbeat each, but none that is too short for the machine's thread to see.
  const ArbiterPins& tick(const ArbiterInputs& in, Instant now) noexcept;
  cnc::HalReport report(int client) const noexcept;

 private:
  enum class Stage : std::uint8_t { Resting, Arming, Listening, Home, Held, Fallen };

  void enter(Stage stage, Instant now) noexcept;
  void prove(const ArbiterInputs& in, Instant now) noexcept;
  void hold(const ArbiterInputs& in, Instant now) noexcept;
  void show(Instant now) noexcept;
  bool engaged() const noexcept { return stage_ == Stage::Held || stage_ == Stage::Fallen; }

  Stage stage_ = Stage::Resting;
  Instant since_{}, renewed_{}, letGo_{}, beat_{};
  cnc::HalRequest request_;
  ArbiterPins pins_;
  bool armed_ = false;  // the watchdog has said ok in this engagement
  // A percentage of ours may stand in the machine: the way home is walked, whatever the client says of it by then.
  bool tookSpeed_ = false, tookFeed_ = false;
  int holder_ = 0;  // while Held or Fallen
  // Fell, and said nothing for the time of a lease: it keeps nobody out any more, and has still to let go itself.
  int lapsed_ = 0;
  int watchdogMs_ = 0;
};

}  // namespace stillcut::hal
