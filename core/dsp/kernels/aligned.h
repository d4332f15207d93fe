// Values that begin where the widest register's loads do not cross a cache line. Any thread.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "core/dsp/kernels/kernels.h"

namespace stillcut::dsp::kernels {

template <class T>
struct LaneAllocator {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{kLanes * sizeof(double)};
  LaneAllocator() = default;
  template <class U>
  LaneAllocator(const LaneAllocator<U>& /*other*/) noexcept {}  // NOLINT(google-explicit-constructor)
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), kAlignment)); }
  void deallocate(T* p, std::size_t /*n*/) noexcept { ::operator delete(p, kAlignment); }
  bool operator==(const LaneAllocator&) const = default;
};

using LaneValues = std::vector<double, LaneAllocator<double>>;

}  // namespace stillcut::dsp::kernels
