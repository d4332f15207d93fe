#include "core/pipeline/engine.h"

#include <utility>

namespace stillcut::pipeline {
namespace {

constexpr Seconds kLookForStop{0.05};  // a worker without samples looks this often whether it should end

}  // namespace

Engine::Engine(const EngineParts& parts, const EngineOptions& options)
    : parts_(parts), options_(options), ring_(static_cast<std::size_t>(options.ringBlocks), [&](StepInput& slot) {
        slot.block.allocate(static_cast<int>(parts.format.channels.size()), parts.format.blockFrames);
      }) {
  spare_.block.allocate(static_cast<int>(parts.format.channels.size()), parts.format.blockFrames);
}

void Engine::start() {
  if (parts_.link != nullptr) {
    linkThread_ = std::make_unique<rt::RealtimeThread>(rt::ThreadRequest{.name = "link"},
                                                       [this](const std::stop_token& stop) { link(stop); });
  }
  rt::ThreadRequest request = options_.worker;
  request.name = "worker";
  workerThread_ = std::make_unique<rt::RealtimeThread>(request, [this](const std::stop_token& stop) { worker(stop); });
  request.name = "driver";  // samples first: a late decision can be waited for, a lost sample cannot
  ++request.priority;
  driverThread_ = std::make_unique<rt::RealtimeThread>(request, [this](const std::stop_token& stop) { driver(stop); });
}

void Engine::stop() {
  if (driverThread_) {
    driverThread_->requestStop();
    parts_.source.stop();
    driverThread_.reset();
  }
  if (workerThread_) {
    workerThread_->requestStop();
    samples_.notify();
    workerThread_.reset();
  }
  if (linkThread_) {
    linkThread_->requestStop();
    ends_.notify();
    linkThread_.reset();
  }
}

void Engine::driver(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    StepInput* slot = ring_.reserve();
    StepInput& target = slot != nullptr ? *slot : spare_;
    if (!parts_.source.read(target)) break;
    if (slot == nullptr) {
      slot = ring_.reserve();  // the worker may have made room while the source was waited for
      if (slot != nullptr) std::swap(*slot, spare_);
    }
    if (slot == nullptr) {
      lost_ = true;
      lostFrames_ += static_cast<std::uint64_t>(target.block.frames) + target.block.lostFrames;
      dropped_.fetch_add(1, std::memory_order_relaxed);
      continue;
    }
    takeLost(slot->block);
    ring_.commit();
    samples_.notify();
  }
  sourceEnded_.store(true, std::memory_order_release);
  samples_.notify();
}

// What was thrown away shows as a gap on the next block that goes through.
void Engine::takeLost(SampleBlock& block) {
  if (!lost_) return;
  block.flags |= kBlockGap;
  block.lostFrames += lostFrames_;
  lost_ = false;
  lostFrames_ = 0;
}

void Engine::worker(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    StepInput* input = ring_.front();
    if (input == nullptr) {
      if (sourceEnded_.load(std::memory_order_acquire) && ring_.front() == nullptr) break;
      samples_.waitFor(kLookForStop);
      continue;
    }
    parts_.loop.countDropped(dropped_.load(std::memory_order_relaxed));
    if (parts_.link != nullptr) parts_.loop.countLink(parts_.link->tally(), parts_.clock.now());
    parts_.loop.step(*input);
    latency_.record(secondsBetween(input->block.end(), parts_.clock.now()));
    ring_.pop();
  }
  finished_.store(true, std::memory_order_release);
}

void Engine::link(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    parts_.link->tick(parts_.clock.now());
    ends_.waitFor(options_.linkPeriod);
  }
  parts_.link->finish();
}

}  // namespace stillcut::pipeline
