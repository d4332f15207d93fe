// Engine: the threads around the one loop. Driver thread: source into ring. Worker thread: ring through StepLoop.
// Link thread: LinkRunner every few milliseconds. Rings and mailboxes between them, nothing else.
// Thread: start(), stop() and the destructor on the owner's thread; the getters on any.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "core/base/time.h"
#include "core/daq/daq_source.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/step_loop.h"
#include "core/pipeline/step_source.h"
#include "core/rt/deadline_stats.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/spsc_ring.h"
#include "core/rt/wakeup.h"

namespace stillcut::pipeline {

struct EngineOptions {
  int ringBlocks = 64;  // how far the worker may fall behind before blocks are dropped
  Seconds linkPeriod{0.005};
  rt::ThreadRequest worker;  // scheduling asked for; the driver has one priority more
};

struct EngineParts {
  StepSource& source;
  daq::SourceFormat format;
  StepLoop& loop;
  LinkRunner* link;  // nullptr: no machine
  const Clock& clock;
};

class Engine {
 public:
  Engine(const EngineParts& parts, const EngineOptions& options);
  ~Engine() { stop(); }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  void start();
  // Stops source, worker and link, in this order; the link releases the machine. Safe to call twice.
  void stop();

  // True once the source has ended and every block of it has been processed.
  bool finished() const { return finished_.load(std::memory_order_acquire); }
  std::uint64_t leasesExpired() const { return parts_.link != nullptr ? parts_.link->leasesExpired() : 0; }
  std::uint64_t droppedBlocks() const { return dropped_.load(std::memory_order_relaxed); }
  // From the last sample of a block to the hand-over of its decision.
  const rt::DeadlineStats& latency() const { return latency_; }
  // Owner's thread, between start() and stop(): what the system granted the worker.
  rt::Scheduling workerScheduling() const {
    return workerThread_ ? workerThread_->granted() : rt::Scheduling::Ordinary;
  }

 private:
  void driver(const std::stop_token& stop);
  void worker(const std::stop_token& stop);
  void link(const std::stop_token& stop);
  void takeLost(SampleBlock& block);

  EngineParts parts_;
  EngineOptions options_;
  rt::SpscRing<StepInput> ring_;
  StepInput spare_;               // read into while the ring is full, then thrown away
  rt::Wakeup samples_;            // driver to worker
  rt::Wakeup ends_;               // wakes the link thread early on stop
  std::uint64_t lostFrames_ = 0;  // driver only: since the last block that went through
  bool lost_ = false;
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<bool> sourceEnded_{false};
  std::atomic<bool> finished_{false};
  rt::DeadlineStats latency_;
  std::unique_ptr<rt::RealtimeThread> linkThread_, workerThread_, driverThread_;
};

}  // namespace stillcut::pipeline
