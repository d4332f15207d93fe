// The whole way round, on the demo's simulated machine: chatter is named, the override moves, the true chatter ends and
// the cut stays quiet; without authority nothing is ever commanded; when the worker stalls or the link goes, the
// programmed values come back; and what is missing in the samples is said, not guessed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "app/compose/scenario_rig.h"
#include "core/cnc/simulated_machine.h"
#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/step_loop.h"
#include "tests/support/demo_cut.h"

namespace stillcut::app {
namespace {

bool isSet(const StepOutput& output) {
  return output.hasCommand && output.command.kind == CommandKind::Set;
}
const Verdict& obeyed(const StepOutput& output) {
  return output.verdicts[static_cast<std::size_t>(output.inCharge)];
}
double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

ScenarioRig demoRig(const milling::Scenario& cut) {
  auto rig = buildScenarioRig(cut, {.methods = Methods{}, .params = {}});
  if (!rig) throw std::runtime_error(rig.error().line());
  return std::move(rig).value();
}

TEST(ClosedLoop, GrownChatterIsNamedAndEndedOnceAutoIsGranted) {
  constexpr double kSeconds = 9.0;
  const ScenarioRig demo = demoRig(test::demoCut(kSeconds));
  const milling::SimulatedCut& plant = demo.source->plant();
  double chatterBegan = -1.0, granted = -1.0, firstMove = -1.0, chatterEnded = -1.0;
  std::vector<double> named, lateSpeeds;
  int lateAlarms = 0;
  bool commandedBefore = false;
  demo.rig->runToEnd([&](const StepInput& input, const StepOutput& output) {
    const double t = sinceEpoch(input.block.end()).value;
    const bool chattering = plant.truth().chattering();
    if (chattering && chatterBegan < 0.0) chatterBegan = t;
    if (chattering) chatterEnded = t;
    const Verdict& verdict = obeyed(output);
    if (verdict.alarming() && chattering && granted < 0.0) named.push_back(verdict.frequency.value);
    // The operator watches fully grown chatter for half a second before granting anything.
    if (granted < 0.0) commandedBefore = commandedBefore || output.hasCommand;
    if (chatterBegan > 0.0 && t > chatterBegan + 0.5 && granted < 0.0) {
      granted = t;
      demo.rig->send({OperatorAction::SetAuthority, Authority::Auto});
    }
    if (isSet(output) && std::abs(output.command.speed.value - 1.0) > 0.005 && firstMove < 0.0) firstMove = t;
    if (t > kSeconds - 1.5 && t < kSeconds - 0.5) {
      lateSpeeds.push_back(input.machine.actualSpeed.value);
      lateAlarms += verdict.alarming() ? 1 : 0;
    }
  });

  ASSERT_GT(granted, 0.0) << "the cut never chattered";
  EXPECT_FALSE(commandedBefore);
  const double truth = plant.truth().chatterFrequency().value;
  ASSERT_GT(truth, 0.0);
  EXPECT_NEAR(median(named), truth, 0.01 * truth);
  // Chatter is known already, so the move comes at once; then the spindle needs its time, and the chatter some turns.
  EXPECT_GT(firstMove, 0.0);
  EXPECT_LT(firstMove - granted, 0.5);
  EXPECT_GT(chatterEnded, granted);
  EXPECT_LT(chatterEnded - granted, 2.0);
  EXPECT_FALSE(plant.truth().chattering());
  EXPECT_EQ(lateAlarms, 0);
  const auto [low, high] = std::minmax_element(lateSpeeds.begin(), lateSpeeds.end());
  ASSERT_NE(low, high);
  EXPECT_LT(*high - *low, 0.01 * *low) << "the speed still moves";
}

TEST(ClosedLoop, WithAutoFromTheStartTheChatterNeverMarksTheWork) {
  const ScenarioRig controlled = demoRig(test::demoCut());
  controlled.rig->send({OperatorAction::SetAuthority, Authority::Auto});
  controlled.rig->runToEnd({});
  const ScenarioRig alone = demoRig(test::demoCut());
  alone.rig->runToEnd({});
  EXPECT_GT(alone.source->plant().truth().peakRatio(), 1.0);
  EXPECT_LT(controlled.source->plant().truth().marked().value, 0.2 * alone.source->plant().truth().marked().value);
}

class NoAuthority : public testing::TestWithParam<Authority> {};

TEST_P(NoAuthority, NothingIsEverCommanded) {
  const ScenarioRig demo = demoRig(test::demoCut());
  if (GetParam() != Authority::Off) demo.rig->send({OperatorAction::SetAuthority, GetParam()});
  int commands = 0, moved = 0, alarms = 0;
  demo.rig->runToEnd([&](const StepInput& input, const StepOutput& output) {
    EXPECT_EQ(output.authority, GetParam());
    commands += output.hasCommand ? 1 : 0;
    alarms += obeyed(output).alarming() ? 1 : 0;
    moved +=
        input.machine.valid && (input.machine.speedOverride != Ratio(1.0) || input.machine.feedOverride != Ratio(1.0))
            ? 1
            : 0;
  });
  EXPECT_GT(alarms, 0);
  EXPECT_EQ(commands, 0);
  EXPECT_EQ(moved, 0);
}

INSTANTIATE_TEST_SUITE_P(OffOrAdvise, NoAuthority, testing::Values(Authority::Off, Authority::Advise),
                         [](const auto& which) { return std::string(name(which.param)); });

// The demo's parts one by one, so that a test can stop one of them.
struct Parts {
  explicit Parts(const milling::Scenario& scenario)
      : cut(scenario),
        port(std::make_shared<milling::PlantPort>()),
        source(cut, 0, port),
        machine(cut, port),
        chain(makeChain()),
        feed(states, inputs),
        loop({chain, feed, commands, nullptr, nullptr, clock}),
        link(machine, commands, states) {
    EXPECT_TRUE(source.open().ok());
    auto limits = safety::gateLimits({}, cut.cutSetup(), "test");
    limits->autoAllowed = true;
    chain.prepare(cut.cutSetup(), {}, *limits);
    inputs.push({OperatorAction::SetAuthority, Authority::Auto});
    input.block.allocate(static_cast<int>(cut.cutSetup().channels.size()), cut.blockFrames);
  }
  static pipeline::ChainParts makeChain() {
    pipeline::ChainParts parts;
    parts.detectors.push_back(detect::makeDetector(detect::kDefaultDetector).value());
    parts.strategy = control::makeStrategy(control::kDefaultStrategy).value();
    return parts;
  }
  // One block; without the worker it is lost. False: the cut is over.
  bool advance(bool worker = true) {
    if (!source.read(input.block)) return false;
    if (worker) done = &loop.step(input);
    link.tick(input.block.end());
    return true;
  }
  double now() const { return sinceEpoch(input.block.end()).value; }
  MachineState state() { return *port->state(); }
  // Until our override holds the spindle well below the programmed speed.
  bool runUntilInForce() {
    while (advance()) {
      if (done->gate.commanding && state().speedOverride.value < 0.9 && done->output.command.speed.value < 0.9)
        return true;
    }
    return false;
  }

