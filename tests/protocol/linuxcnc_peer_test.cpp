// The link against a real LinuxCNC with a spindle that takes time. One machine for all of these, started once; they
// wait for it in real time, and each wait is bounded.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/io/find_machines.h"
#include "app/io/kept_link.h"
#include "core/cnc/linuxcnc/linuxcnc_link.h"
#include "tests/protocol/commander.h"
#include "tests/protocol/linuxcnc_bench.h"

namespace stillcut::cnc {
namespace {

using testing::Commander;
using testing::linkToLinuxCnc;
using testing::LinuxCncPeer;

class LinuxCncReal : public testing::LinuxCncBench {
 protected:
  static void SetUpTestSuite() { peer_ = new LinuxCncPeer; }
  static void TearDownTestSuite() {
    delete peer_;
    peer_ = nullptr;
  }
  void SetUp() override {
    if (!peer_->ok()) GTEST_SKIP() << peer_->why();
    peer_->run("long.ngc");
    link_ = linkToLinuxCnc();
    ASSERT_TRUE(until(cutting)) << "program " << seen_.programRunning << ", speed " << seen_.actualSpeed.value;
  }
  void TearDown() override { link_.reset(); }

  static LinuxCncPeer* peer_;
};
LinuxCncPeer* LinuxCncReal::peer_ = nullptr;

TEST_F(LinuxCncReal, OpensReadsAndLeavesControlAlone) {
  ASSERT_TRUE(linkToLinuxCnc()->open().ok());
  EXPECT_NEAR(seen_.programmedSpeed.value, 8000.0, 1e-6);
  EXPECT_NEAR(seen_.actualSpeed.value, 8000.0, 80.0);
  EXPECT_TRUE(seen_.overridesEnabled && seen_.controlOurs && seen_.linkUp);
  EXPECT_NE(LinuxCncPeer::talk({"get enable"}).find("ENABLE OFF"), std::string::npos);
}

TEST_F(LinuxCncReal, IsFoundOnTheHostThatWasNamed) {
  std::vector<std::string> where;
  for (const app::FoundMachine& machine : app::findMachines({"127.0.0.1"}, Seconds(3.0))) {
    if (machine.link.id == "linuxcnc") where.push_back(machine.where);
  }
  EXPECT_EQ(where, (std::vector<std::string>{"127.0.0.1:5007", "127.0.0.1:5006"}));
}

TEST_F(LinuxCncReal, BothOverridesActAndTheSpindleFollows) {
  apply(90.0);
  EXPECT_TRUE(until([](const MachineState& m) {
    return std::abs(m.speedOverride.value - 0.9) < 1e-6 && std::abs(m.feedOverride.value - 0.9) < 1e-6 &&
           std::abs(m.actualSpeed.value - 7200.0) < 20.0;
  })) << seen_.actualSpeed.value;
  EXPECT_EQ(seen_.operatorSpeed.value, 1.0);
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return std::abs(m.actualSpeed.value - 8000.0) < 20.0; }));
  EXPECT_EQ(seen_.feedOverride.value, 1.0);
  EXPECT_NE(LinuxCncPeer::talk({"get enable"}).find("ENABLE OFF"), std::string::npos);
}

// The set is acknowledged and read back; which of the two overrides has no effect is said.
TEST_F(LinuxCncReal, LockedByTheProgramIsSaid) {
  const struct {
    const char* word;
    OverrideInhibit block;
    double speed, feed;
  } locks[] = {{"M49", OverrideInhibit::OverridesLocked, 1.0, 1.0},
               {"M51 P0", OverrideInhibit::SpeedLocked, 1.0, 0.9},
               {"M50 P0", OverrideInhibit::FeedLocked, 0.9, 1.0}};
  for (const auto& lock : locks) {
    peer_->run(peer_->locking(lock.word));
    ASSERT_TRUE(until([](const MachineState& m) { return m.programmedSpeed.value == 5000.0 && m.programRunning; }));
    apply(90.0);
    EXPECT_TRUE(until([&](const MachineState& m) { return m.valid && m.block == lock.block; })) << lock.word;
    EXPECT_FALSE(seen_.overridesEnabled);
    EXPECT_NEAR(seen_.speedOverride.value, lock.speed, 1e-6) << lock.word;
    EXPECT_NEAR(seen_.feedOverride.value, lock.feed, 1e-6) << lock.word;
    link_->release(clock_.now());
    EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }));
  }
}

// Off, and on without a program, are not the same; while it is off it takes no override, and the end is not held by it.
TEST_F(LinuxCncReal, MachineOffIsSaidAndKeepsTheOverrideUntilItIsOn) {
  apply(90.0);
  ASSERT_TRUE(until([](const MachineState& m) { return at(m, 0.9); }));
  LinuxCncPeer::talk({"set enable EMCTOO", "set machine off", "set enable off"});
  ASSERT_TRUE(until([](const MachineState& m) { return m.valid && m.block == OverrideInhibit::MachineOff; }));
  const Instant began = clock_.now();
  link_->release(clock_.now());
  EXPECT_LT(secondsBetween(began, clock_.now()).value, toSeconds(LinuxCncLink::kReleaseTime).value);
  EXPECT_NE(LinuxCncPeer::talk({"get feed_override"}).find("FEED_OVERRIDE 90"), std::string::npos);
  LinuxCncPeer::talk({"set enable EMCTOO", "set machine on", "set enable off"});
  // Another client was in control, and keeps it for 10 s where ours has noticed.
  EXPECT_TRUE(until([](const MachineState& m) { return m.block == OverrideInhibit::NoProgram && at(m, 1.0); }, 15.0));
}

