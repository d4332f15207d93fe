// HeartbeatWatch: whose heartbeat counts in a register that is read back. Only a program in command lets it count, so a
// count that is not ours is another master's, on another computer perhaps, where no lock of this one reaches.
// Thread: link thread. Real-time safe.
#pragma once

#include <cmath>
#include <optional>
#include <utility>

#include "core/base/time.h"

namespace stillcut::cnc {

class HeartbeatWatch {
 public:
  // It goes out, and may or may not arrive.
  void sent(double count) noexcept { before_ = std::exchange(sent_, count); }
  void seen(double count, Instant now) noexcept {
    const auto is = [count](const std::optional<double>& other) { return other && std::abs(count - *other) < 0.5; };
    if (last_ && !is(last_) && !is(sent_) && !is(before_)) anothers_ = now;
    last_ = count;
  }
  // The connection broke: what stands there next says nothing of who wrote it.
  void lost() noexcept { last_.reset(); }
  // Another one has counted within that time.
  bool anothers(Instant now, Duration within) const noexcept { return anothers_ && now - *anothers_ <= within; }

 private:
  std::optional<double> sent_, before_, last_;
  std::optional<Instant> anothers_;
};

}  // namespace stillcut::cnc