  milling::Scenario cut;
  std::shared_ptr<milling::PlantPort> port;
  daq::SimulatedSource source;
  cnc::SimulatedMachine machine;
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  rt::SpscRing<OperatorInput> inputs{8};
  SteadyClock clock;
  pipeline::Chain chain;
  pipeline::LiveStateSource feed;
  pipeline::StepLoop loop;
  pipeline::LinkRunner link;
  StepInput input;
  const pipeline::Chain::Step* done = nullptr;
};

TEST(StalledWorker, LeaseRunsOutAndTheMachineGoesBackToProgrammed) {
  Parts demo(test::demoCut(8.0));
  ASSERT_TRUE(demo.runUntilInForce());
  ASSERT_EQ(demo.link.leasesExpired(), 0U);
  const double stalledAt = demo.now();
  const double lease = toSeconds(demo.done->output.command.lease).value;
  std::optional<double> expiredAt, backAt;
  while (demo.now() < stalledAt + 1.5 && demo.advance(false)) {
    if (!expiredAt && demo.link.leasesExpired() > 0) expiredAt = demo.now();
    if (!backAt && demo.state().speedOverride == Ratio(1.0) && demo.state().feedOverride == Ratio(1.0))
      backAt = demo.now();
  }
  const double block = demo.cut.blockFrames / demo.cut.rate.value;
  ASSERT_TRUE(expiredAt.has_value());
  EXPECT_NEAR(*expiredAt - stalledAt, lease, 1.5 * block);
  ASSERT_TRUE(backAt.has_value());
  EXPECT_LT(*backAt - *expiredAt, 0.07 + 2.0 * block);  // the override path's longest delay
  EXPECT_NEAR(demo.state().actualSpeed.value, demo.cut.programme.speed.value, 0.02 * demo.cut.programme.speed.value);
  EXPECT_EQ(demo.link.leasesExpired(), 1U);

  // A worker that wakes up does not jump back to where it was: it starts again from 100 %, after its rest.
  const double wokeAt = demo.now();
  bool movedAtOnce = false;
  while (demo.now() < wokeAt + 0.5 && demo.advance()) {
    movedAtOnce = movedAtOnce || demo.state().speedOverride.value < 0.99;
  }
  EXPECT_FALSE(movedAtOnce);
}

TEST(LostLink, HoldsThenReleasesAndAsksForNothingMore) {
  Parts demo(test::demoCut(8.0));
  ASSERT_TRUE(demo.runUntilInForce());
  const double lostAt = demo.now();
  demo.machine.loseLink(true);
  const safety::GateLimits limits;
  std::optional<double> releasedAt;
  double heldSpeed = -1.0;
  bool heldStill = true, setAfterRelease = false;
  while (demo.now() < lostAt + 2.5 && demo.advance()) {
    if (!demo.done->output.hasCommand) continue;
    const CommandRecord& command = demo.done->output.command;
    if (command.kind == CommandKind::Release) {
      if (!releasedAt) releasedAt = demo.now();
      continue;
    }
    setAfterRelease = setAfterRelease || releasedAt.has_value();
    // Once the gate has noticed (one block later) nothing moves until the release.
    if (demo.now() > lostAt + 0.02) {
      if (heldSpeed < 0.0) heldSpeed = command.speed.value;
      heldStill = heldStill && command.speed.value == heldSpeed;
    }
  }
  ASSERT_TRUE(releasedAt.has_value());
  EXPECT_TRUE(heldStill);
  EXPECT_FALSE(setAfterRelease);
  EXPECT_GE(*releasedAt - lostAt, 0.9 * limits.holdTime.value);
  EXPECT_LE(*releasedAt - lostAt, limits.holdTime.value + limits.machineAge.value + 0.05);
  EXPECT_EQ(demo.state().speedOverride, Ratio(1.0));  // the machine's own watchdog
}

// Every verdict of one detector on a cut with nobody in control, three blocks of which are lost at `gapAt`.
std::vector<Verdict> verdictsAround(std::string_view id, const milling::Scenario& cut, double gapAt) {
  daq::SimulatedSource source(cut, 0, nullptr);
  EXPECT_TRUE(source.open().ok());
  detect::Conditioner conditioner;
  conditioner.prepare(cut.cutSetup(), {});
  auto detector = detect::makeDetector(id).value();
  detector->prepare(cut.cutSetup(), {});
  SampleBlock block;
  block.allocate(static_cast<int>(cut.cutSetup().channels.size()), cut.blockFrames);
  std::vector<Verdict> verdicts;
  std::uint64_t lost = 0;
  int toLose = 3;
  while (source.read(block)) {
    const bool inGap = sinceEpoch(block.firstSample).value >= gapAt;
    if (inGap && toLose > 0) {
      --toLose;
      lost += static_cast<std::uint64_t>(block.frames);
      continue;
    }
    if (lost > 0) {
      block.flags |= kBlockGap;
      block.lostFrames = lost;
      lost = 0;
    }
    verdicts.push_back(detector->process(conditioner.process(block, source.plant().machineState())));
  }
  return verdicts;
}

const Verdict& at(const std::vector<Verdict>& verdicts, double t) {
  return *std::find_if(verdicts.begin(), verdicts.end(),
                       [t](const Verdict& v) { return sinceEpoch(v.time).value >= t; });
}

// A stable cut whose first accelerometer comes loose at 5 s and whose second falls silent at 9 s. What the sensor
// knocks is no chatter either, in the half second before it is known to be loose; then the other goes on alone.
TEST(LooseSensor, IsLeftOutAndWithoutAnyOtherNothingIsJudged) {
  auto scenario = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/loose-sensor.toml");
  ASSERT_TRUE(scenario) << scenario.error().line();
  for (const unsigned seed : {1U, 2U, 4U}) {
    scenario->seed = seed;
    const ScenarioRig cut = demoRig(*scenario);
    double t = 0.0;
    int judgedByNone = 0;
    cut.rig->runToEnd([&](const StepInput& input, const StepOutput& output) {
      t = sinceEpoch(input.block.end()).value;
      const Verdict& verdict = obeyed(output);
      EXPECT_FALSE(verdict.alarming()) << seed << " " << t;
      if (t < 9.0) {
        EXPECT_TRUE(verdict.valid) << seed << " " << t << " " << identifier(verdict.reason.code);
      } else if (t > 10.0) {
        judgedByNone += verdict.valid ? 1 : 0;
        EXPECT_TRUE(verdict.valid || verdict.reason.code == ReasonCode::InputLoose ||
                    verdict.reason.code == ReasonCode::InputSilent || verdict.reason.code == ReasonCode::InputDead)
            << seed << " " << t << " " << identifier(verdict.reason.code);
      }
    });
    // Beside a loose sensor that a second one is dead takes long to tell from a tool that leaves.
    EXPECT_LT(judgedByNone, 75) << seed << ", of 200";
    EXPECT_GT(t, 11.9);
  }
}

class Gap : public testing::TestWithParam<std::string_view> {};

TEST_P(Gap, InAStableCutIsSaidAndWhatWasLearnedStays) {
  constexpr double kGapAt = 1.2;
  milling::Scenario stable = test::demoCut();
  stable.programme.depth = milling::constantSchedule(0.5e-3);  // less than half of the limit
  const auto verdicts = verdictsAround(GetParam(), stable, kGapAt);
  ASSERT_TRUE(at(verdicts, kGapAt - 0.02).valid);
  const Verdict& first = at(verdicts, kGapAt + 0.03);
  EXPECT_FALSE(first.valid);
  EXPECT_EQ(first.reason.code, ReasonCode::InputGap);
  EXPECT_EQ(first.reason.n[0], 3.0 * stable.blockFrames);
  for (const Verdict& verdict : verdicts) {
    const double t = sinceEpoch(verdict.time).value;
    if (t > kGapAt - 0.1 && t < 1.6) {  // by then the first learning is over for the slowest
      EXPECT_FALSE(verdict.alarming()) << t;
      EXPECT_NE(verdict.reason.code, ReasonCode::Learning) << t;
      EXPECT_EQ(verdict.phase, CutPhase::Steady) << t;
    }
  }
  EXPECT_TRUE(at(verdicts, kGapAt + 0.3).valid) << identifier(at(verdicts, kGapAt + 0.3).reason.code);
}

TEST_P(Gap, InChatterDoesNotEndTheAlarmForLong) {
  constexpr double kGapAt = 3.6;
  const auto verdicts = verdictsAround(GetParam(), test::demoCut(), kGapAt);
  ASSERT_TRUE(at(verdicts, kGapAt - 0.05).alarming());
  EXPECT_FALSE(at(verdicts, kGapAt + 0.03).valid);
  EXPECT_TRUE(at(verdicts, kGapAt + 0.4).alarming()) << identifier(at(verdicts, kGapAt + 0.4).reason.code);
}

std::vector<std::string_view> detectors() {
  std::vector<std::string_view> ids;
  for (const auto& row : detect::detectorTable()) ids.push_back(row.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(EveryDetector, Gap, testing::ValuesIn(detectors()), [](const auto& which) {
  std::string name(which.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace stillcut::app
