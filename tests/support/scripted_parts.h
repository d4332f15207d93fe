// Parts that do what a test tells them: a source of numbered blocks, a link that counts, a detector that says what it
// is told, a tap that keeps what passes. No physics here.
#pragma once

#include <atomic>
#include <functional>
#include <latch>
#include <memory>
#include <semaphore>
#include <thread>
#include <vector>

#include "core/cnc/cnc_link.h"
#include "core/control/strategy.h"
#include "core/detect/detector.h"
#include "core/pipeline/chain.h"
#include "core/pipeline/step_loop.h"
#include "core/pipeline/step_source.h"

namespace stillcut::test {

inline constexpr int kFrames = 128;
inline constexpr double kRate = 25600.0;

inline daq::SourceFormat format() {
  daq::SourceFormat f;
  f.rate = Hertz(kRate);
  f.blockFrames = kFrames;
  f.channels.resize(1);
  return f;
}

inline CutSetup setup() {
  CutSetup s;
  s.teeth = 4;
  s.nominalSpeed = Rpm(6000.0);
  s.rate = Hertz(kRate);
  s.blockFrames = kFrames;
  s.channels = format().channels;
  return s;
}

// Numbered blocks of a quiet sine, `count` of them, as fast as they are asked for. May stop for the test before one.
class ScriptedSource final : public pipeline::StepSource {
 public:
  explicit ScriptedSource(int count) : count_(count) {}

  void pauseBefore(int number, std::latch& reached, std::counting_semaphore<>& goOn) {
    pause_ = number;
    reached_ = &reached;
    goOn_ = &goOn;
  }
  bool read(StepInput& step) noexcept override {
    if (next_ == pause_) {
      reached_->count_down();
      goOn_->acquire();
    }
    if (stopped_.load() || next_ >= count_) return false;
    SampleBlock& b = step.block;
    b.sequence = static_cast<std::uint64_t>(next_);
    b.frames = kFrames;
    b.rate = Hertz(kRate);
    b.flags = 0;
    b.lostFrames = 0;
    b.firstSample = Instant(toDuration(Seconds(next_ * kFrames / kRate)));
    for (int i = 0; i < kFrames; ++i) {
      const double t = (static_cast<double>(next_) * kFrames + i) / kRate;
      b.channel(0)[static_cast<std::size_t>(i)] = static_cast<float>(std::sin(kTwoPi * 400.0 * t));
    }
    ++next_;
    return true;
  }
  void stop() noexcept override {
    stopped_.store(true);
    if (goOn_ != nullptr) goOn_->release();
  }

 private:
  int count_;
  int next_ = 0;
  int pause_ = -1;
  std::latch* reached_ = nullptr;
  std::counting_semaphore<>* goOn_ = nullptr;
  std::atomic<bool> stopped_{false};
};

// A machine that does nothing but count what it is told.
class CountingLink final : public cnc::CncLink {
 public:
  cnc::LinkInfo describe() const override { return {.id = "counting", .label = "Counting", .simulated = true}; }
  Status open() override { return Done{}; }
  MachineState read(Instant now) noexcept override {
    ++reads_;
    state.time = now;
    return state;
  }
  void apply(const OverrideCommand& command, Instant /*now*/) noexcept override {
    ++applied_;
    last = command.record();
  }
  void release(Instant /*now*/) noexcept override { ++released_; }

  int reads() const { return reads_; }
  int applied() const { return applied_; }
  int released() const { return released_; }

  MachineState state;
  CommandRecord last;

 private:
  std::atomic<int> reads_{0}, applied_{0}, released_{0};
};

// Gives the verdict a function makes of the block.
class ScriptedDetector final : public detect::Detector {
 public:
  using Script = std::function<Verdict(const detect::ConditionedBlock&)>;
  explicit ScriptedDetector(Script script, std::span<const std::string_view> indicators = {})
      : script_(std::move(script)), indicators_(indicators) {}
  detect::DetectorInfo describe() const override { return {"scripted", "Scripted", "test", indicators_}; }
  void prepare(const CutSetup& /*setup*/, const config::ParamSet& /*params*/) override {}
  Verdict process(const detect::ConditionedBlock& block) override {
    Verdict v = script_(block);
    v.time = block.end();
    v.blockSequence = block.sequence;
    return v;
  }
  void retune(const config::ParamSet& /*params*/) override { onRetune(); }
  void reset() override { onReset(); }
  std::function<void()> onRetune = [] {}, onReset = [] {};

 private:
  Script script_;
  std::span<const std::string_view> indicators_;
};

class ScriptedStrategy final : public control::Strategy {
 public:
  using Script = std::function<OverrideRequest(const control::StrategyInput&)>;
  explicit ScriptedStrategy(Script script) : script_(std::move(script)) {}
  control::StrategyInfo describe() const override { return {"scripted", "Scripted", "test"}; }
  void prepare(const CutSetup& /*setup*/, const config::ParamSet& /*params*/) override {}
  OverrideRequest decide(const control::StrategyInput& input) override { return script_(input); }
  void retune(const config::ParamSet& /*params*/) override { onRetune(); }
  void reset() override {}
  void relinquish() override { onRelinquish(); }
  std::function<void()> onRetune = [] {}, onRelinquish = [] {};

 private:
  Script script_;
};

inline Verdict stableVerdict() {
  Verdict v;
  v.state = CutState::Stable;
  v.phase = CutPhase::Steady;
  v.valid = true;
  return v;
}

// A chain with one scripted detector and one scripted strategy; by default everything is stable and nothing is wanted.
inline pipeline::ChainParts scriptedChain(
    ScriptedDetector::Script detector = [](const auto&) { return stableVerdict(); },
    ScriptedStrategy::Script strategy = [](const auto&) { return OverrideRequest{}; }) {
  pipeline::ChainParts parts;
  parts.detectors.push_back(std::make_unique<ScriptedDetector>(std::move(detector)));
  parts.strategy = std::make_unique<ScriptedStrategy>(std::move(strategy));
  return parts;
}

// Keeps flags and losses of every step, and tells the test of each.
class KeepingTap final : public pipeline::StepTap {
 public:
  struct Seen {
    std::uint64_t sequence;
    bool gap;
    std::uint64_t lostFrames;
  };
  bool push(const StepInput& input, const StepOutput& /*output*/) noexcept override {
    seen_.push_back({input.block.sequence, input.block.has(kBlockGap), input.block.lostFrames});
    passed_.release();
    return true;
  }
  // Test thread: until `n` more steps have passed.
  void await(int n) {
    for (int i = 0; i < n; ++i) passed_.acquire();
  }
  // Only when no worker runs.
  const std::vector<Seen>& seen() const { return seen_; }

 private:
  std::vector<Seen> seen_;
  std::counting_semaphore<> passed_{0};
};

}  // namespace stillcut::test
