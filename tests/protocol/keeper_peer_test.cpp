// stillcut-keeper on a real pty with a scripted GRBL: whatever becomes of the program that moved the overrides, the
// operator's values are back in time. Programs are killed and stopped here; waits are in real time and bounded.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/io/kept_link.h"
#include "app/io/wires.h"
#include "tests/protocol/commander.h"
#include "tests/support/child.h"
#include "tests/support/grbl/pty_grbl.h"

namespace stillcut::app {
namespace {

using cnc::testing::Commander;
using cnc::testing::CommandMaker;
using cnc::testing::within;

// What is promised, and how long a loaded test machine may keep a process from running.
constexpr Seconds kPromised{0.2};
constexpr Seconds kPatience{5.0};

// The keeper that this process has started; 0: none.
int keeperOf(int parent) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    int process = 0, its = 0;
    std::string name, state;
    if (stat >> process >> name >> state >> its && its == parent && name == "(stillcut-keeper)") return process;
  }
  return 0;
}

class GrblKept : public ::testing::Test {
 protected:
  std::unique_ptr<cnc::CncLink> make() {
    cnc::LinkRequest request;
    request.settings = {{"device", path_}, {"baud", "115200"}};
    request.wires = makeWire;
    request.clock = &clock_;
    auto link = makeKeptLink("grbl", request, AnalogOutputs::Written, folder_.file(""));
    EXPECT_TRUE(link.ok()) << link.error().line();
    return std::move(link).value();
  }
  bool until(const std::function<bool(const MachineState&)>& wanted) {
    return within(kPatience, [&] {
      seen_ = link_->read(clock_.now());
      return wanted(seen_);
    });
  }
  static bool valid(const MachineState& m) { return m.valid; }
  bool take() {
    const OverrideCommand command = gate_.set(90.0);
    return until([&](const MachineState&) {
      link_->apply(command, clock_.now());
      return controller_.stands(90, 90);
    });
  }
  bool home() { return controller_.stands(100, 100); }
  // From now until it is home, s.
  double homeAfter() {
    const Instant began = clock_.now();
    EXPECT_TRUE(within(kPatience, [&] { return home(); }));
    return secondsBetween(began, clock_.now()).value;
  }

  cnc::testing::TemporaryFolder folder_;
  std::string path_ = folder_.file("machine");
  cnc::testing::PtyGrbl controller_{path_};
  SteadyClock clock_;
  CommandMaker gate_;
  MachineState seen_;
  std::unique_ptr<cnc::CncLink> link_;
};

TEST_F(GrblKept, OpensReadsMovesAndBringsBack) {
  link_ = make();
  EXPECT_TRUE(link_->describe().kept);
  EXPECT_EQ(link_->describe().label, "GRBL");
  ASSERT_TRUE(link_->open().ok());
  ASSERT_TRUE(until(valid));
  EXPECT_EQ(seen_.programmedSpeed.value, 8800.0);
  ASSERT_TRUE(take());
  EXPECT_TRUE(until([](const MachineState& m) { return std::abs(m.speedOverride.value - 0.9) < 1e-9; }));
  EXPECT_EQ(seen_.operatorSpeed.value, 1.0);
  link_->release(clock_.now());
  EXPECT_TRUE(home());
  link_->close();
  EXPECT_TRUE(make()->open().ok()) << "port and lock are free again";
}

TEST_F(GrblKept, WhatIsWrongIsSaidAsWithoutAKeeper) {
  controller_.pull();
  const Status opened = make()->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().line(), path_ + ": cannot be opened (is it there, and free?)");
  controller_.plugIn();
  link_ = make();
  ASSERT_TRUE(link_->open().ok());
  const Status second = make()->open();
  ASSERT_FALSE(second.ok());
  EXPECT_NE(second.error().line().find("the run that is going on holds this machine"), std::string::npos)
      << second.error().line();
}

TEST_F(GrblKept, AKilledProgramIsHomeInTime) {
  double worst = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Commander killed([&] { return make(); });
    ASSERT_TRUE(killed.took());
    killed.signal(SIGKILL);
    worst = std::max(worst, homeAfter());
  }
  EXPECT_LT(worst, kPromised.value);
  link_ = make();  // the machine is free, and stands at what its operator had
  ASSERT_TRUE(link_->open().ok());
  ASSERT_TRUE(until(valid));
  EXPECT_EQ(seen_.operatorSpeed.value, 1.0);
}

TEST_F(GrblKept, AProgramThatHangsIsHomeInTimeAndMayNotGoOnWithThatEngagement) {
  const Commander hung([&] { return make(); });
  ASSERT_TRUE(hung.took());
  hung.signal(SIGSTOP);
  EXPECT_LT(homeAfter(), kPromised.value);
  hung.signal(SIGCONT);
  EXPECT_FALSE(within(Seconds(0.3), [&] { return !home(); }));
}

