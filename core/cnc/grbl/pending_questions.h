// PendingQuestions: the questions whose answers are still on their way. Answers come in the order of the questions, but
// one may stay out: then the next answer is taken for its own, and counts as older than it is, never as newer.
// Thread: link thread. Real-time safe.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

#include "core/base/time.h"

namespace stillcut::cnc {

class PendingQuestions {
 public:
  // What has not been answered by then is not answered any more.
  static constexpr Duration kLongestTrip = std::chrono::seconds(1);

  void asked(Instant now) noexcept {
    forgetOld(now);
    if (count_ == asked_.size()) dropOldest();
    asked_[count_++] = now;
  }
  // An answer: when its question was asked, as far as can be told; none: nobody had asked.
  std::optional<Instant> answered(Instant now) noexcept {
    forgetOld(now);
    if (count_ == 0) return std::nullopt;
    const Instant when = asked_.front();
    dropOldest();
    return when;
  }
  // How many answers may still come.
  std::size_t count(Instant now) noexcept {
    forgetOld(now);
    return count_;
  }
  void clear() noexcept { count_ = 0; }

 private:
  void forgetOld(Instant now) noexcept {
    while (count_ > 0 && now - asked_.front() > kLongestTrip) dropOldest();
  }
  void dropOldest() noexcept {
    std::move(asked_.begin() + 1, asked_.begin() + static_cast<std::ptrdiff_t>(count_), asked_.begin());
    --count_;
  }

  std::array<Instant, 8> asked_{};  // oldest first
  std::size_t count_ = 0;
};

}  // namespace stillcut::cnc
