// The events of one step have a fixed number of slots. What happens when they are full: the newest of the least
// important lines gives way to a more important one, and the loss is counted, to be said in a later step. Real-time
// safe, any thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/model/event.h"

namespace stillcut {

// Gives the number of events lost by it: 0 or 1. Order stays that of time.
template <std::size_t N>
int addEvent(std::array<Event, N>& slots, int& count, const Event& event) noexcept {
  const auto used = slots.begin() + std::min(static_cast<std::ptrdiff_t>(count), static_cast<std::ptrdiff_t>(N));
  if (used != slots.end()) {
    *used = event;
    ++count;
    return 0;
  }
  auto weakest = slots.begin();
  for (auto it = slots.begin(); it != used; ++it) {
    if (it->level <= weakest->level) weakest = it;
  }
  if (event.level <= weakest->level) return 1;
  std::move(weakest + 1, used, weakest);
  slots.back() = event;
  return 1;
}

}  // namespace stillcut
