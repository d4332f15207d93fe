#include "core/daq/block_stamper.h"

#include <algorithm>
#include <cmath>

namespace stillcut::daq {

void BlockStamper::prepare(Hertz rate, int blockFrames, bool countsLosses) noexcept {
  rate_ = rate;
  blockFrames_ = blockFrames;
  clock_.prepare(rate, blockFrames, countsLosses);
  anew_ = started_ = false;
  sequence_ = 0;
}

void BlockStamper::begin(SampleBlock& block) const noexcept {
  block.frames = 0;
  block.flags = 0;
  block.lostFrames = 0;
  block.rate = rate_;
}

void BlockStamper::finish(SampleBlock& block, Instant seen) noexcept {
  if (anew_) {
    clock_.reset();
  } else {
    clock_.skip(block.lostFrames);
  }
  block.firstSample = clock_.stamp(block.frames, seen);
  if (!started_) {
    block.lostFrames = 0;  // nothing was there before the first
  } else if (anew_) {
    const double missing = secondsBetween(ended_, block.firstSample).value * rate_.value;
    block.lostFrames = static_cast<std::uint64_t>(std::llround(std::max(0.0, missing)));
  } else {
    block.lostFrames += clock_.lost();
  }
  if (block.lostFrames > 0 || (anew_ && started_)) block.flags |= kBlockGap;
  sequence_ += block.lostFrames / static_cast<std::uint64_t>(blockFrames_);
  block.sequence = sequence_++;
  started_ = true;
  anew_ = false;
  ended_ = block.end();
}

}  // namespace stillcut::daq
