// Hands a block on into storage that is there already. Thread: any, real-time.
#pragma once

#include <algorithm>

#include "core/model/sample_block.h"

namespace stillcut {

// Copies only what is used. `to` has as many channels as `from` at least, and room for its frames.
inline void copyBlock(const SampleBlock& from, SampleBlock& to) noexcept {
  to.source = from.source;
  to.sequence = from.sequence;
  to.firstSample = from.firstSample;
  to.rate = from.rate;
  to.frames = from.frames;
  to.flags = from.flags;
  to.lostFrames = from.lostFrames;
  for (int c = 0; c < from.channels; ++c) std::ranges::copy(from.channel(c), to.channel(c).begin());
}

}  // namespace stillcut
