// More bits of SampleBlock::flags: what a source knows of its device and the samples do not show.
// Plain values; thread: any.
#pragma once

#include "core/model/sample_block.h"

namespace stillcut {

// A device's first blocks: whether its rate is the nominal one has not shown against the clock yet.
inline constexpr auto kBlockRateUnverified = static_cast<BlockFlag>(1U << 3);
// A device that was joined to the first delivers another rate than set, or repeats its values.
inline constexpr auto kBlockRateMismatch = static_cast<BlockFlag>(1U << 4);

// Which channel is meant by kBlockRateMismatch, in five bits of its own.
inline constexpr unsigned kRateMismatchShift = 8;
inline constexpr std::uint32_t rateMismatchOf(int channel) {
  return kBlockRateMismatch | static_cast<std::uint32_t>(channel) << kRateMismatchShift;
}
inline constexpr int rateMismatchChannel(const SampleBlock& block) {
  return static_cast<int>(block.flags >> kRateMismatchShift & 31U);
}

}  // namespace stillcut
