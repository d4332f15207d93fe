// The threads around the loop: what is lost shows as a gap, what ends is released, and starting and stopping a
// thousand times leaves nothing behind. Nothing here waits for time to pass: threads are led by latches.

#include "core/pipeline/engine.h"

#include <dirent.h>
#include <gtest/gtest.h>

#include "tests/support/scripted_parts.h"

namespace stillcut::pipeline {
namespace {

using test::CountingLink;
using test::KeepingTap;
using test::ScriptedSource;

// A feed that holds the worker until the test lets it go on, block by block.
class HoldingFeed final : public MachineStateSource {
 public:
  void complete(StepInput& step) noexcept override {
    permits_.acquire();
    step.machine = MachineState{};
  }
  void permit(int blocks) { permits_.release(blocks); }

 private:
  std::counting_semaphore<> permits_{0};
};

struct Bench {
  Bench(StepSource& source, MachineStateSource& feed, int ringBlocks)
      : chain(test::scriptedChain()),
        loop({chain, feed, commands, nullptr, &tap, clock}),
        linkRunner(link, commands, states),
        engine({source, test::format(), loop, &linkRunner, clock},
               {.ringBlocks = ringBlocks, .linkPeriod = Seconds(0.001), .worker = {}}) {
    chain.prepare(test::setup(), {}, {});
  }

  SteadyClock clock;
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  KeepingTap tap;
  CountingLink link;
  Chain chain;
  StepLoop loop;
  LinkRunner linkRunner;
  Engine engine;
};

TEST(Engine, FullRingDropsBlocksAndTheNextOneCarriesTheGap) {
  constexpr int kRing = 4;
  constexpr int kBeforePause = 20;
  HoldingFeed feed;
  ScriptedSource source(kBeforePause + 1);
  std::latch flooded{1};
  std::counting_semaphore<> goOn{0};
  source.pauseBefore(kBeforePause, flooded, goOn);

  Bench bench(source, feed, kRing);
  bench.engine.start();
  flooded.wait();  // the source has offered 20 blocks to a worker that stands still
  const std::uint64_t dropped = bench.engine.droppedBlocks();
  EXPECT_EQ(dropped, static_cast<std::uint64_t>(kBeforePause - kRing));
  feed.permit(kRing + 1);
  bench.tap.await(kRing);  // the worker has emptied the ring ...
  goOn.release();          // ... and then the last block comes
  bench.tap.await(1);
  bench.engine.stop();

  const auto& seen = bench.tap.seen();
  ASSERT_EQ(seen.size(), static_cast<std::size_t>(kRing + 1));
  for (int i = 0; i < kRing; ++i) EXPECT_FALSE(seen[static_cast<std::size_t>(i)].gap);
  EXPECT_TRUE(seen.back().gap);
  EXPECT_EQ(seen.back().lostFrames, dropped * test::kFrames);
  EXPECT_EQ(bench.loop.health().gaps, 1U);
}

// A run that only listens has no machine to ask: its path in chatter is counted with the feed that was set up.
TEST(StepLoop, ACutWithoutALinkCountsItsPathInChatterWithTheFeedThatWasSetUp) {
  constexpr int kBlocks = 50;
  SteadyClock clock;
  rt::Mailbox<OverrideCommand> commands;
  RecordedStateSource feed;
  Chain chain(test::scriptedChain([](const auto&) {
    Verdict v = test::stableVerdict();
    v.state = CutState::Chatter;
    return v;
  }));
  CutSetup setup = test::setup();
  setup.nominalFeed = fromMmPerMin(600.0);
  chain.prepare(setup, {}, {});
  StepLoop loop({chain, feed, commands, nullptr, nullptr, clock});
  ScriptedSource source(kBlocks);
  StepInput step;
  step.block.allocate(1, test::kFrames);
  while (source.read(step)) (void)loop.step(step);
  const Metres path(0.010 * kBlocks * test::kFrames / test::kRate);  // at 10 mm/s
  EXPECT_NEAR(loop.interventions().chatterLength().value, path.value, 1e-9);
  EXPECT_NEAR(loop.interventions().card(0).marked.value, path.value, 1e-9);
}

int threadsOfThisProcess() {
  int count = 0;
  DIR* dir = opendir("/proc/self/task");
  while (readdir(dir) != nullptr) ++count;
  closedir(dir);
  return count;
}

void startAndStop() {
  ScriptedSource source(3);
  RecordedStateSource feed;
  Bench bench(source, feed, 4);
  bench.engine.start();
  bench.engine.stop();
}

TEST(Engine, AThousandStartsAndStopsLeaveNothingBehind) {
  startAndStop();  // a sanitizer starts a thread of its own with our first one
  const int before = threadsOfThisProcess();
  for (int i = 0; i < 1000; ++i) startAndStop();
  EXPECT_EQ(threadsOfThisProcess(), before);
}

TEST(Engine, StopReturnsWhileTheSourceIsBlocked) {
  std::counting_semaphore<> goOn{0};
  std::latch waiting{1};
  ScriptedSource source(10);
  source.pauseBefore(2, waiting, goOn);  // the source's stop() ends the pause, as a device's would
  RecordedStateSource feed;
  Bench bench(source, feed, 8);
  bench.engine.start();
  waiting.wait();
  bench.engine.stop();
  EXPECT_LE(bench.tap.seen().size(), 2U);
}

}  // namespace
}  // namespace stillcut::pipeline
