// HalBackend: the knobs through stillcut-hal, the program with HAL pins beside LinuxCNC
// (core/cnc/linuxcnc/hal_messages.h). It needs no control of linuxcncrsh, so the operator's own screen keeps it, and
// the machine goes home by itself when we fall silent. A knob that the operator turned is left alone at once. While
// commands are given every request renews the lease, and one that lets go waits for no answer. Thread: link thread.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "core/cnc/byte_channel.h"
#include "core/cnc/delay_gauge.h"
#include "core/cnc/line_splitter.h"
#include "core/cnc/linuxcnc/emc_backend.h"
#include "core/cnc/linuxcnc/hal_messages.h"

namespace stillcut::cnc {

class HalBackend final : public EmcBackend {
 public:
  // `adaptiveFeed`: the feed goes through the factor, not through the override.
  HalBackend(std::unique_ptr<ByteChannel> channel, bool adaptiveFeed, const Clock& clock);

  bool hasWord(const EmcOverrides&, bool, Instant) const noexcept override { return false; }  // a wire of its own
  void turn(EmcOverrides& knobs, bool wanted, bool maySpeak, EmcStatus& status, Instant now) noexcept override;
  bool speaking() const noexcept override { return false; }
  bool done(const EmcOverrides& knobs) const noexcept override;
  OverrideInhibit block(Instant now) const noexcept override;
  bool up() const noexcept override;
  bool heard() const noexcept override { return heard_; }
  // Of what has been heard last: it outlives a connection that is closed between open() and the link thread.
  bool watchdog() const noexcept override { return report_.watchdogMs > 0; }
  Seconds roundTrip() const noexcept override { return roundTrip_.typical(); }
  Instant acknowledged() const noexcept override { return acknowledged_; }
  void wait(Duration atMost) noexcept override { channel_->wait(atMost); }
  void close() noexcept override;
  std::string_view address() const noexcept override { return channel_->address(); }

 private:
  struct Turned {
    int goal = 100, written = 100;
    bool nudging = false;
    Instant since{};
  };
  static bool arrived(const SharedOverride& knob);
  // Something of ours is seen to stand there; what is on its way home may have been lost on it.
  static bool left(const SharedOverride& knob);
  static std::optional<int> turn(SharedOverride& knob, Turned& turned, int target, std::optional<int> kept,
                                 Instant read, Instant now) noexcept;
  double feedBySpeed(const SharedOverride& speed, double wanted, double present) const noexcept;
  bool keepUp(Instant now) noexcept;
  void listen(Instant now) noexcept;
  void answered(Instant now) noexcept;
  void send(EmcOverrides& knobs, bool wanted, const EmcStatus& status, Instant now) noexcept;

  std::unique_ptr<ByteChannel> channel_;
  bool adaptiveFeed_;
  const Clock& clock_;
  LineSplitter splitter_;
  HalReport report_;
  HalRequest last_;
  Turned speed_, feed_;
  DelayGauge roundTrip_;
  bool heard_ = false;  // on this connection
  // What was sent and is not answered yet, oldest first. A lease is renewed without waiting for the answers: they take
  // longer than the lease where the machine is far away.
  struct Unanswered {
    Instant sent{};
    bool hold = false;
  };
  std::array<Unanswered, 32> unanswered_{};
  std::size_t waitingFor_ = 0;
  bool wanted_ = false;                           // when it was sent last
  Instant asked_{}, nextTry_{}, acknowledged_{};  // asked_: sent last, or connecting since
};

}  // namespace stillcut::cnc
