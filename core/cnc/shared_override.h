// SharedOverride: an override that has one register for everybody. The operator's pendant and we write the same
// percentage, so our factor must be told apart from the operator's: the base is what stood there before us, ours
// multiplies it, and any value that shows up without our having sent it is the operator's hand. Then ours is over: the
// new value is the base, and nothing is sent until the engagement that was running has ended. LinuxCNC's feed and
// spindle override work so, and GRBL's. Thread: link thread. Real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut::cnc {

class SharedOverride {
 public:
  // Percentages this register can hold.
  SharedOverride(int lowest, int highest) : lowest_(lowest), highest_(highest) {}

  // The register was read: `percent`. Values we sent within the last `settle` may show up late and in order.
  void seen(int percent, Instant now) noexcept;
  // Our factor on the base, of engagement `engagement`; ignored while the operator's hand has ended that engagement.
  void want(Ratio factor, std::uint64_t engagement) noexcept;
  // The base comes back; what was sent is forgotten once it has been seen.
  void relinquish() noexcept;
  // A percentage that should be sent now, because the register shows or was last sent another; none before the
  // register has been seen once. Say sent() when it went out.
  std::optional<int> due() const noexcept;
  void sent(int percent, Instant now) noexcept;
  // The peer refused: what was sent is not on its way.
  void refused() noexcept;
  // The connection broke: the register must be seen again before anything is sent. What we ever sent on this base is
  // still ours then, however long it has stood: nobody saw whose hand it was, and home is what the operator chose last.
  void lost() noexcept;
  // The peer began anew, with values of its own: as lost(), but nothing that stands there is taken for ours.
  void restarted() noexcept;

  // Nothing of ours stands in the register, or all that is left is on its way out.
  bool atBase() const { return sentCount_ == 0 || (shown_ && underway_.value_or(*shown_) == base_); }
  // The base itself was seen, and nothing is on its way.
  bool baseConfirmed() const { return sentCount_ == 0 || (shown_ == base_ && !underway_); }
  // All that was sent has been seen, or was given up.
  bool settled() const { return !underway_; }
  bool known() const { return shown_.has_value(); }
  int shown() const { return shown_.value_or(100); }
  // Where it should stand: the base times our factor, within the register's range.
  int target() const noexcept;
  // The operator's hand has ended the engagement that is running.
  bool grabbed() const { return grabbed_; }
  // The operator's part, 1.0 is 100 %.
  Ratio base() const { return Ratio(base_ * 0.01); }

 private:
  struct Sent {
    int percent = 0;
    Instant when{};
  };
  bool mayBeOurs(int percent, Instant now) const noexcept;
  bool everSent(int percent) const noexcept;

  int lowest_, highest_;
  std::optional<int> shown_;
  std::optional<int> underway_;  // sent, not seen yet
  int base_ = 100;
  double factor_ = 1.0;
  std::uint64_t engagement_ = 0;
  bool grabbed_ = false;
  bool rejoining_ = false;       // lost, and not seen since
  std::array<Sent, 64> sent_{};  // a ring
  std::uint64_t sentCount_ = 0;
};

}  // namespace stillcut::cnc
