// EffectGauge: how long an order takes until the machine's overrides show it. Each order of another whole per cent is
// noted; the first read-back of that per cent ends its wait, and that of all before it, which were overtaken. An order
// that never shows (a lock, the operator's hand, a range) counts for nothing.
// Thread: link thread. Real-time safe.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/cnc/delay_gauge.h"

namespace stillcut::cnc {

class EffectGauge {
 public:
  // `before`: what an earlier run has measured, which holds until an effect was seen; 0: nothing.
  explicit EffectGauge(Seconds before = {}) : before_(before) {}
  // Our factors on the programmed values; 1 and 1: let go.
  void commanded(Ratio speed, Ratio feed, Instant now) noexcept {
    const bool speedIsNew = speed_.note(speed, now);
    const bool feedIsNew = feed_.note(feed, now);
    if (speedIsNew || feedIsNew) newest_ = now;
  }
  // The same factors as read back at `when`; only what the machine itself has said.
  void shown(Ratio speed, Ratio feed, Instant when) noexcept {
    for (const auto delay : {speed_.found(speed, when), feed_.found(feed, when)}) {
      if (delay) gauge_.take(*delay);
    }
  }
  // Nothing that is under way will show.
  void forget() noexcept {
    speed_.forget();
    feed_.forget();
  }

  // When the newest order that differs from the one before was given; 0: none was.
  Instant newest() const noexcept { return newest_; }
  // 0: none was seen, now or before.
  Seconds typical() const noexcept { return gauge_.typical().value > 0.0 ? gauge_.typical() : before_; }

 private:
  static constexpr Duration kLatest = std::chrono::seconds(6);

  class Knob {
   public:
    bool note(Ratio factor, Instant now) noexcept {
      const int percent = wholePercent(factor);
      if (percent == last_) return false;
      last_ = percent;
      marks_[count_++ % marks_.size()] = {percent, now, true};
      return true;
    }
    std::optional<Seconds> found(Ratio factor, Instant when) noexcept {
      const int percent = wholePercent(factor);
      if (percent == shown_.value_or(percent + 1)) return std::nullopt;  // what stood there before is no effect
      shown_ = percent;
      for (std::size_t back = 0; back < std::min(count_, marks_.size()); ++back) {
        const Mark& mark = marks_[(count_ - 1 - back) % marks_.size()];
        if (!mark.waits) return std::nullopt;
        if (mark.percent != percent || mark.when >= when) continue;
        const Seconds delay = secondsBetween(mark.when, when);
        settle(back);
        return delay.value <= toSeconds(kLatest).value ? std::optional(delay) : std::nullopt;
      }
      return std::nullopt;
    }
    void forget() noexcept {
      marks_ = {};
      shown_.reset();
    }

   private:
    struct Mark {
      int percent = 100;
      Instant when{};
      bool waits = false;
    };
    static int wholePercent(Ratio factor) noexcept {
      return std::isfinite(factor.value) ? static_cast<int>(std::lround(100.0 * factor.value)) : -1;
    }
    void settle(std::size_t from) noexcept {
      for (std::size_t back = from; back < std::min(count_, marks_.size()); ++back) {
        marks_[(count_ - 1 - back) % marks_.size()].waits = false;
      }
    }

    int last_ = 100;
    std::optional<int> shown_;
    std::array<Mark, 32> marks_{};
    std::size_t count_ = 0;
  };

  Seconds before_;
  Knob speed_, feed_;
  DelayGauge gauge_;
  Instant newest_{};
};

}  // namespace stillcut::cnc
