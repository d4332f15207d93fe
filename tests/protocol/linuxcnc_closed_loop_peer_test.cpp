// The whole loop through a real controller: a simulated cut whose spindle and feed are those that LinuxCNC really runs.
// Chatter grows at the programmed 8500 rev/min, the strategy asks for a stable speed, the gate commands it,
// stillcut-hal turns LinuxCNC's overrides, its spindle follows, and only then the cut hears of it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "app/compose/rig.h"
#include "core/daq/simulated/simulated_source.h"
#include "tests/protocol/linuxcnc_bench.h"
#include "tests/support/demo_cut.h"

namespace stillcut::cnc {
namespace {

using testing::linkToLinuxCnc;
using testing::LinuxCncPeer;
using testing::within;

constexpr double kSpeed = 8500.0, kFeed = 2720.0;  // of the demo's programme, rev/min and mm/min
constexpr const char* kProgram =
    "G21 G90 G94 G17 G64 P0.01\nT1 M6\nS8500 M3\nG0 X-900 Y0 Z-1\nG1 X900 F2720\nY20\nX-900\nY40\nX900\nM5\nM2\n";

// LinuxCNC's link, which also tells the simulated cut what the machine does. Simulated: LinuxCNC runs a mill that
// exists only in its own memory.
class CutOnLinuxCnc final : public CncLink {
 public:
  CutOnLinuxCnc(std::unique_ptr<CncLink> machine, std::shared_ptr<milling::PlantPort> port)
      : machine_(std::move(machine)), port_(std::move(port)) {}
  LinkInfo describe() const override {
    LinkInfo info = machine_->describe();
    info.simulated = true;
    return info;
  }
  Status open() override { return machine_->open(); }
  MachineState read(Instant now) noexcept override {
    const MachineState m = machine_->read(now);
    if (m.valid && m.actualSpeed.value > 0.0) {
      milling::PlantCommand order;
      order.speed = Ratio(m.actualSpeed.value / kSpeed);
      order.feed = Ratio(toMmPerMin(m.actualFeed) / kFeed);
      order.when = now;
      port_->order(order);
    }
    return m;
  }
  void apply(const OverrideCommand& command, Instant now) noexcept override { machine_->apply(command, now); }
  void release(Instant now) noexcept override { machine_->release(now); }
  void close() noexcept override { machine_->close(); }

