// TripleBuffer: the newest of a stream of large values, from one writer to one reader, without copies, locks or waits.
// Thread: back() and publish() on the writer, read() on the reader; real-time.
#pragma once

#include <array>
#include <atomic>
#include <memory>

namespace stillcut::rt {

template <class T>
class TripleBuffer {
 public:
  TripleBuffer() : slots_(std::make_unique<std::array<T, 3>>()) {}

  // The value being written; what it holds is some older value.
  T& back() noexcept { return (*slots_)[back_]; }
  void publish() noexcept { back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex; }

  // The newest published value, or nullptr before the first. The reader's until its next read().
  const T* read() noexcept {
    fresh_ = (middle_.load(std::memory_order_relaxed) & kFresh) != 0;
    if (fresh_) {
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
      any_ = true;
    }
    return any_ ? &(*slots_)[front_] : nullptr;
  }
  // Reader: whether the last read() gave something newer than the one before.
  bool fresh() const noexcept { return fresh_; }

 private:
  static constexpr unsigned kIndex = 3;
  static constexpr unsigned kFresh = 4;

  std::unique_ptr<std::array<T, 3>> slots_;
  unsigned back_ = 0;  // writer's
  alignas(64) std::atomic<unsigned> middle_{1};
  alignas(64) unsigned front_ = 2;  // reader's
  bool any_ = false;
  bool fresh_ = false;
};

}  // namespace stillcut::rt
