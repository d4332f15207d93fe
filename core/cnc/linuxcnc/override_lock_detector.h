// OverrideLockDetector: whether an override acts that is acknowledged and read back. What the machine does tells: under
// M49, M50 P0, M51 P0 and M52 P0 it goes on as if there were none. A speed or feed that stands where it would be
// without the override, for a while in all, is one that is locked; one that stands where the override puts it is not.
// Anything else (a corner, a rapid move, the machine's own range) says nothing. While it cannot be told, a lock is
// believed for some seconds more: nobody says when the program ends it. Above what it would be without the override, a
// machine at its own limit looks the same: that is said of a lock too. Thread: link thread. Real-time safe.
#pragma once

#include <chrono>
#include <cmath>

#include "core/base/time.h"

namespace stillcut::cnc {

class OverrideLockDetector {
 public:
  // Factors on what is programmed: `with` the override, `without` it, and what is `seen`.
  void look(double with, double without, double seen, Instant now) noexcept {
    const bool tellsApart = std::abs(with - without) > kStep;
    const bool still = tellsApart && std::abs(seen - without) < 0.5 * kStep;
    if (still) raised_ = with > without;
    // Between two looks that agree, and not across a time when nobody looked.
    if (still && wasStill_ && now - last_ < kPause) stood_ += now - last_;
    wasStill_ = still;
    last_ = now;
    if (stood_ > kLockedAfter) locked_ = true;
    if (still) lastStill_ = now;
    const bool follows = tellsApart && std::abs(seen - with) < 0.5 * kStep;
    if (follows || (locked_ && !tellsApart && now - lastStill_ > kBelieved)) reset();
  }
  void reset() noexcept {
    stood_ = Duration::zero();
    locked_ = wasStill_ = false;
  }
  bool locked() const noexcept { return locked_; }
  // While it is locked: the machine's own limit would look like it.
  bool orLimit() const noexcept { return raised_; }

 private:
  static constexpr double kStep = 0.01;  // overrides are whole per cents
  // An override is in force within 0.1 s of its acknowledgement, and the spindle's commanded speed with it.
  static constexpr Duration kLockedAfter = std::chrono::milliseconds(1500);
  static constexpr Duration kBelieved = std::chrono::seconds(10);
  static constexpr Duration kPause = std::chrono::milliseconds(500);

  Duration stood_{};
  Instant last_{}, lastStill_{};
  bool wasStill_ = false, locked_ = false, raised_ = false;
};

}  // namespace stillcut::cnc
