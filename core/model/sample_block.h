// SampleBlock: what a device hands to the worker. Raw device units; the conditioner makes SI of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut {

// Bits of SampleBlock::flags.
enum BlockFlag : std::uint32_t {
  kBlockGap = 1u << 0,      // samples are missing between the previous block and this one
  kBlockClipped = 1u << 1,  // the driver saw the input at its limit
  kBlockEnd = 1u << 2,      // no block follows (end of file, device stopped)
};

// Shape: samples[channel * capacityFrames + frame], float, device units. frames <= capacityFrames.
// Storage is that of a slot of the ring; it is sized once, before streaming.
struct SampleBlock {
  std::uint32_t source = 0;
  std::uint64_t sequence = 0;  // counts blocks of this source, lost ones included
  Instant firstSample{};       // stream time of frame 0, stamped by the source
  Hertz rate{};                // frames per second
  int channels = 0;
  int frames = 0;
  int capacityFrames = 0;
  std::uint32_t flags = 0;
  std::uint64_t lostFrames = 0;  // frames missing before this block, when kBlockGap is set (0: unknown number)
  std::vector<float> samples;

  void allocate(int channelCount, int frameCapacity) {
    channels = channelCount;
    capacityFrames = frameCapacity;
    samples.assign(static_cast<std::size_t>(channelCount) * static_cast<std::size_t>(frameCapacity), 0.0F);
  }
  std::span<float> channel(int c) {
    return {samples.data() + static_cast<std::ptrdiff_t>(c) * capacityFrames, static_cast<std::size_t>(frames)};
  }
  std::span<const float> channel(int c) const {
    return {samples.data() + static_cast<std::ptrdiff_t>(c) * capacityFrames, static_cast<std::size_t>(frames)};
  }
  bool has(BlockFlag f) const { return (flags & f) != 0; }
  // Stream time just after the last frame: the moment to which everything decided from this block refers.
  Instant end() const { return firstSample + toDuration(Seconds(frames / rate.value)); }
};

}  // namespace stillcut