TEST_F(LinuxCncReal, AnotherClientTakesControlAndKeepsIt) {
  apply(90.0);
  ASSERT_TRUE(until([](const MachineState& m) { return std::abs(m.speedOverride.value - 0.9) < 1e-6; }));
  const std::string other =
      LinuxCncPeer::talk({"set enable EMCTOO", "set set_wait received", "set spindle_override 0 97"});
  EXPECT_NE(other.find("SET SPINDLE_OVERRIDE ACK"), std::string::npos);
  EXPECT_TRUE(until([](const MachineState& m) { return !m.controlOurs && m.block == OverrideInhibit::OtherClient; }));
}

TEST_F(LinuxCncReal, AbortedProgramIsNotRunningAndTheReleaseBringsBack) {
  apply(90.0);
  ASSERT_TRUE(until([](const MachineState& m) { return at(m, 0.9); }));
  LinuxCncPeer::talk({"set enable EMCTOO", "set abort"});
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && !m.programRunning; }));
  link_->release(clock_.now());
  // Who aborted took control with it, and keeps it for 10 s; then they come back.
  EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }, 15.0));
}

TEST_F(LinuxCncReal, HungServerIsDownAndWhatWasOursIsBroughtBackOnceItGoesOn) {
  apply(90.0);
  ASSERT_TRUE(until([](const MachineState& m) { return at(m, 0.9); }));
  const pid_t server = peer_->process("linuxcncrsh");
  ASSERT_GT(server, 0);
  ::kill(server, SIGSTOP);
  EXPECT_TRUE(until([](const MachineState& m) { return !m.valid; }, 2.0));
  const Instant began = clock_.now();
  link_->release(clock_.now());  // bounded, though nobody answers
  EXPECT_LT(secondsBetween(began, clock_.now()).value, toSeconds(LinuxCncLink::kReleaseTime).value + 1.0);
  ::kill(server, SIGCONT);
  EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }));
}

// What peers.md says of this machine, and why it needs a watchdog of its own: the override stays.
TEST_F(LinuxCncReal, KilledProgramLeavesTheOverrideAndTheNextStartSeesIt) {
  link_.reset();  // one client at a time: see linuxcnc_link.h
  {
    const Commander program([] { return linkToLinuxCnc(); });
    ASSERT_TRUE(program.took());
  }  // killed
  link_ = linkToLinuxCnc();
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && std::abs(m.speedOverride.value - 0.9) < 1e-6; }));
  EXPECT_FALSE(link_->describe().machineWatchdog);
}

// With a keeper that holds the wires it does not: the operator's values are back before the keeper goes, and for the
// next start they are the operator's.
TEST_F(LinuxCncReal, KilledProgramIsBroughtHomeByItsKeeper) {
  link_.reset();
  {
    const Commander program([this] {
      LinkRequest request;
      request.settings = {{"host", "127.0.0.1"}};
      request.wires = app::makeWire;
      request.clock = &clock_;
      return std::move(app::makeKeptLink("linuxcnc", request)).value();
    });
    ASSERT_TRUE(program.took());
  }  // killed
  ASSERT_TRUE(testing::within(Seconds(5.0), [] { return std::system("pgrep -x stillcut-keeper >/dev/null") != 0; }));
  link_ = linkToLinuxCnc();
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid; }));
  EXPECT_TRUE(at(seen_, 1.0)) << seen_.speedOverride.value << " " << seen_.feedOverride.value;
}

// Told to end with our link open, and started anew: its overrides are at 100 % then, and nothing of ours is believed to
// stand there.
TEST_F(LinuxCncReal, RestartedMachineIsFoundAgain) {
  apply(90.0);
  ASSERT_TRUE(until([](const MachineState& m) { return at(m, 0.9); }));
  std::atomic<bool> ended{false};
  std::thread ending([&] {
    peer_->end();
    ended = true;
  });
  EXPECT_TRUE(until([&](const MachineState& m) { return ended && !m.valid && !m.linkUp; }, 15.0));
  ending.join();
  link_->release(clock_.now());
  peer_->start();
  ASSERT_TRUE(peer_->ok()) << peer_->why();
  peer_->run("long.ngc");
  EXPECT_TRUE(until([](const MachineState& m) { return cutting(m) && at(m, 1.0); }))
      << "up " << seen_.linkUp << ", valid " << seen_.valid << ", program " << seen_.programRunning << ", speed "
      << seen_.actualSpeed.value << ", overrides " << seen_.speedOverride.value << " " << seen_.feedOverride.value;
}

}  // namespace
}  // namespace stillcut::cnc