 private:
  std::unique_ptr<CncLink> machine_;
  std::shared_ptr<milling::PlantPort> port_;
};

// The demo's cut, with nothing between LinuxCNC's spindle and the tool: no delay, no lag, no steps of its own.
milling::Scenario cut(double seconds) {
  milling::Scenario s = test::demoCut(seconds);
  s.overrides = {.lowestSpeed = Ratio(0.5),
                 .highestSpeed = Ratio(1.5),
                 .lowestFeed = Ratio(0.0),
                 .highestFeed = Ratio(1.5),
                 .resolution = Ratio(0.0),
                 .shortestDelay = Seconds(0.0),
                 .longestDelay = Seconds(0.0)};
  s.drive.bandwidth = Hertz(40.0);
  s.drive.acceleration = 1e6;
  s.drive.torqueLimit = 200.0;
  s.programme.feedLag = Seconds(0.005);
  return s;
}

struct Seen {
  bool chatterAtProgrammedSpeed = false;
  double peakRms = 0.0, lastRms = 0.0;
  Seconds quiet{};  // since the last onset or chatter, at another speed
  MachineState machine;
  Instant noisy{};
  CutState state = CutState::AirCutting;
  Reason reason;
};

void look(const Snapshot& s, Seen& seen) {
  const CutState state = s.verdicts[static_cast<std::size_t>(s.inCharge)].state;
  const bool noisy = state == CutState::Onset || state == CutState::Chatter;
  const bool programmed = std::abs(s.machine.actualSpeed.value - kSpeed) < 0.02 * kSpeed;
  seen.chatterAtProgrammedSpeed = seen.chatterAtProgrammedSpeed || (noisy && programmed);
  if (noisy || programmed || state != CutState::Stable) seen.noisy = s.time;
  seen.quiet = secondsBetween(seen.noisy, s.time);
  seen.peakRms = std::max(seen.peakRms, s.vibrationRms);
  seen.lastRms = s.vibrationRms;
  seen.machine = s.machine;
  seen.state = state;
  seen.reason = s.verdicts[static_cast<std::size_t>(s.inCharge)].reason;
}

constexpr const char* kAsked = "get spindle_override 0";

// On LinuxCNC's own screen; its server answers late while its program is at work.
bool says(int percent) {
  const std::string wanted = "SPINDLE_OVERRIDE 0 " + std::to_string(percent);
  return within(Seconds(5.0), [&] { return LinuxCncPeer::talk({kAsked}).find(wanted) != std::string::npos; });
}

TEST(LinuxCncClosedLoop, ChatterIsFoundAndSuppressedThroughTheRealController) {
  LinuxCncPeer peer(LinuxCncPeer::Overrides::Component);
  if (!peer.ok()) GTEST_SKIP() << peer.why();
  peer.write("demo.ngc", kProgram);
  peer.run("demo.ngc");

  {
    // The tool meets the material at speed, as in the demo.
    const auto link = linkToLinuxCnc();
    const SteadyClock clock;
    ASSERT_TRUE(within(Seconds(10.0), [&] {
      const MachineState m = link->read(clock.now());
      return m.valid && m.programRunning && std::abs(m.actualSpeed.value - kSpeed) < 10.0 && m.actualFeed.value > 0.0;
    }));
  }

  const milling::Scenario scenario = cut(30.0);
  const auto port = std::make_shared<milling::PlantPort>();
  app::RigSpec spec;
  spec.device = std::make_unique<daq::SimulatedSource>(scenario, 0, port, daq::SimulatedPace{.realTime = true});
  spec.link = std::make_unique<CutOnLinuxCnc>(
      linkToLinuxCnc({{"hal_component_port", std::to_string(LinuxCncPeer::kComponentPort)}}), port);
  spec.setup = scenario.cutSetup();
  spec.methods.strategy = scenario.strategy;
  spec.autoAllowed = true;
  spec.watched = true;
  auto rig = app::Rig::build(std::move(spec));
  ASSERT_TRUE(rig.ok()) << rig.error().line();
  app::Rig& run = **rig;
  EXPECT_TRUE(run.linkInfo().machineWatchdog);
  run.start({});
  ASSERT_TRUE(run.send({OperatorAction::SetAuthority, Authority::Auto}));

  Seen seen;
  const bool suppressed = within(Seconds(25.0), [&] {
    if (const Snapshot* s = run.read()) look(*s, seen);
    return seen.chatterAtProgrammedSpeed && seen.quiet.value > 1.5;
  });
  std::printf("LinuxCNC's spindle at %.0f rpm, feed %.0f %%, vibration %.3g of its peak\n",
              seen.machine.actualSpeed.value, 100.0 * seen.machine.feedOverride.value, seen.lastRms / seen.peakRms);
  EXPECT_TRUE(seen.chatterAtProgrammedSpeed);
  EXPECT_TRUE(suppressed) << "quiet for " << seen.quiet.value << " s, now " << name(seen.state) << ": "
                          << sentence(seen.reason);
  EXPECT_LT(seen.lastRms, 0.5 * seen.peakRms);
  // The same on LinuxCNC's own screen: its override, not only what we read.
  const int percent = static_cast<int>(std::lround(100.0 * seen.machine.speedOverride.value));
  EXPECT_TRUE(says(percent)) << percent << " % read, on its screen: " << LinuxCncPeer::talk({kAsked});
  (void)run.stop().ok();
  EXPECT_TRUE(says(100)) << "on its screen: " << LinuxCncPeer::talk({kAsked});
}

}  // namespace
}  // namespace stillcut::cnc
