#include "core/pipeline/signal_tap.h"

#include <algorithm>
#include <cmath>

#include "core/model/block_copy.h"

namespace stillcut::pipeline {
namespace {

constexpr double kHeld = 0.5;  // s

}  // namespace

void SignalTap::prepare(const CutSetup& setup) {
  ring_.reset();
  if (setup.blockFrames <= 0 || !(setup.rate.value > 0.0)) return;
  const double blocks = std::ceil(kHeld * setup.rate.value / setup.blockFrames);
  const auto channels = static_cast<int>(setup.channels.size());
  ring_ = std::make_unique<rt::SpscRing<SampleBlock>>(
      static_cast<std::size_t>(std::max(blocks, 8.0)),
      [&](SampleBlock& block) { block.allocate(channels, setup.blockFrames); });
}

void SignalTap::feed(const SampleBlock& block) noexcept {
  SampleBlock* slot = ring_ ? ring_->reserve() : nullptr;
  if (slot == nullptr || block.channels > slot->channels || block.frames > slot->capacityFrames) return;
  copyBlock(block, *slot);
  ring_->commit();
}

}  // namespace stillcut::pipeline
