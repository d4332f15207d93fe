// Contracts of the chain: validity, gaps, no allocation on the sample path, the table of detectors.
#include "core/detect/registry.h"
#include "tests/support/path_counter.h"
#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

TEST(Registry, UnknownIdNamesTheNearest) {
  EXPECT_TRUE(makeDetector("energy-ratio").ok());
  const auto made = makeDetector("energy-ration");
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().line().find("'energy-ratio'"), std::string::npos) << made.error().line();
}

// Feeds blocks one by one.
class Chain {
 public:
  explicit Chain(const Recording& recording, double rpm) : recording_(recording) {
    RunOptions options;
    options.teeth = 4;
    options.rpm = rpm;
    const CutSetup setup = setupFor(recording, options);
    conditioner_.prepare(setup, {});
    detector_ = std::move(makeDetector("energy-ratio").value());
    detector_->prepare(setup, {});
    block_.allocate(static_cast<int>(recording.channels.size()), options.blockFrames);
    block_.rate = setup.rate;
    block_.frames = options.blockFrames;
  }
  bool fill() {
    if (next_ + static_cast<std::size_t>(block_.frames) > recording_.frames()) return false;
    const auto from = recording_.channels[0].begin() + static_cast<std::ptrdiff_t>(next_);
    std::copy_n(from, block_.frames, block_.channel(0).begin());
    block_.firstSample = Instant{} + toDuration(Seconds(static_cast<double>(next_) / recording_.rate));
    next_ += static_cast<std::size_t>(block_.frames);
    ++block_.sequence;
    return true;
  }
  Verdict process() { return detector_->process(conditioner_.process(block_, machine)); }
  SampleBlock& block() { return block_; }
  MachineState machine;

 private:
  const Recording& recording_;
  Conditioner conditioner_;
  std::unique_ptr<Detector> detector_;
  SampleBlock block_;
  std::size_t next_ = 0;
};

TEST(Chain, TheSamplePathNeitherAllocatesNorLocks) {
  if (!stillcut::test::PathCounter::works()) GTEST_SKIP() << "allocations cannot be counted in this build";
  CutSignal s;
  s.growthStart = 1.5;
  s.seconds = 2.0;
  const Recording recording = makeCut(s);
  Chain chain(recording, 6060.0);
  const stillcut::test::PathCounter counter;
  bool alarmed = false;
  int blocks = 0;
  while (chain.fill()) {
    // Gaps and speed changes are on the sample path as well.
    chain.block().flags = ++blocks == 20 ? kBlockGap : 0U;
    chain.machine.valid = chain.machine.linkUp = true;
    chain.machine.actualSpeed = Rpm(blocks < 40 ? 6000.0 : 6003.0);
    alarmed = chain.process().alarming() || alarmed;
  }
  EXPECT_TRUE(counter.counts().none());
  EXPECT_TRUE(alarmed);
}

TEST(Chain, BadInputIsInvalidWithItsReasonAndEndsWithIt) {
  CutSignal s;
  s.seconds = 1.0;
  const Recording recording = makeCut(s);
  Chain chain(recording, 6000.0);
  int blocks = 0;
  while (chain.fill()) {
    ++blocks;
    if (blocks == 100) chain.block().channel(0)[3] = std::numeric_limits<float>::infinity();
    chain.block().flags = blocks == 200 ? kBlockGap : 0U;
    const Verdict v = chain.process();
    EXPECT_EQ(v.time, chain.block().end());
    EXPECT_EQ(v.blockSequence, chain.block().sequence);
    EXPECT_EQ(v.valid, blocks != 100 && blocks != 200) << blocks;
    if (blocks == 100) {
      EXPECT_EQ(v.reason.code, ReasonCode::InputNotFinite);
    }
    if (blocks == 200) {
      EXPECT_EQ(v.reason.code, ReasonCode::InputGap);
    }
    EXPECT_FALSE(v.alarming()) << blocks;
  }
}

}  // namespace
}  // namespace stillcut::detect::testing
