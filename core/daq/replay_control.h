// ReplayControl: the hand on a replay: pace, pause, single steps, a place to go to, a loop between two times. The
// screen moves it, the replay reads it before every block. Thread: the setters on one thread (the screen's), the rest
// on the driver's; wait-free on both sides. Times are the recording's own, from its first sample.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "core/base/time.h"
#include "core/rt/mailbox.h"
#include "core/rt/wakeup.h"

namespace stillcut::daq {

inline constexpr double kSlowestPace = 0.1;
inline constexpr double kFastestPace = 1000.0;

class ReplayControl {
 public:
  struct Loop {
    Seconds from{}, to{};
    bool on = false;
  };

  // 0: as fast as possible; else 0.1 to 1000 times real time, what lies outside is brought inside.
  void setPace(double times) noexcept;
  void pause() noexcept;
  void resume() noexcept;
  // While paused: so many more blocks.
  void step(int blocks = 1) noexcept;
  void goTo(Seconds time) noexcept;
  // After the block that holds `to` comes the one that holds `from`, again and again.
  void loopBetween(Seconds from, Seconds to) noexcept;
  void endLoop() noexcept;
  // Of the newest block handed out: where in the recording it ends.
  Seconds position() const noexcept { return Seconds(position_.load(std::memory_order_relaxed)); }
  bool paused() const noexcept { return paused_.load(std::memory_order_relaxed); }
  double pace() const noexcept { return pace_.load(std::memory_order_relaxed); }

  // The replay's side.
  // True: the next block may go out now (a step is used up by asking).
  bool mayGo() noexcept;
  std::optional<Seconds> takeGoTo() noexcept { return places_.take(); }
  Loop loop() noexcept { return loops_.latest().value_or(Loop{}); }
  void tellPosition(Seconds position) noexcept { position_.store(position.value, std::memory_order_relaxed); }
  // Waits until something was changed, or the time is over.
  void waitFor(Seconds limit) noexcept { changed_.waitFor(limit); }
  void wake() noexcept { changed_.notify(); }

 private:
  std::atomic<double> pace_{0.0};
  std::atomic<bool> paused_{false};
  std::atomic<int> steps_{0};
  std::atomic<double> position_{0.0};  // [s]
  rt::Mailbox<Seconds> places_;
  rt::Mailbox<Loop> loops_;
  rt::Wakeup changed_;
};

}  // namespace stillcut::daq
