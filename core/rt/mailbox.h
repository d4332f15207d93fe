// Mailbox: one slot for the newest of a stream of small plain values, from one writer to one reader. Latest wins,
// nothing queues up. T need not be default constructible: nobody but the gate can make an OverrideCommand.
// Thread: post() on the writer, take() and latest() on the reader; real-time, wait-free.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>

#include "core/rt/triple_buffer.h"

namespace stillcut::rt {

template <class T>
class Mailbox {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  void post(const T& value) noexcept {
    ::new (static_cast<void*>(buffer_.back().bytes.data())) T(value);
    buffer_.publish();
  }
  // What came since the last take(), if anything; latest() in between does not swallow it.
  std::optional<T> take() noexcept {
    const Slot* slot = newest();
    if (!pending_) return std::nullopt;
    pending_ = false;
    return value(*slot);
  }
  // The newest there ever was.
  std::optional<T> latest() noexcept {
    const Slot* slot = newest();
    if (slot == nullptr) return std::nullopt;
    return value(*slot);
  }

 private:
  struct Slot {
    alignas(T) std::array<std::byte, sizeof(T)> bytes;
  };
  static T value(const Slot& slot) noexcept { return *std::launder(reinterpret_cast<const T*>(slot.bytes.data())); }

  const Slot* newest() noexcept {
    const Slot* slot = buffer_.read();
    pending_ = pending_ || buffer_.fresh();
    return slot;
  }

  TripleBuffer<Slot> buffer_;
  bool pending_ = false;  // reader's: not yet taken
};

}  // namespace stillcut::rt
