// The link with stillcut-hal in a real LinuxCNC: whoever dies, the machine goes home by itself.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/cnc/link_trial.h"
#include "core/cnc/linuxcnc/emc_session.h"
#include "core/cnc/linuxcnc/emc_status.h"
#include "tests/protocol/commander.h"
#include "tests/protocol/linuxcnc_bench.h"

namespace stillcut::cnc {
namespace {

using testing::Commander;
using testing::linkToLinuxCnc;
using testing::LinuxCncPeer;

// The lease is 0.2 s; the rest is for what this host adds when it is busy: single stalls of tens of milliseconds in
// processes that are not real-time (halui, the watcher of this test).
constexpr double kLease = 0.2, kBusyHost = 0.2;

std::unique_ptr<CncLink> linkWithComponent() {
  return linkToLinuxCnc({{"hal_component_port", std::to_string(LinuxCncPeer::kComponentPort)}});
}

// What the machine does, from its own pins: the spindle's commanded speed and the path's feed. It asks halrmt alone,
// and only once the program under test has fallen silent: linuxcncrsh was seen to go down with several clients at once.
class PinWatch {
 public:
  PinWatch() : session_(std::move(app::makeWire({"127.0.0.1", LinuxCncPeer::kHalPort, {}})).value(), "EMC") {}
  bool readable() {
    session_.pump(clock_.now(), [](std::string_view, bool) {});
    return session_.idle();
  }
  // Both as programmed: 8000 rev/min, 600 mm/min.
  bool home() {
    const Instant now = clock_.now();
    const auto take = [&](std::string_view line, bool) { status_.take(line, now); };
    for (const char* request : {"get pinval spindle.0.speed-out", "get pinval motion.current-vel"}) {
      session_.pump(now, take);
      if (!session_.ask(request, now)) return false;
      session_.wait(std::chrono::milliseconds(2));
      session_.pump(now, take);
    }
    return status_.commandedSpeed.value.value > 7999.0 && toMmPerMin(status_.currentFeed.value) > 599.0;
  }

 private:
  SteadyClock clock_;
  EmcSession session_;
  EmcStatus status_;
};

class LinuxCncHalReal : public testing::LinuxCncBench {
 protected:
  static void SetUpTestSuite() { peer_ = new LinuxCncPeer(LinuxCncPeer::Overrides::Component); }
  static void TearDownTestSuite() {
    delete peer_;
    peer_ = nullptr;
  }
  void SetUp() override {
    if (!peer_->ok()) GTEST_SKIP() << peer_->why();
    peer_->run("long.ngc");
    watch();
  }
  void TearDown() override { link_.reset(); }
  void watch() {
    link_ = linkWithComponent();
    ASSERT_TRUE(until(cutting)) << "program " << seen_.programRunning << ", speed " << seen_.actualSpeed.value;
  }
  // From `death` until both overrides are at 100 % in the machine itself.
  void expectHomeWithinTheLease(const char* after, const std::function<void()>& death) {
    PinWatch watch;
    ASSERT_TRUE(testing::within(Seconds(3.0), [&] { return watch.readable(); }));
    ASSERT_FALSE(watch.home());
    const Instant began = clock_.now();
    death();
    EXPECT_TRUE(testing::within(Seconds(kLease + kBusyHost), [&] { return watch.home(); })) << after;
    std::printf("back at 100 %% %.0f ms after %s\n", 1e3 * secondsBetween(began, clock_.now()).value, after);
  }

