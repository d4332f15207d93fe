// The desk behind the Machine tab: finding ways to a machine, and testing one by itself, on a controller at a real pty.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <stdexcept>

#include "app/io/find_machines.h"
#include "app/session/machine_setup.h"
#include "tests/support/grbl/pty_grbl.h"

namespace stillcut::app {
namespace {

using State = ui::LinkTest::State;

class LinkDeskTest : public testing::Test {
 protected:
  LinkDeskTest() {
    controller_.keepIn(folder_.path());
    profile_.cut.teeth = 4;
    profile_.cut.nominalSpeed = Rpm(8500.0);
    profile_.source = {"simulated", {{"scenario", STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml"}}};
    profile_.link = {"grbl", {{"device", path_}}};
  }
  void waitFor(const std::function<bool()>& done) {
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          controller_.poll();
          return done();
        },
        60000));
  }

  QTemporaryDir folder_;
  std::string path_ = folder_.filePath(QStringLiteral("controller")).toStdString();
  MachineSetup controller_;
  config::Profile profile_;
};

TEST_F(LinkDeskTest, TheLinkIsTestedByItselfAndItsDelaySaved) {
  const cnc::testing::PtyGrbl controller(path_);
  controller_.testLink(profile_, QStringLiteral("mill"));
  EXPECT_EQ(controller_.linkTest().state, State::Runs);
  waitFor([&] { return controller_.linkTest().state != State::Runs; });
  EXPECT_EQ(controller_.linkTest().state, State::Good);
  ASSERT_EQ(controller_.linkTest().steps.size(), 4U);
  for (const ui::LinkTest::Step& step : controller_.linkTest().steps) EXPECT_TRUE(step.good) << step.said.toStdString();
  EXPECT_TRUE(controller_.linkTest().steps[2].said.contains(QStringLiteral("ms")));
  ASSERT_TRUE(controller_.save(profile_, QStringLiteral("mill")).ok());
  auto back = controller_.load(QStringLiteral("mill"));
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_TRUE(back->link.settings.contains("delay_ms"));
}

TEST_F(LinkDeskTest, WhatIsWrongWithALinkIsTheLastStep) {
  controller_.testLink(profile_, QStringLiteral("mill"));  // nobody is there
  waitFor([&] { return controller_.linkTest().state == State::Bad; });
  ASSERT_EQ(controller_.linkTest().steps.size(), 1U);
  EXPECT_TRUE(controller_.linkTest().steps[0].said.contains(QStringLiteral("controller"))) << path_;
  profile_.link.settings["baud"] = "much";
  controller_.testLink(profile_, QStringLiteral("mill"));
  waitFor([&] { return controller_.linkTest().state == State::Bad; });
  ASSERT_EQ(controller_.linkTest().steps.size(), 1U) << "of this test alone";
  EXPECT_TRUE(controller_.linkTest().steps[0].said.contains(QStringLiteral("baud")));
}

// No failure when it was stopped, and nothing to save.
TEST_F(LinkDeskTest, ATestThatIsStoppedIsNeitherGoodNorBad) {
  const cnc::testing::PtyGrbl controller(path_);
  controller_.testLink(profile_, QStringLiteral("mill"));
  controller_.stopTest();
  waitFor([&] { return controller_.linkTest().state != State::Runs; });
  EXPECT_EQ(controller_.linkTest().state, State::Off);
  EXPECT_LT(controller_.linkTest().steps.size(), 4U);
}

TEST_F(LinkDeskTest, ASearchThatIsStoppedAsksNobodyElse) {
  const std::vector<std::string> hosts{"no.such.host.invalid"};
  const auto named = [](const std::vector<FoundMachine>& found) {
    return std::ranges::any_of(found, [](const FoundMachine& m) { return m.where == "no.such.host.invalid"; });
  };
  EXPECT_TRUE(named(findMachines(hosts, Seconds(0.2))));
  EXPECT_FALSE(named(findMachines(hosts, Seconds(0.2), [] { return true; })));
  controller_.findMachines(QStringLiteral("192.0.2.0/24 198.51.100.0/24 203.0.113.0/24"));
  controller_.stopFinding();
  waitFor([&] { return !controller_.search().runs; });
}

// Whatever the work throws: the desk is told on its own thread, and may begin anew.
TEST(BackgroundTaskTest, WorkThatThrowsIsAFailureThatIsTold) {
  BackgroundTask task;
  std::string told;
  for (int round = 0; round < 2; ++round) {
    told.clear();
    task.start(
        ui::TaskState::What::None, {},
        [](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> { throw std::runtime_error("no memory"); },
        [&told](const Error& error) { told = error.line(); });
    EXPECT_TRUE(QTest::qWaitFor([&] { return task.collect(); }, 60000));
    EXPECT_NE(told.find("no memory"), std::string::npos);
  }
}

TEST_F(LinkDeskTest, FindingEndsAndWhatIsNoHostIsASentence) {
  EXPECT_FALSE(controller_.search().done);
  controller_.findMachines(QStringLiteral("10.0.0.0/8"));
  EXPECT_TRUE(controller_.search().runs);
  waitFor([&] { return controller_.search().done; });
  EXPECT_TRUE(controller_.search().problem.contains(QStringLiteral("256")));
  controller_.findMachines(QStringLiteral("no.such.host.invalid"));
  waitFor([&] { return controller_.search().done; });
  EXPECT_TRUE(controller_.search().problem.isEmpty());
  bool named = false;
  for (const auto& place : controller_.search().places) {
    named = named || (place.where.startsWith(QStringLiteral("no.such.host")) && place.link.id.empty());
  }
  EXPECT_TRUE(named);
}

}  // namespace
}  // namespace stillcut::app
