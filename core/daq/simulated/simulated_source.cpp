#include "core/daq/simulated/simulated_source.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace stillcut::daq {

SimulatedSource::SimulatedSource(const milling::Scenario& scenario, std::uint64_t seed,
                                 std::shared_ptr<milling::PlantPort> port, SimulatedPace pace)
    : plant_(scenario, seed), port_(std::move(port)), pace_(pace) {}

Result<SourceFormat> SimulatedSource::open() {
  if (pace_.realTime && !(pace_.multiplier > 0.0)) {
    return Error{message("simulated source"), message("the pace must be above zero")};
  }
  if (port_ && !pace_.realTime) port_->publish(plant_);
  const CutSetup setup = plant_.scenario().cutSetup();
  SourceFormat format;
  format.rate = setup.rate;
  format.blockFrames = setup.blockFrames;
  format.channels = setup.channels;
  return format;
}

bool SimulatedSource::read(SampleBlock& block) noexcept {
  if (stopped_.load(std::memory_order_relaxed)) return false;
  if (pace_.realTime && !started_) begin();
  if (port_) port_->serve(plant_);
  if (!plant_.fill(block)) return false;
  if (pace_.realTime) waitFor(block);
  if (port_) port_->publish(plant_);
  return !stopped_.load(std::memory_order_relaxed);
}

// The cut begins when somebody asks for it, however long ago it was opened: nothing has to be caught up on.
void SimulatedSource::begin() noexcept {
  started_ = true;
  start_ = SteadyClock().now();
  plant_.setStart(start_);
  if (port_) port_->publish(plant_);
}

void SimulatedSource::waitFor(const SampleBlock& block) noexcept {
  const double made = secondsBetween(start_, block.end()).value / pace_.multiplier;
  const Instant due = start_ + toDuration(Seconds(made));
  // In short naps, so that stop() is noticed.
  while (!stopped_.load(std::memory_order_relaxed)) {
    const Instant now = SteadyClock().now();
    if (now >= due) return;
    std::this_thread::sleep_for(std::min<Duration>(due - now, std::chrono::milliseconds(20)));
  }
}

}  // namespace stillcut::daq
