// House rule 5, on the whole path: conditioner, every detector there is, each strategy there is, gate, mailbox, picture
// and recorder's tap take no memory, no lock and throw nothing, from the first block through entry, chatter and the
// change of speed. The simulated plant and machine on either side are held to the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "core/cnc/simulated_machine.h"
#include "core/control/registry.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/detect/registry.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/step_loop.h"
#include "core/session/recorder.h"
#include "tests/support/demo_cut.h"
#include "tests/support/path_counter.h"
#include "tests/support/scripted_parts.h"
#include "tests/support/temp_folder.h"

namespace stillcut::pipeline {
namespace {

using test::PathCounter;
using test::PathCounts;

class RecorderTap final : public StepTap {
 public:
  explicit RecorderTap(record::Recorder& recorder) : recorder_(recorder) {}
  bool push(const StepInput& input, const StepOutput& output) noexcept override {
    return recorder_.push(input, output);
  }

 private:
  record::Recorder& recorder_;
};

struct Tally {
  PathCounts source, step, link;
  int blocks = 0, entries = 0, alarms = 0, sets = 0;
  double lowestSpeed = 1.0, highestSpeed = 1.0;
  std::uint64_t columns = 0, dropped = 0;
};

void add(PathCounts& sum, const PathCounter& counter) {
  const PathCounts c = counter.counts();
  sum.allocations += c.allocations;
  sum.releases += c.releases;
  sum.locks += c.locks;
}

void addOpen(ChainParts& parts, config::ParamTable table) {
  for (const config::ParamDecl* decl : table) {
    if (!decl->lockedWhileRunning) parts.tunable.push_back(decl);
  }
}

ChainParts allDetectors(std::unique_ptr<control::Strategy> strategy) {
  ChainParts parts;
  for (const auto& entry : control::strategyTable()) {
    if (entry.id == strategy->describe().id) addOpen(parts, entry.params);
  }
  for (const auto& row : detect::detectorTable()) {
    if (row.id == detect::kDefaultDetector) parts.inCharge = static_cast<int>(parts.detectors.size());
    parts.detectors.push_back(row.make());
    addOpen(parts, row.params());
  }
  parts.strategy = std::move(strategy);
  return parts;
}

Tally runCut(std::unique_ptr<control::Strategy> strategy) {
  const milling::Scenario cut = test::demoCut();
  auto port = std::make_shared<milling::PlantPort>();
  daq::SimulatedSource source(cut, 0, port);
  EXPECT_TRUE(source.open().ok());
  cnc::SimulatedMachine machine(cut, port);
  const CutSetup setup = cut.cutSetup();

  const record::TempFolder folder;
  auto recorder = record::Recorder::create(folder / "cut.h5", {setup, "", "test", true});
  EXPECT_TRUE(recorder.ok());
  RecorderTap tap(**recorder);
  ChainParts parts = allDetectors(std::move(strategy));
  const std::vector<const config::ParamDecl*> tunable = parts.tunable;
  Chain chain(std::move(parts));
  auto limits = safety::gateLimits({}, setup, "test");
  EXPECT_TRUE(limits.ok());
  limits->autoAllowed = true;
  chain.prepare(setup, {}, *limits);
  SnapshotPublisher publisher;
  publisher.prepare(setup, true, true);

  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  rt::SpscRing<OperatorInput> inputs(8);
  inputs.push({OperatorAction::SetAuthority, Authority::Auto});
  LiveStateSource feed(states, inputs);
  const SteadyClock clock;
  StepLoop loop({chain, feed, commands, &publisher, &tap, clock});
  LinkRunner link(machine, commands, states);
  StepInput input;
  input.block.allocate(static_cast<int>(setup.channels.size()), setup.blockFrames);

  Tally tally;
  for (;;) {
    const PathCounter counted;
    const bool more = source.read(input.block);
    add(tally.source, counted);
    if (!more) break;
    // Every parameter that may be set on the running cut is, to what it is already.
    if (tally.blocks > 0 && static_cast<std::size_t>(tally.blocks) <= tunable.size()) {
      const config::ParamDecl& decl = *tunable[static_cast<std::size_t>(tally.blocks) - 1];
      inputs.push({OperatorAction::SetParameter, Authority::Off, 0, config::parameterId(decl.key), decl.fallback});
    }
    const PathCounter countedStep;
    const Chain::Step& done = loop.step(input);
    add(tally.step, countedStep);
    const PathCounter countedLink;
    link.tick(input.block.end());
    add(tally.link, countedLink);

    const Verdict& verdict = done.output.verdicts[static_cast<std::size_t>(done.output.inCharge)];
    ++tally.blocks;
    tally.entries += verdict.phase == CutPhase::Entry ? 1 : 0;
    tally.alarms += verdict.alarming() ? 1 : 0;
    if (done.output.hasCommand && done.output.command.kind == CommandKind::Set) {
      ++tally.sets;
      tally.lowestSpeed = std::min(tally.lowestSpeed, done.output.command.speed.value);
      tally.highestSpeed = std::max(tally.highestSpeed, done.output.command.speed.value);
    }
    (*recorder)->drain();
  }
  tally.columns = publisher.read()->columnCount;
  tally.dropped = (*recorder)->status().dropped;
  return tally;
}

class RtPath : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!PathCounter::works()) GTEST_SKIP() << "a sanitizer owns malloc here";
  }
};

