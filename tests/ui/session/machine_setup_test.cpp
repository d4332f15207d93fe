// The desk behind the Set up page on simulated machines and files of a folder.

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>

#include "app/session/machine_setup.h"
#include "tests/ui/support/wait_for.h"

namespace stillcut::app {
namespace {

// The demonstration's cut as a machine of its own, with its control.
config::Profile simulatedMill() {
  config::Profile profile;
  profile.cut.machine = "Simulated mill";
  profile.cut.teeth = 4;
  profile.cut.nominalSpeed = Rpm(8500.0);
  profile.source = {"simulated", {{"scenario", STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml"}}};
  profile.link = {"simulated", {}};
  return profile;
}

TEST(MachineSetup, TriesOutTheSimulatedMillStepByStep) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile = simulatedMill();
  controller.tryOut(profile, QStringLiteral("mill"));
  test::waitFor(controller, [&] { return controller.trial().size() == 5U; });
  for (const ui::TrialStep& step : controller.trial()) {
    EXPECT_EQ(step.state, ui::TrialStep::State::Good) << step.detail.toStdString();
  }
  profile.source.settings["scenario"] = "nowhere.toml";
  controller.tryOut(profile, QStringLiteral("mill"));
  test::waitFor(controller, [&] { return controller.trial().size() == 5U; });
  EXPECT_EQ(controller.trial()[0].state, ui::TrialStep::State::Bad);
  EXPECT_EQ(controller.trial()[1].state, ui::TrialStep::State::Waits);
  EXPECT_TRUE(controller.trial()[0].detail.contains(QStringLiteral("nowhere.toml")));
}

// Who chooses the simulated device on the screen knows no file of a cut.
TEST(MachineSetup, TheSimulatedDeviceNeedsNoFileToBeNamed) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile = simulatedMill();
  profile.source.settings.clear();
  const auto asked = controller.sourceSettings(profile);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_TRUE(asked[0].fallback.ends_with("demo.toml")) << "and it is shown which";
  controller.tryOut(profile, QStringLiteral("mill"));
  test::waitFor(controller, [&] { return controller.trial().size() == 5U; });
  for (const ui::TrialStep& step : controller.trial()) {
    EXPECT_EQ(step.state, ui::TrialStep::State::Good) << step.detail.toStdString();
  }
  ASSERT_TRUE(controller.save(profile, QStringLiteral("mill")).ok());
  EXPECT_EQ(controller.load(QStringLiteral("mill"))->source.settings.at("scenario"), asked[0].fallback);
}

TEST(MachineSetup, ListensToTheChosenDeviceWithoutItsMachine) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile = simulatedMill();
  profile.allowAuto = true;
  controller.listen(profile, {});
  EXPECT_EQ(controller.heard().state, ui::DevicePreview::State::Opening);
  const Snapshot* snapshot = nullptr;
  test::waitFor(controller, [&] {
    snapshot = controller.heard().snapshot;
    return snapshot != nullptr && snapshot->sensors.channels > 0 && snapshot->columnCount > 0;
  });
  EXPECT_FALSE(snapshot->machine.valid) << "no machine is spoken to";
  EXPECT_FALSE(snapshot->autoAllowed);
  EXPECT_GT(snapshot->sensors.nominalRate.value, 0.0);
  controller.stopPreview();
  EXPECT_EQ(controller.heard().state, ui::DevicePreview::State::Off);

  profile.source.settings["scenario"] = "nowhere.toml";
  controller.listen(profile, {});
  test::waitFor(controller, [&] { return controller.heard().state == ui::DevicePreview::State::Failed; });
  EXPECT_TRUE(controller.heard().problem.contains(QStringLiteral("nowhere.toml")));
}

// A device that accepts and sends nothing keeps the thread that opens it; whoever stops listening does not wait for it.
TEST(MachineSetup, StopsListeningWhileTheDeviceIsBeingOpened) {
  const int silent = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  ASSERT_EQ(::bind(silent, reinterpret_cast<sockaddr*>(&address), length), 0);
  ASSERT_EQ(::listen(silent, 1), 0);
  ASSERT_EQ(::getsockname(silent, reinterpret_cast<sockaddr*>(&address), &length), 0);
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile = simulatedMill();
  profile.link = {};
  profile.source = {"tcp",
                    {{"host", "127.0.0.1"},
                     {"port", std::to_string(ntohs(address.sin_port))},
                     {"rate_hz", "1000"},
                     {"format", "text"}}};
  profile.cut.channels = {{"x", SensorQuantity::Acceleration, 1.0, "x"}};
  controller.listen(profile, {});
  pollfd connected{silent, POLLIN, 0};
  ASSERT_EQ(::poll(&connected, 1, 10'000), 1) << "it does not even try";
  const int wire = ::accept(silent, nullptr, nullptr);
  ASSERT_GE(wire, 0);
  controller.stopPreview();
  char byte = 0;
  EXPECT_EQ(::recv(wire, &byte, 1, MSG_DONTWAIT), -1) << "closed: it was waited for";
  EXPECT_EQ(controller.heard().state, ui::DevicePreview::State::Off);
  // What is asked next of the device begins when the first has let it go.
  controller.calibrate(profile, {}, 0, QStringLiteral("1 g"), Hertz(100.0));
  EXPECT_EQ(controller.sensorTrial().state, ui::SensorTrial::State::Runs);
  ::close(wire);
  ::close(silent);
}

TEST(MachineSetup, EveryLinkSaysWhatItAsksForWithoutAWire) {
  const MachineSetup controller;
  config::Profile profile;
  profile.link.id = "linuxcnc";
  std::vector<std::string> keys;
  for (const config::SettingDecl& asked : controller.linkSettings(profile)) keys.push_back(asked.key);
  for (const char* key : {"host", "port", "hal_port", "lowest_speed_percent"}) {
    EXPECT_NE(std::find(keys.begin(), keys.end(), key), keys.end()) << key;
  }
  for (const ui::ComponentOption& link : controller.links()) {
    profile.link.id = link.id.toStdString();
    for (const config::SettingDecl& asked : controller.linkSettings(profile)) EXPECT_FALSE(asked.key.empty());
  }
}

// What a trial and a run have measured of a link goes into its profile, and into no other.
TEST(MachineSetup, MeasuredDelaysAreSavedWithTheLinkTheyAreOf) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile = simulatedMill();
  controller.measured = [&] { return LinkDelays{profile.link, {}, Seconds(0.096)}; };
  controller.tryOut(profile, QStringLiteral("mill"));
  test::waitFor(controller, [&] { return controller.trial().size() == 5U; });
  ASSERT_TRUE(controller.save(profile, QStringLiteral("mill")).ok());
  auto back = controller.load(QStringLiteral("mill"));
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(back->link.settings["effect_ms"], "96.00");
  EXPECT_TRUE(back->link.settings.contains("delay_ms"));
  profile.link = {"grbl", {{"device", "/dev/ttyUSB7"}}};
  controller.measured = nullptr;
  ASSERT_TRUE(controller.save(profile, QStringLiteral("other")).ok());
  back = controller.load(QStringLiteral("other"));
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_FALSE(back->link.settings.contains("effect_ms"));
  EXPECT_FALSE(back->link.settings.contains("delay_ms"));
}

// A machine that the run holds is not asked a second time: some go down under it.
TEST(MachineSetup, ALinkThatTheRunHoldsIsTestedByWhatTheRunTells) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile = simulatedMill();
  profile.link = {"grbl", {{"device", folder.filePath(QStringLiteral("nothing-is-here")).toStdString()}}};
  RunsLink run;
  run.label = "GRBL";
  run.state.valid = run.state.linkUp = true;
  run.state.link.roundTrip = Seconds(0.0048);
  controller.measured = [&] { return LinkDelays{profile.link, {}, {}}; };
  controller.linkTold = [&] { return std::optional(run); };
  controller.testLink(profile, QStringLiteral("mill"));
  ASSERT_EQ(controller.linkTest().state, ui::LinkTest::State::Good);
  EXPECT_EQ(controller.linkTest().steps.size(), 4U);
  EXPECT_TRUE(controller.linkTest().steps[0].said.contains(QStringLiteral("nothing more was asked")));
  ASSERT_TRUE(controller.save(profile, QStringLiteral("mill")).ok());
  EXPECT_EQ(controller.load(QStringLiteral("mill"))->link.settings["delay_ms"], "4.80");
  run.state.valid = false;
  controller.testLink(profile, QStringLiteral("mill"));
  EXPECT_EQ(controller.linkTest().state, ui::LinkTest::State::Bad);
  controller.linkTold = nullptr;
  controller.testLink(profile, QStringLiteral("mill"));
  test::waitFor(controller, [&] { return controller.linkTest().state != ui::LinkTest::State::Runs; });
  EXPECT_TRUE(controller.linkTest().steps[0].said.contains(QStringLiteral("cannot be opened")));
}

// A pure tone from a scenario's sensor cannot be had; that the way from desk to device and back is walked is seen in
// what is said of it.
TEST(MachineSetup, CalibratesAgainstTheChosenDevice) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile = simulatedMill();
  controller.calibrate(profile, {}, 0, QStringLiteral("1 g"), Hertz(40.0));
  EXPECT_EQ(controller.sensorTrial().state, ui::SensorTrial::State::Runs);
  test::waitFor(controller, [&] { return controller.sensorTrial().state != ui::SensorTrial::State::Runs; });
  EXPECT_EQ(controller.sensorTrial().state, ui::SensorTrial::State::Bad);
  EXPECT_TRUE(controller.sensorTrial().said.contains(QStringLiteral("tone")))
      << controller.sensorTrial().said.toStdString();
  controller.calibrate(profile, {}, 9, QStringLiteral("1 g"), Hertz(1000.0));
  test::waitFor(controller, [&] { return controller.sensorTrial().state != ui::SensorTrial::State::Runs; });
  EXPECT_TRUE(controller.sensorTrial().said.contains(QStringLiteral("has no channel 9")));
  controller.knock(profile, {}, 8);
  EXPECT_EQ(controller.sensorTrial().state, ui::SensorTrial::State::Runs);
  test::waitFor(controller, [&] { return controller.sensorTrial().state != ui::SensorTrial::State::Runs; });
  EXPECT_TRUE(controller.sensorTrial().said.contains(QStringLiteral("has no channel 8")));
}

TEST(MachineSetup, WhatIsBeingPutTogetherOutlivesTheProgramUntilItRuns) {
  const QTemporaryDir folder;
  {
    MachineSetup controller;
    controller.keepIn(folder.path());
    EXPECT_FALSE(controller.keptDraft().has_value());
    controller.keepDraft({});
    EXPECT_TRUE(controller.keptDraft().has_value()) << "nothing is said yet, and that can be read as well";
    controller.keepDraft(simulatedMill());
  }
  MachineSetup next;
  next.keepIn(folder.path());
  const auto kept = next.keptDraft();
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->cut.machine, "Simulated mill");
  EXPECT_EQ(kept->link.id, "simulated");
  next.begin = [](const std::string&, const std::function<void()>&) { return Status(Done{}); };
  ASSERT_TRUE(next.start(*kept, QStringLiteral("mill")).ok());
  EXPECT_FALSE(next.keptDraft().has_value()) << "it is a profile now";
}

