#include "core/daq/block_stamper.h"

#include <algorithm>
#include <cmath>

#include "core/model/device_flags.h"

namespace stillcut::daq {

void BlockStamper::prepare(Hertz rate, int blockFrames, bool countsLosses, std::uint64_t lossUnit) noexcept {
  rate_ = rate;
  blockFrames_ = blockFrames;
  clock_.prepare(rate, blockFrames, countsLosses, lossUnit);
  anew_ = doubtful_ = started_ = false;
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
    clock_.cut();
  } else if (doubtful_) {
    clock_.doubt();
  } else {
    clock_.skip(block.lostFrames);
  }
  block.firstSample = clock_.stamp(block.frames, seen);
  block.lostFrames = clock_.lost();
  if (anew_ && started_) {
    const double missing = secondsBetween(ended_, block.firstSample).value * rate_.value;
    block.lostFrames = static_cast<std::uint64_t>(std::llround(std::max(0.0, missing)));
  }
  if (block.lostFrames > 0 || clock_.jumped()) block.flags |= kBlockGap;
  if (!clock_.settled()) block.flags |= kBlockRateUnverified;
  sequence_ += block.lostFrames / static_cast<std::uint64_t>(blockFrames_);
  block.sequence = sequence_++;
  started_ = true;
  anew_ = doubtful_ = false;
  ended_ = block.end();
}

}  // namespace stillcut::daq
