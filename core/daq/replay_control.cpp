#include "core/daq/replay_control.h"

#include <algorithm>

namespace stillcut::daq {

void ReplayControl::setPace(double times) noexcept {
  const bool paced = times > 0.0;  // not for NaN
  pace_.store(paced ? std::clamp(times, kSlowestPace, kFastestPace) : 0.0, std::memory_order_relaxed);
  wake();
}

void ReplayControl::pause() noexcept {
  steps_.store(0, std::memory_order_relaxed);
  paused_.store(true, std::memory_order_release);
  wake();
}

void ReplayControl::resume() noexcept {
  paused_.store(false, std::memory_order_release);
  wake();
}

void ReplayControl::step(int blocks) noexcept {
  steps_.fetch_add(std::max(0, blocks), std::memory_order_relaxed);
  wake();
}

void ReplayControl::goTo(Seconds time) noexcept {
  places_.post(time);
  wake();
}

void ReplayControl::loopBetween(Seconds from, Seconds to) noexcept {
  loops_.post({from, to, from < to});
  wake();
}

void ReplayControl::endLoop() noexcept {
  loops_.post({});
  wake();
}

bool ReplayControl::mayGo() noexcept {
  if (!paused_.load(std::memory_order_acquire)) return true;
  if (steps_.load(std::memory_order_relaxed) <= 0) return false;
  steps_.fetch_sub(1, std::memory_order_relaxed);
  return true;
}

}  // namespace stillcut::daq