TEST(MachineSetup, AStartThatIsRefusedSavesNothing) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  std::string seen;  // on the disk, as it begins
  controller.begin = [&](const std::string& path, const std::function<void()>& putBack) {
    const auto profile = controller.load(QFileInfo(QString::fromStdString(path)).completeBaseName());
    seen = profile ? profile->cut.machine : profile.error().line();
    putBack();
    return Status(Error{message("device"), message("cannot be opened")});
  };
  config::Profile profile = simulatedMill();
  controller.keepDraft(profile);
  EXPECT_FALSE(controller.start(profile, QStringLiteral("mill")).ok());
  EXPECT_EQ(seen, "Simulated mill");
  EXPECT_TRUE(controller.profiles().isEmpty());
  EXPECT_TRUE(controller.keptDraft().has_value()) << "what was typed is not lost";

  ASSERT_TRUE(controller.save(profile, QStringLiteral("mill")).ok());
  profile.cut.machine = "Mill 3";
  EXPECT_FALSE(controller.start(profile, QStringLiteral("mill")).ok());
  EXPECT_EQ(seen, "Mill 3");
  EXPECT_EQ(controller.load(QStringLiteral("mill"))->cut.machine, "Simulated mill");
  const QDir kept(folder.filePath(QStringLiteral("profiles")));
  EXPECT_EQ(kept.entryList(QDir::Files), QStringList{QStringLiteral("mill.toml")}) << "and no copy beside it";
}

TEST(MachineSetup, ProfilesAreKeptAndComeBack) {
  const QTemporaryDir folder;
  MachineSetup controller;
  controller.keepIn(folder.path());
  config::Profile profile;
  profile.cut.machine = "Mill 3";
  profile.source.id = "simulated";
  ASSERT_TRUE(controller.save(profile, QStringLiteral("mill3")).ok());
  EXPECT_EQ(controller.profiles(), QStringList{QStringLiteral("mill3")});
  const auto back = controller.load(QStringLiteral("mill3"));
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(back->cut.machine, "Mill 3");
  EXPECT_FALSE(controller.save(profile, QStringLiteral("../evil")).ok());
  profile.strategy = "no-such";
  EXPECT_FALSE(controller.save(profile, QStringLiteral("mill4")).ok());
  EXPECT_EQ(controller.profiles().size(), 1);
}

}  // namespace
}  // namespace stillcut::app
