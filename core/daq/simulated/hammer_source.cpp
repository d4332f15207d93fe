#include "core/daq/simulated/hammer_source.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr int kBlockFrames = 512;
constexpr Seconds kQuietFirst{0.5};
constexpr int kTurn = 8;  // blows after which the bad ones come again

}  // namespace

HammerSource::HammerSource(const HammerSourceOptions& options, milling::TapStructure structure)
    : options_(options), tap_(std::move(structure), options.seed), hand_(options.seed + 1) {}

Result<SourceFormat> HammerSource::open() {
  SourceFormat format;
  format.rate = tap_.structure().rate;
  format.blockFrames = kBlockFrames;
  format.channels = {{"hammer", SensorQuantity::Force, 1.0, ""},
                     {"tip x", SensorQuantity::Acceleration, 1.0, "x"},
                     {"tip y", SensorQuantity::Acceleration, 1.0, "y"}};
  nextBlow_ = static_cast<std::uint64_t>(kQuietFirst.value * format.rate.value);
  return format;
}

bool HammerSource::read(SampleBlock& block) noexcept {
  if (stopped_.load(std::memory_order_relaxed)) return false;
  if (options_.pace > 0.0 && frame_ == 0) start_ = SteadyClock().now();
  block.channels = 3;
  block.frames = kBlockFrames;
  block.rate = tap_.structure().rate;
  block.flags = 0;
  block.lostFrames = 0;
  block.sequence = sequence_++;
  block.firstSample = start_ + toDuration(Seconds(static_cast<double>(frame_) / block.rate.value));
  for (std::size_t k = 0; k < kBlockFrames; ++k, ++frame_) {
    if (frame_ == nextBlow_) strike();
    const milling::SimulatedTap::Sample s = tap_.step();
    block.channel(0)[k] = static_cast<float>(s.force);
    block.channel(1)[k] = static_cast<float>(s.acceleration[0]);
    block.channel(2)[k] = static_cast<float>(s.acceleration[1]);
  }
  if (options_.pace > 0.0) waitFor(block);
  return !stopped_.load(std::memory_order_relaxed);
}

void HammerSource::strike() noexcept {
  ++blows_;
  milling::TapBlow blow;
  blow.force = 220.0 * (1.0 + 0.15 * hand_.normal());
  blow.force = std::clamp(blow.force, 120.0, 350.0);
  blow.width = 0.25e-3 * (1.0 + 0.05 * hand_.normal());
  blow.lean = 0.02 * hand_.normal();
  if (options_.alongY) blow.along = {0.0, 1.0};
  const int turn = options_.faults ? blows_ % kTurn : 0;
  if (turn == 2) blow.bounce = 0.35;
  if (turn == 4) blow.force = 1.6 * tap_.structure().forceRange;
  if (turn == 6) blow.force = 12.0;
  tap_.strike(blow);
  nextBlow_ += static_cast<std::uint64_t>(options_.interval.value * tap_.structure().rate.value);
}

// In short naps, so that stop() is noticed.
void HammerSource::waitFor(const SampleBlock& block) const noexcept {
  const Instant due = start_ + toDuration(Seconds(secondsBetween(start_, block.end()).value / options_.pace));
  while (!stopped_.load(std::memory_order_relaxed)) {
    const Instant now = SteadyClock().now();
    if (now >= due) return;
    std::this_thread::sleep_for(std::min<Duration>(due - now, std::chrono::milliseconds(20)));
  }
}

}  // namespace stillcut::daq