TEST_P(RtPath, TakesNoMemoryAndNoLockAndThrowsNothing) {
  auto strategy = control::makeStrategy(GetParam());
  ASSERT_TRUE(strategy.ok());
  const Tally tally = runCut(std::move(strategy).value());
  EXPECT_EQ(tally.step.allocations, 0U);
  EXPECT_EQ(tally.step.releases, 0U);
  EXPECT_EQ(tally.step.locks, 0U);
  EXPECT_TRUE(tally.source.none());
  EXPECT_TRUE(tally.link.none());
  // It was the whole path that was counted, and all that happens in a cut.
  EXPECT_EQ(tally.blocks, 500);
  EXPECT_GT(tally.entries, 0);
  EXPECT_GT(tally.alarms + tally.sets, 0);  // a fuzzy law may act before there is an alarm
  EXPECT_GT(tally.columns, 100U);
  EXPECT_EQ(tally.dropped, 0U);
  if (GetParam() == control::kDefaultStrategy) {
    EXPECT_GT(tally.sets, 0);
    EXPECT_LT(tally.lowestSpeed, 0.9);
  }
}

std::vector<std::string> strategies() {
  std::vector<std::string> ids;
  for (const auto& entry : control::strategyTable()) ids.emplace_back(entry.id);
  return ids;
}

std::string caseName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryStrategy, RtPath, testing::ValuesIn(strategies()), caseName);

TEST(RtPathCounter, SeesOneAllocationAndOneThrowAtBlockHundred) {
  if (!PathCounter::works()) GTEST_SKIP() << "a sanitizer owns malloc here";
  const auto culprit = [](bool throws) {
    return std::make_unique<test::ScriptedStrategy>([throws, block = 0](const control::StrategyInput&) mutable {
      if (++block == 100) {
        if (throws) throw 1;
        const auto memory = std::make_unique<double>(1.0);
        asm volatile("" : : "g"(memory.get()) : "memory");  // the optimiser must not remove it
      }
      return OverrideRequest{};
    });
  };
  const Tally memory = runCut(culprit(false));
  EXPECT_EQ(memory.step.allocations, 1U);
  EXPECT_EQ(memory.step.releases, 1U);
  const Tally thrown = runCut(culprit(true));
  EXPECT_GE(thrown.step.allocations, 1U);
}

}  // namespace
}  // namespace stillcut::pipeline
