// More bits of SampleBlock::flags: what a source knows of its device and the samples do not show.
// Plain values; thread: any.
#pragma once

#include "core/model/sample_block.h"

namespace stillcut {

// A device's first blocks: whether its rate is the told one has not shown against the clock yet.
inline constexpr auto kBlockUnchecked = static_cast<BlockFlag>(1U << 3);
// A device that was joined to the first delivers another rate than told, or repeats its values.
inline constexpr auto kBlockOtherRate = static_cast<BlockFlag>(1U << 4);

// Which channel is meant by kBlockOtherRate, in five bits of its own.
inline constexpr unsigned kOtherRateShift = 8;
inline constexpr std::uint32_t otherRateOf(int channel) {
  return kBlockOtherRate | static_cast<std::uint32_t>(channel) << kOtherRateShift;
}
inline constexpr int otherRateChannel(const SampleBlock& block) {
  return static_cast<int>(block.flags >> kOtherRateShift & 31U);
}

}  // namespace stillcut
