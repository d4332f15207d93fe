#include "core/dsp/kernels/choose.h"

#include <algorithm>
#include <array>

#include "core/dsp/kernels/tables.h"

namespace stillcut::dsp::kernels {
namespace {

constexpr std::array<InstructionSet, 3> kSets{InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512};

std::size_t countAvailable() noexcept {
#if defined(STILLCUT_WIDE_KERNELS)
  if (__builtin_cpu_supports("avx2") == 0) return 1;
  const bool wide = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                    __builtin_cpu_supports("avx512vl") != 0;
  return wide ? 3 : 2;
#else
  return 1;
#endif
}

}  // namespace

std::span<const InstructionSet> availableSets() noexcept {
  return std::span(kSets).first(countAvailable());
}

std::string_view nameOf(InstructionSet set) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"baseline", "AVX2", "AVX-512"};
  return kNames[static_cast<std::size_t>(set)];
}

Kernels kernelsOf(InstructionSet set) noexcept {
  const auto sets = availableSets();
  Kernels kernels;
  kernels.set = std::find(sets.begin(), sets.end(), set) == sets.end() ? InstructionSet::Baseline : set;
#if defined(STILLCUT_WIDE_KERNELS)
  if (kernels.set == InstructionSet::Avx512) {
    avx512::fill(kernels);
    return kernels;
  }
  if (kernels.set == InstructionSet::Avx2) {
    avx2::fill(kernels);
    return kernels;
  }
#endif
  baseline::fill(kernels);
  return kernels;
}

Kernels bestKernels() noexcept {
  return kernelsOf(availableSets().back());
}

}  // namespace stillcut::dsp::kernels