  static LinuxCncPeer* peer_;
};
LinuxCncPeer* LinuxCncHalReal::peer_ = nullptr;

TEST_F(LinuxCncHalReal, OpensAndSaysThatTheMachineWatches) {
  const auto link = linkWithComponent();
  const Status opened = link->open();
  ASSERT_TRUE(opened.ok()) << opened.error().line();
  EXPECT_TRUE(link->describe().machineWatchdog);
}

TEST_F(LinuxCncHalReal, TrialPassesAndMeasuresTheDelay) {
  link_.reset();
  const auto link = linkWithComponent();
  LinkTrial trial(*link, clock_);
  while (trial.next()) {
    const LinkTrialStep& step = trial.steps().back();
    std::printf("%s: %s\n", step.what.c_str(), text(step.said).c_str());
  }
  EXPECT_TRUE(trial.passed());
  EXPECT_GT(trial.look().value, 0.0);
  EXPECT_LT(trial.look().value, 0.1);
}

// Beside any screen: what linuxcncrsh and halrmt would tell comes from stillcut-status, which changes nothing.
TEST_F(LinuxCncHalReal, StatusAndComponentNeedNoServerOfTheScreens) {
  link_ = linkToLinuxCnc({{"hal_component_port", std::to_string(LinuxCncPeer::kComponentPort)},
                          {"status_port", std::to_string(LinuxCncPeer::kStatusPort)}});
  const Status opened = link_->open();
  ASSERT_TRUE(opened.ok()) << opened.error().line();
  ASSERT_TRUE(until(cutting)) << seen_.actualSpeed.value;
  EXPECT_NEAR(seen_.programmedFeed.value, 600.0 / 60000.0, 1e-6);
  EXPECT_TRUE(untilCommanding(90.0, [](const MachineState& m) {
    return at(m, 0.9) && std::abs(m.actualSpeed.value - 7200.0) < 20.0;
  })) << seen_.actualSpeed.value;
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }, 1.0));
  const auto wire =
      std::move(app::makeWire({.host = "127.0.0.1", .port = LinuxCncPeer::kStatusPort, .device = {}})).value();
  wire->connect();
  ASSERT_TRUE(testing::within(Seconds(2.0), [&] { return wire->state() == WireState::Open; }));
  ASSERT_TRUE(wire->write("hello EMC x 1.0\r\nset feed_override 50\r\nset machine off\r\n"));
  std::array<char, 256> said{};
  std::size_t n = 0;
  ASSERT_TRUE(testing::within(Seconds(2.0), [&] {
    n += wire->read(std::span(said).subspan(n));
    return std::string_view(said.data(), n).find("SET NAK\r\nSET NAK") != std::string_view::npos;
  }));
  EXPECT_TRUE(until([](const MachineState& m) { return m.programRunning && at(m, 1.0); }, 1.0));
}

TEST_F(LinuxCncHalReal, BothOverridesActWithoutControlAndGoBack) {
  EXPECT_TRUE(untilCommanding(90.0, [](const MachineState& m) {
    return at(m, 0.9) && std::abs(m.actualSpeed.value - 7200.0) < 20.0;
  })) << seen_.actualSpeed.value;
  EXPECT_NE(LinuxCncPeer::talk({"get enable"}).find("ENABLE OFF"), std::string::npos);
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }, 1.0));
}

TEST_F(LinuxCncHalReal, LockedByTheProgramIsSaid) {
  peer_->run("m49.ngc");
  ASSERT_TRUE(until([](const MachineState& m) { return m.programmedSpeed.value == 5000.0 && m.programRunning; }));
  EXPECT_TRUE(untilCommanding(90.0, [](const MachineState& m) { return m.valid && !m.overridesEnabled; }));
  EXPECT_NEAR(seen_.speedOverride.value, 1.0, 1e-6);  // the machine's own lock holds
}

// The pin says 90 % in both, and only the path's velocity tells whether the program follows it.
TEST_F(LinuxCncHalReal, AdaptiveFeedThatTheProgramDoesNotFollowIsSaid) {
  link_ =
      linkToLinuxCnc({{"hal_component_port", std::to_string(LinuxCncPeer::kComponentPort)}, {"adaptive_feed", "true"}});
  const auto cuts = [](const MachineState& m) { return m.programmedSpeed.value == 5000.0 && m.programRunning; };
  for (const char* word : {"M52 P0", "M52 P1"}) {
    const bool follows = std::string(word) == "M52 P1";
    peer_->run(peer_->locking(word));
    ASSERT_TRUE(until(cuts));
    EXPECT_TRUE(untilCommanding(90.0, [&](const MachineState& m) {
      // 540 of 600 mm/min; the path also comes through 540 on its way up, with nothing in force yet
      const bool slower = m.feedOverride.value < 0.95 && std::abs(toMmPerMin(m.actualFeed) - 540.0) < 1.0;
      return m.valid && (follows ? slower : m.block == OverrideInhibit::AdaptiveLocked && !m.overridesEnabled);
    })) << word;
    EXPECT_NEAR(seen_.feedOverride.value, follows ? 0.9 : 1.0, 1e-3) << word;
    link_->release(clock_.now());
    EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }, 2.0)) << word;
  }
}