TEST_F(GrblKept, TheOperatorsOwnPercentageIsWhereItGoes) {
  controller_.with([](cnc::testing::FakeGrbl& g) { g.feed = g.spindle = 80; });
  const Commander killed([&] { return make(); });
  ASSERT_TRUE(within(kPatience, [&] { return controller_.stands(72, 72); }));
  killed.signal(SIGKILL);
  const Instant began = clock_.now();
  EXPECT_TRUE(within(kPatience, [&] { return controller_.stands(80, 80); }));
  EXPECT_LT(secondsBetween(began, clock_.now()).value, kPromised.value);
}

TEST_F(GrblKept, AKeeperThatDiesIsReplacedAndWhatItLeftBroughtBack) {
  link_ = make();
  ASSERT_TRUE(link_->open().ok());
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  ASSERT_TRUE(until([](const MachineState& m) { return std::abs(m.feedOverride.value - 0.9) < 1e-9; }));
  const int keeper = keeperOf(::getpid());
  ASSERT_GT(keeper, 0);
  ::kill(keeper, SIGKILL);
  EXPECT_TRUE(until([&](const MachineState& m) { return m.valid && home(); }));
  EXPECT_EQ(seen_.operatorSpeed.value, 1.0) << "what was left is nobody's choice";
  EXPECT_GT(seen_.endedEngagement, 0U) << "the gate is told";
}

TEST_F(GrblKept, AKeeperThatIsToldToEndGoesHomeFirst) {
  const Commander program([&] { return make(); });
  ASSERT_TRUE(program.took());
  const int keeper = keeperOf(program.process());
  ASSERT_GT(keeper, 0);
  ::kill(keeper, SIGTERM);
  EXPECT_LT(homeAfter(), kPromised.value);
}

TEST_F(GrblKept, APulledCableIsGoneHomeToWhenItIsInAgain) {
  const Commander killed([&] { return make(); });
  ASSERT_TRUE(killed.took());
  controller_.pull();
  killed.signal(SIGKILL);
  EXPECT_FALSE(within(Seconds(0.3), [&] { return home(); }));
  controller_.plugIn();
  EXPECT_LT(homeAfter(), 2.0);
}

// As one that is killed: whoever ends in order is not worse off.
TEST_F(GrblKept, AProgramThatEndsWithTheCableOutIsGoneHomeForWhenItIsIn) {
  link_ = make();
  ASSERT_TRUE(link_->open().ok());
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  controller_.pull();
  link_.reset();
  EXPECT_FALSE(home());
  controller_.plugIn();
  EXPECT_LT(homeAfter(), 2.0);
}

TEST_F(GrblKept, AKeeperThatIsDeadOrHangsAtTheEndIsReplacedAllTheSame) {
  for (const int number : {SIGKILL, SIGSTOP}) {
    link_ = make();
    ASSERT_TRUE(link_->open().ok());
    ASSERT_TRUE(until(valid));
    ASSERT_TRUE(take());
    ASSERT_TRUE(until([](const MachineState& m) { return std::abs(m.feedOverride.value - 0.9) < 1e-9; }));
    ::kill(keeperOf(::getpid()), number);
    link_.reset();
    EXPECT_LT(homeAfter(), 2.0) << "signal " << number;
    EXPECT_TRUE(within(kPatience, [&] {
      link_ = make();
      return link_->open().ok();
    })) << "the successor has let go of the machine";
    link_.reset();
  }
}

// What its keeper left is nobody's but the successor's, which has not opened the machine yet.
TEST_F(GrblKept, AProgramKilledBeforeItsNewKeeperIsReadyIsHomeAllTheSame) {
  const Commander program([&] { return make(); });
  ASSERT_TRUE(program.took());
  const int keeper = keeperOf(program.process());
  ASSERT_GT(keeper, 0);
  ::kill(keeper, SIGKILL);
  ASSERT_TRUE(within(kPatience, [&] {
    const int next = keeperOf(program.process());
    return next > 0 && next != keeper;
  }));
  program.signal(SIGKILL);
  EXPECT_LT(homeAfter(), 2.0);
}

TEST_F(GrblKept, AKeeperKilledWithTheCableOutIsReplacedByOneThatWaitsForIt) {
  link_ = make();
  ASSERT_TRUE(link_->open().ok());
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  ASSERT_TRUE(until([](const MachineState& m) { return std::abs(m.feedOverride.value - 0.9) < 1e-9; }));
  controller_.pull();
  ::kill(keeperOf(::getpid()), SIGKILL);
  link_.reset();
  EXPECT_FALSE(within(Seconds(0.3), [&] { return home(); }));
  controller_.plugIn();
  EXPECT_LT(homeAfter(), 4.5);  // a start that is refused takes up to 3 s
}

}  // namespace
}  // namespace stillcut::app
