// Which instruction sets this build and this machine have, and the kernels of one.
// Thread: pure functions. Call them in prepare(): they ask the processor.
#pragma once

#include <span>
#include <string_view>

#include "core/dsp/kernels/kernels.h"

namespace stillcut::dsp::kernels {

// Slowest first; the baseline is always there.
std::span<const InstructionSet> availableSets() noexcept;
std::string_view nameOf(InstructionSet set) noexcept;
// A set that is not available gives the baseline.
Kernels kernelsOf(InstructionSet set) noexcept;
Kernels bestKernels() noexcept;

}  // namespace stillcut::dsp::kernels