// halui's orders are taken in every state of the machine.
TEST_F(LinuxCncHalReal, MachineOffIsSaidAndHomeAllTheSame) {
  ASSERT_TRUE(untilCommanding(90.0, [](const MachineState& m) { return at(m, 0.9); }));
  LinuxCncPeer::talk({"set enable EMCTOO", "set machine off", "set enable off"});
  ASSERT_TRUE(until([](const MachineState& m) { return m.valid && m.block == OverrideInhibit::MachineOff; }));
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }, 1.0));
  EXPECT_EQ(seen_.block, OverrideInhibit::MachineOff);
}

TEST_F(LinuxCncHalReal, KilledProgramIsHomeWithinTheLease) {
  link_.reset();  // stillcut-hal has one client
  const Commander program(linkWithComponent);
  ASSERT_TRUE(program.took());
  expectHomeWithinTheLease("the program was killed", [&] { program.signal(SIGKILL); });
}

TEST_F(LinuxCncHalReal, HungProgramIsHomeWithinTheLease) {
  link_.reset();
  const Commander program(linkWithComponent);
  ASSERT_TRUE(program.took());
  expectHomeWithinTheLease("the program hung", [&] { program.signal(SIGSTOP); });
}

TEST_F(LinuxCncHalReal, HungComponentIsHomeWithinTheLeaseAndTakenUpAgain) {
  ASSERT_TRUE(untilCommanding(90.0, [](const MachineState& m) { return at(m, 0.9); }));
  const pid_t component = peer_->process("stillcut-hal");
  ASSERT_GT(component, 0);
  expectHomeWithinTheLease("stillcut-hal hung", [&] { ::kill(component, SIGSTOP); });
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && !m.controlOurs; }, 2.0));
  ::kill(component, SIGCONT);
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return m.controlOurs && at(m, 1.0); }));
}

// Two programs on the same knobs: the second may look, as often as it likes, and its orders are not taken.
TEST_F(LinuxCncHalReal, SecondClientOfTheComponentLooksAndHoldsNothing) {
  ASSERT_TRUE(until([](const MachineState& m) { return m.valid && m.controlOurs; }));
  const auto second = std::move(app::makeWire({"127.0.0.1", LinuxCncPeer::kComponentPort, {}})).value();
  second->connect();
  std::string heard;
  const auto speak = [&] {
    std::array<char, 256> bytes;
    while (const std::size_t n = second->read(bytes)) heard.append(bytes.data(), n);
    if (second->state() == WireState::Open) second->write("home 70 70\nset 50 50 1 70 70\n");
  };
  EXPECT_TRUE(untilCommanding(90.0, [&](const MachineState& m) {
    if (at(m, 0.9)) speak();
    return at(m, 0.9) && heard.find("TAKEN") != std::string::npos;
  }));
  EXPECT_EQ(second->state(), WireState::Open);
  EXPECT_TRUE(at(seen_, 0.9) && seen_.controlOurs);
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0); }, 1.0));
}

// The last one: HAL does not take a killed component back before the machine is started anew.
TEST_F(LinuxCncHalReal, ZKilledComponentIsHomeWithinTheLease) {
  ASSERT_TRUE(untilCommanding(90.0, [](const MachineState& m) { return at(m, 0.9); }));
  const pid_t component = peer_->process("stillcut-hal");
  ASSERT_GT(component, 0);
  expectHomeWithinTheLease("stillcut-hal was killed", [&] { ::kill(component, SIGKILL); });
  EXPECT_TRUE(until([](const MachineState& m) { return m.valid && !m.controlOurs; }, 2.0));
}

}  // namespace
}  // namespace stillcut::cnc
