// SpscRing: a ring of slots made once, between one producer and one consumer. Slots are filled and read in place, so
// that a SampleBlock is never copied on its way.
// Thread: reserve() and commit() on the producer, front() and pop() on the consumer; all real-time, lock-free.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <functional>
#include <vector>

namespace stillcut::rt {

template <class T>
class SpscRing {
 public:
  // At least `capacity` slots (rounded up to a power of two); `prepare` is called once on each.
  explicit SpscRing(std::size_t capacity, const std::function<void(T&)>& prepare = {})
      : slots_(std::bit_ceil(capacity < 1 ? std::size_t{1} : capacity)) {
    if (prepare) {
      for (T& slot : slots_) prepare(slot);
    }
  }

  // The next free slot, to be filled and committed; nullptr when the ring is full.
  T* reserve() noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_.load(std::memory_order_acquire) == slots_.size()) return nullptr;
    return &slots_[tail & (slots_.size() - 1)];
  }
  void commit() noexcept { tail_.store(tail_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }
  // Copies one value in. False: full.
  bool push(const T& value) noexcept {
    T* slot = reserve();
    if (slot == nullptr) return false;
    *slot = value;
    commit();
    return true;
  }

  // The oldest filled slot, the consumer's until pop(); nullptr when the ring is empty.
  T* front() noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_.load(std::memory_order_acquire)) return nullptr;
    return &slots_[head & (slots_.size() - 1)];
  }
  void pop() noexcept { head_.store(head_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  std::size_t capacity() const noexcept { return slots_.size(); }
  // Exact on either thread for what that thread may rely on: the producer sees at most, the consumer at least this
  // many.
  std::size_t size() const noexcept {
    const std::size_t head = head_.load(std::memory_order_acquire);
    return tail_.load(std::memory_order_acquire) - head;
  }

 private:
  std::vector<T> slots_;
  alignas(64) std::atomic<std::size_t> head_{0};  // consumer's
  alignas(64) std::atomic<std::size_t> tail_{0};  // producer's
};

}  // namespace stillcut::rt
