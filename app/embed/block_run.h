// BlockRun: the detectors on samples that another program hands over, any number at a time: no file, no device, no
// machine, nothing that moves. What a recording of the same samples gives, block for block.
// Thread: one at a time. Allocates; not real-time.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/config/param_set.h"
#include "core/model/cut_setup.h"
#include "core/model/step_record.h"
#include "core/pipeline/chain.h"

namespace stillcut::app {

struct BlockRunOptions {
  CutSetup setup;  // rate, channels, teeth and nominal speed; the size of blocks is chosen here
  std::vector<std::string> detectors{"energy-ratio"};  // the first is in charge
  config::ParamSet params;
};

class BlockRun {
 public:
  using Took = std::function<void(const StepInput&, const StepOutput&)>;

  // One line on failure: an unknown detector, no channel, a rate that no vibration has.
  static Result<std::unique_ptr<BlockRun>> build(BlockRunOptions options);

  // How many frames a block has: 5 ms of them, or a little less.
  static int framesOf(Hertz rate);

  const CutSetup& setup() const { return setup_; }
  const pipeline::Chain& chain() const { return *chain_; }

  // Shape: samples[frame * channels + channel], device units; whole frames. `measured`: the spindle's speed meanwhile,
  // 0: not measured. `took` is called after each block of 5 ms; what does not fill one waits for the next call.
  void feed(std::span<const float> samples, Rpm measured, const Took& took);
  // What waits, as the last block.
  void finish(const Took& took);

 private:
  BlockRun() = default;
  void step(const Took& took);

  CutSetup setup_;
  std::unique_ptr<pipeline::Chain> chain_;
  StepInput input_;
  Rpm measured_{};
  std::uint64_t frames_ = 0;  // of all blocks before this one
};

}  // namespace stillcut::app
