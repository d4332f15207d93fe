// SignalTap: the samples themselves, handed to the screen for its time trace. A screen that is late loses blocks and
// sees it from their stamps; the worker never waits. Thread: prepare() on set-up; feed() on the worker, real-time;
// read() on one other thread.
#pragma once

#include <memory>

#include "core/model/cut_setup.h"
#include "core/model/sample_block.h"
#include "core/rt/spsc_ring.h"

namespace stillcut::pipeline {

class SignalTap {
 public:
  // Room for half a second of blocks, at least eight.
  void prepare(const CutSetup& setup);
  void feed(const SampleBlock& block) noexcept;

  // Everything that came since the last call, in order; a block is the sink's until it returns.
  template <class Sink>  // void(const SampleBlock&)
  void read(Sink&& sink) {
    if (!ring_) return;
    for (SampleBlock* block = ring_->front(); block != nullptr; block = ring_->front()) {
      sink(static_cast<const SampleBlock&>(*block));
      ring_->pop();
    }
  }

 private:
  std::unique_ptr<rt::SpscRing<SampleBlock>> ring_;
};

}  // namespace stillcut::pipeline
