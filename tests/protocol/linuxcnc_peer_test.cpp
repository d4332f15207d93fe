// The link against a real LinuxCNC with a spindle that takes time. One machine for all of these, started once; they
// wait for it in real time, and each wait is bounded.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <functional>
#include <memory>
#include <utility>

#include "app/io/wires.h"
#include "core/cnc/linuxcnc_link.h"
#include "core/cnc/registry.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/linuxcnc_peer.h"

namespace stillcut::cnc {
namespace {

using testing::CommandMaker;
using testing::LinuxCncPeer;

class LinuxCncReal : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { peer_ = new LinuxCncPeer; }
  static void TearDownTestSuite() {
    delete peer_;
    peer_ = nullptr;
  }
  void SetUp() override {
    if (!peer_->ok()) GTEST_SKIP() << peer_->why();
    peer_->run("long.ngc");
    link_ = makeOne();
    ASSERT_TRUE(until(cutting)) << "program " << seen_.programRunning << ", speed " << seen_.actualSpeed.value;
  }
  void TearDown() override { link_.reset(); }

  static std::unique_ptr<CncLink> makeOne() {
    static const SteadyClock clock;
    LinkRequest request;
    request.settings = {{"host", "127.0.0.1"}};
    request.wires = app::makeWire;
    request.clock = &clock;
    return std::move(makeLink("linuxcnc", request)).value();
  }
  // long.ngc at its speed.
  static bool cutting(const MachineState& m) {
    return m.valid && m.programRunning && m.programmedSpeed.value == 8000.0 &&
           std::abs(m.actualSpeed.value - 8000.0) < 40.0;
  }
  // Ticks of the link thread until `wanted`, or false after `seconds`.
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 8.0) {
    const Instant end = clock_.now() + toDuration(Seconds(seconds));
    while (clock_.now() < end) {
      seen_ = link_->read(clock_.now());
      if (wanted(seen_)) return true;
      ::usleep(2000);
    }
    return false;
  }
  void apply(double percent) { link_->apply(gate_.set(percent), clock_.now()); }

  static LinuxCncPeer* peer_;
  SteadyClock clock_;
  std::unique_ptr<CncLink> link_;
  CommandMaker gate_;
  MachineState seen_;
};
LinuxCncPeer* LinuxCncReal::peer_ = nullptr;

TEST_F(LinuxCncReal, OpensReadsAndLeavesControlAlone) {
  ASSERT_TRUE(makeOne()->open().ok());
  EXPECT_NEAR(seen_.programmedSpeed.value, 8000.0, 1e-6);
  EXPECT_NEAR(seen_.actualSpeed.value, 8000.0, 80.0);
  EXPECT_TRUE(seen_.overridesEnabled && seen_.controlOurs && seen_.linkUp);
  EXPECT_NE(LinuxCncPeer::talk({"get enable"}).find("ENABLE OFF"), std::string::npos);
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

TEST_F(LinuxCncReal, LockedByTheProgramIsSaid) {
  peer_->run("m49.ngc");
  ASSERT_TRUE(until([](const MachineState& m) { return m.programmedSpeed.value == 5000.0 && m.programRunning; }));
  apply(90.0);
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && !m.overridesEnabled; }));
  EXPECT_NEAR(seen_.speedOverride.value, 1.0, 1e-6);
}

TEST_F(LinuxCncReal, AnotherClientTakesControlAndKeepsIt) {
  apply(90.0);
  ASSERT_TRUE(until([](const MachineState& m) { return std::abs(m.speedOverride.value - 0.9) < 1e-6; }));
  const std::string other =
      LinuxCncPeer::talk({"set enable EMCTOO", "set set_wait received", "set spindle_override 0 97"});
  EXPECT_NE(other.find("SET SPINDLE_OVERRIDE ACK"), std::string::npos);
  EXPECT_TRUE(until([](const MachineState& m) { return !m.controlOurs; }));
}

TEST_F(LinuxCncReal, AbortedProgramIsNotRunning) {
  LinuxCncPeer::talk({"set enable EMCTOO", "set abort"});
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && !m.programRunning; }));
}

// What peers.md says of this machine, and why it needs a watchdog of its own: the override stays.
TEST_F(LinuxCncReal, KilledProgramLeavesTheOverrideAndTheNextStartSeesIt) {
  link_.reset();  // one client at a time: see linuxcnc_link.h
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto link = makeOne();
    const SteadyClock clock;
    CommandMaker gate;
    const OverrideCommand command = gate.set(90.0);
    bool told = false;
    while (true) {
      const MachineState m = link->read(clock.now());
      link->apply(command, clock.now());
      if (!told && m.valid && std::abs(m.speedOverride.value - 0.9) < 1e-6) told = ::write(pipe[1], "k", 1) == 1;
      ::usleep(2000);
    }
  }
  pollfd inForce{pipe[0], POLLIN, 0};
  const bool took = ::poll(&inForce, 1, 15000) == 1;
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(pipe[0]);
  ::close(pipe[1]);
  ASSERT_TRUE(took);
  link_ = makeOne();
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && std::abs(m.speedOverride.value - 0.9) < 1e-6; }));
  EXPECT_FALSE(link_->describe().machineWatchdog);
}

}  // namespace
}  // namespace stillcut::cnc
