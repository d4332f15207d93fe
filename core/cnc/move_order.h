// Which of two overrides moves first, where a machine takes them one by one: a feed that falls goes before the speed,
// one that rises after it. On the way there is never more feed per tooth than before or after.
// Thread: any. Real-time safe.
#pragma once

namespace stillcut::cnc {

template <class Number>
constexpr bool feedFirst(Number wantedFeed, Number presentFeed) noexcept {
  return wantedFeed < presentFeed;
}

}  // namespace stillcut::cnc
