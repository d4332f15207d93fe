// The GRBL link through QSerialPort on a real pty, reached by a typed path, with a scripted controller on its other
// end. Waits are in real time, and each is bounded.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/io/wires.h"
#include "core/cnc/registry.h"
#include "tests/protocol/commander.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/grbl/pty_grbl.h"

namespace stillcut::cnc {
namespace {

class GrblOnAPty : public ::testing::Test {
 protected:
  std::unique_ptr<CncLink> make() {
    LinkRequest request;
    request.settings = {{"device", path_}, {"baud", "115200"}};
    request.wires = app::makeWire;
    request.clock = &clock_;
    auto link = makeLink("grbl", request);
    EXPECT_TRUE(link.ok()) << link.error().line();
    return std::move(link).value();
  }
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 8.0) {
    return testing::within(Seconds(seconds), [&] {
      seen_ = link_->read(clock_.now());
      return wanted(seen_);
    });
  }
  static bool valid(const MachineState& m) { return m.valid; }
  bool take() {
    link_->apply(gate_.set(90.0), clock_.now());
    return until([&](const MachineState&) { return controller_.stands(90, 90); });
  }

  testing::TemporaryFolder folder_;
  std::string path_ = folder_.file("machine");
  testing::PtyGrbl controller_{path_};
  SteadyClock clock_;
  testing::CommandMaker gate_;
  MachineState seen_;
  std::unique_ptr<CncLink> link_ = make();
};

TEST_F(GrblOnAPty, TypedPathOpensReadsMovesAndBringsBack) {
  ASSERT_TRUE(link_->open().ok());
  ASSERT_TRUE(until(valid));
  EXPECT_EQ(seen_.programmedSpeed.value, 8800.0);
  EXPECT_GT(seen_.link.roundTrip.value, 0.0);
  ASSERT_TRUE(take());
  EXPECT_TRUE(until([](const MachineState& m) { return std::abs(m.speedOverride.value - 0.9) < 1e-9; }));
  link_->release(clock_.now());
  EXPECT_TRUE(controller_.stands(100, 100));
}

TEST_F(GrblOnAPty, EndOfTheProgramBringsBack) {
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  link_.reset();
  EXPECT_TRUE(testing::within(Seconds(2.0), [&] { return controller_.stands(100, 100); }));
}

TEST_F(GrblOnAPty, PulledAdapterIsDownAndOneThatComesBackIsBroughtBack) {
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  controller_.pull();
  EXPECT_TRUE(until([](const MachineState& m) { return !m.valid && !m.linkUp; }));
  link_->release(clock_.now());
  EXPECT_TRUE(controller_.stands(90, 90));  // no way there, and GRBL has no watchdog
  controller_.plugIn();
  EXPECT_TRUE(until([&](const MachineState& m) { return m.valid && controller_.stands(100, 100); }));
}

TEST_F(GrblOnAPty, ControllerThatRestartsIsSeenAnew) {
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  controller_.with([](testing::FakeGrbl& g) { g.feed = g.spindle = 100; });  // a soft reset
  link_->release(clock_.now());
  EXPECT_TRUE(until([&](const MachineState& m) { return m.valid && controller_.stands(100, 100); }));
}

// The command line finds its way by the typed path, writes the link and its delay into the profile, and compares later.
TEST_F(GrblOnAPty, TriedLinkIsSavedWithItsDelay) {
  link_.reset();
  const std::string profile = folder_.file("mill.toml"), said = folder_.file("said");
  std::ofstream(profile) << "version = 1\nmachine = \"Mill\"\n";
  const auto tries = [&](const std::string& more) {
    const std::string line = std::string(STILLCUT_CLI) + " devices --profile " + profile + more + " >" + said;
    const int status = std::system(line.c_str());
    std::ifstream in(said);
    return std::pair(status, std::string(std::istreambuf_iterator<char>(in), {}));
  };
  const auto [first, firstSaid] = tries(" --try grbl --with device=" + path_ + " --save");
  ASSERT_EQ(first, 0) << firstSaid;
  EXPECT_EQ(firstSaid.find("when this was saved"), std::string::npos);
  std::ifstream in(profile);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_NE(text.find("delay_ms = "), std::string::npos) << text;
  const auto [second, secondSaid] = tries("");
  EXPECT_EQ(second, 0) << secondSaid;
  EXPECT_NE(secondSaid.find("when this was saved"), std::string::npos) << secondSaid;
  EXPECT_TRUE(controller_.stands(100, 100));  // nothing moved
}

// Asked for, it moves both overrides and says how long that took; afterwards they stand where they stood.
TEST_F(GrblOnAPty, EffectIsMeasuredWhenAskedForAndSaved) {
  link_.reset();
  const std::string profile = folder_.file("mill.toml"), said = folder_.file("said");
  std::ofstream(profile) << "version = 1\nmachine = \"Mill\"\n";
  const std::string line = std::string(STILLCUT_CLI) + " devices --profile " + profile +
                           " --try grbl --with device=" + path_ + " --measure-effect --save >" + said;
  const int status = std::system(line.c_str());
  std::ifstream heard(said), in(profile);
  const std::string words(std::istreambuf_iterator<char>(heard), {}), text(std::istreambuf_iterator<char>(in), {});
  ASSERT_EQ(status, 0) << words;
  EXPECT_NE(words.find("ok   Measure the effect"), std::string::npos) << words;
  EXPECT_NE(text.find("effect_ms = "), std::string::npos) << text;
  EXPECT_GT(controller_.steps(), 6U) << "it moved";
  EXPECT_TRUE(controller_.stands(100, 100));
}

// Whoever ends it while it holds both at 95 %: they are back before it ends, and it does not go out again.
TEST_F(GrblOnAPty, InterruptedMeasurementOfTheEffectBringsBack) {
  link_.reset();
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    SCOPED_TRACE(number);
    const std::size_t before = controller_.steps();
    testing::Child measuring({"sh", "-c",
                              std::string("exec ") + STILLCUT_CLI + " devices --try grbl --with device=" + path_ +
                                  " --measure-effect >" + folder_.file("said")});
    ASSERT_TRUE(testing::within(Seconds(20.0), [&] { return controller_.stands(95, 95); }));
    const std::size_t out = controller_.steps() - before;
    measuring.signal(number);
    std::optional<int> status;
    ASSERT_TRUE(testing::within(Seconds(5.0), [&] { return (status = measuring.ended()).has_value(); }));
    EXPECT_TRUE(WIFEXITED(*status) && WEXITSTATUS(*status) == 3) << *status;
    EXPECT_TRUE(controller_.stands(100, 100));
    EXPECT_LE(controller_.steps() - before, 2 * out);
    std::ifstream said(folder_.file("said"));
    const std::string words(std::istreambuf_iterator<char>(said), {});
    EXPECT_NE(words.find("no   Measure the effect: interrupted"), std::string::npos) << words;
  }
}

// What the manual says of a controller without a watchdog, and what the next start makes of it.
TEST_F(GrblOnAPty, KilledProgramLeavesTheOverridesAndTheNextStartTakesThemForTheOperators) {
  link_.reset();
  {
    const testing::Commander killed([&] { return make(); });
    ASSERT_TRUE(killed.took());
    killed.signal(SIGKILL);
  }
  EXPECT_FALSE(testing::within(Seconds(0.5), [&] { return !controller_.stands(90, 90); }));
  link_ = make();
  EXPECT_FALSE(link_->describe().machineWatchdog);  // so the screen asks twice before Auto
  ASSERT_TRUE(until(valid));
  EXPECT_NEAR(seen_.operatorSpeed.value, 0.9, 1e-9);
}

}  // namespace
}  // namespace stillcut::cnc
