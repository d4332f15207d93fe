// The Set up page, driven as a person would, and its models.
#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QTableView>

#include "tests/ui/support/setup_fixture.h"
#include "ui/models/setup_draft.h"
#include "ui/pages/setup/setup_page.h"
#include "ui/plots/level_spectrum.h"

namespace stillcut::ui {
namespace {

TEST_F(SetupPageTest, TheGuideEndsInAPictureThatMoves) {
  openSetup();
  press("guide-simulated");
  EXPECT_EQ(controller_.demonstrations, 1);
  EXPECT_EQ(window_->currentPage(), QStringLiteral("operate"));
}

TEST_F(SetupPageTest, AMachineIsPutTogetherTriedSavedAndStarted) {
  openSetup();
  EXPECT_EQ(find<TouchButton>("guide-machine")->hint(), QStringLiteral("still open"));
  press("guide-machine");
  type(QStringLiteral("machine-name"), QStringLiteral("Mill 3"));
  type(QStringLiteral("machine-speed"), QStringLiteral("8500"));
  type(QStringLiteral("machine-feed"), QStringLiteral("2720"));
  press("link-linuxcnc");
  ASSERT_NE(find<QLineEdit>("link-setting-host"), nullptr);
  type(QStringLiteral("link-setting-host"), QStringLiteral("192.168.1.20"));
  press("link-setting-adaptive_feed-true");
  press("link-setting-restore-hundred");
  press("setup-sensors");
  pressKind("source-alsa");
  press("channel-add");
  press("setup-tools");
  press("tool-new");
  type(QStringLiteral("tool-name"), QStringLiteral("T12 D12 Z4"));
  type(QStringLiteral("tool-teeth"), QStringLiteral("4"));
  type(QStringLiteral("tool-diameter"), QStringLiteral("12,0"));
  press("tool-use");
  press("setup-profile");
  press("detector-coherence");
  press("strategy-stable-pocket");
  type(QStringLiteral("profile-name"), QStringLiteral("mill3"));
  press("profile-try");
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("25600 Hz")));
  EXPECT_TRUE(told(QStringLiteral("connection refused")));
  press("profile-start");
  EXPECT_EQ(controller_.inForce, QStringLiteral("mill3"));
  EXPECT_EQ(window_->currentPage(), QStringLiteral("operate"));

  const config::Profile& kept = controller_.kept.at(QStringLiteral("mill3"));
  EXPECT_EQ(kept.cut.machine, "Mill 3");
  EXPECT_DOUBLE_EQ(kept.cut.nominalSpeed.value, 8500.0);
  EXPECT_NEAR(kept.cut.nominalFeed.value, 2.72 / 60.0, 1e-9);
  EXPECT_EQ(kept.link.id, "linuxcnc");
  EXPECT_EQ(kept.link.settings.at("host"), "192.168.1.20");
  EXPECT_EQ(kept.link.settings.at("adaptive_feed"), "true");
  EXPECT_EQ(kept.link.settings.at("restore"), "hundred");
  EXPECT_FALSE(kept.link.settings.contains("port")) << "what is as usual is not written";
  EXPECT_EQ(kept.source.id, "alsa");
  ASSERT_EQ(kept.cut.channels.size(), 1U);
  EXPECT_EQ(kept.cut.teeth, 4);
  EXPECT_NEAR(kept.cut.toolDiameter.value, 12e-3, 1e-12);
  EXPECT_EQ(kept.detector, "coherence");
  EXPECT_EQ(kept.strategy, "stable-pocket");
  EXPECT_FALSE(kept.allowAuto) << "nobody said so";
}

// What is shown is rounded: looking at a field, and leaving it, changes nothing.
TEST_F(SetupPageTest, FeedAndDiameterAreShownAndTypedInInches) {
  runsSimulated();
  openSetup();
  press("setup-machine");
  type(QStringLiteral("machine-feed"), QStringLiteral("2720"));
  press("setup-tools");
  press("tool-new");
  type(QStringLiteral("tool-diameter"), QStringLiteral("12"));
  press("tool-use");
  press("display");
  press("units-1");
  QCoreApplication::processEvents();
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("Diameter, in")));
  EXPECT_EQ(find<QLineEdit>("tool-diameter")->text(), QStringLiteral("0.47244"));
  press("tool-use");
  press("setup-machine");
  auto* feed = find<QLineEdit>("machine-feed");
  EXPECT_EQ(feed->text(), QStringLiteral("107.1"));
  feed->setFocus();
  find<QLineEdit>("machine-name")->setFocus();
  press("setup-profile");
  type(QStringLiteral("profile-name"), QStringLiteral("mill4"));
  press("profile-start");
  EXPECT_NEAR(controller_.kept.at(QStringLiteral("mill4")).cut.nominalFeed.value, 2.72 / 60.0, 1e-12);
  EXPECT_NEAR(controller_.kept.at(QStringLiteral("mill4")).cut.toolDiameter.value, 12e-3, 1e-15);

  window_->showPage(QStringLiteral("setup"));
  press("setup-machine");
  type(QStringLiteral("machine-feed"), QStringLiteral("100"));
  press("setup-tools");
  type(QStringLiteral("tool-diameter"), QStringLiteral("0.5"));
  press("tool-use");
  press("setup-profile");
  press("profile-start");
  EXPECT_NEAR(controller_.kept.at(QStringLiteral("mill4")).cut.nominalFeed.value, 100 * 25.4e-3 / 60.0, 1e-12);
  EXPECT_NEAR(controller_.kept.at(QStringLiteral("mill4")).cut.toolDiameter.value, 12.7e-3, 1e-12);
}

TEST_F(SetupPageTest, ARefusedStartSaysWhyAndStays) {
  runsSimulated();
  openSetup();
  controller_.refuse = true;
  press("setup-profile");
  type(QStringLiteral("profile-name"), QStringLiteral("mill3"));
  press("profile-start");
  EXPECT_TRUE(told(QStringLiteral("set it to Off first")));
  EXPECT_EQ(window_->currentPage(), QStringLiteral("setup"));
}

TEST_F(SetupPageTest, AStartWithoutADeviceNamesWhereToChooseOneAndSavesNothing) {
  openSetup();
  press("setup-machine");
  type(QStringLiteral("machine-name"), QStringLiteral("Mill 3"));
  press("setup-start");
  EXPECT_TRUE(controller_.inForce.isEmpty());
  EXPECT_TRUE(controller_.kept.empty());
  EXPECT_TRUE(find<TouchButton>("setup-profile")->isChecked());
  EXPECT_TRUE(told(QStringLiteral("choose one under SENSORS")));
  press("profile-try");
  EXPECT_TRUE(controller_.steps.empty()) << "there is nothing to try";
  press("profile-start");
  EXPECT_TRUE(controller_.kept.empty());
  press("setup-sensors");
  pressKind("source-alsa");
  press("setup-start");
  EXPECT_EQ(controller_.kept.size(), 1U);
}

TEST_F(SetupPageTest, SensorsShowLevelAndSpectrumAndSayWhenTheyAreSick) {
  openSetup();
  press("setup-sensors");
  play(0.4);
  EXPECT_TRUE(find<LevelSpectrum>()->alive());
  EXPECT_TRUE(told(QStringLiteral("Sensor in order")));
  session_.snapshot().verdicts[0].valid = false;
  session_.snapshot().verdicts[0].reason = {ReasonCode::InputDead, {0.0}};
  session_.touch();
  tick(40);
  EXPECT_FALSE(told(QStringLiteral("Sensor in order")));
}

// Everything the sample path knows of its sensors, channel by channel.
TEST_F(SetupPageTest, SensorsTellLevelFindingAndRateOfEveryChannel) {
  openSetup();
  press("setup-sensors");
  SensorStatus& sensors = session_.snapshot().sensors;
  sensors.channels = static_cast<int>(session_.info().setup.channels.size());
  ASSERT_GE(sensors.channels, 1);
  sensors.channel[0] = {3.1, 12.0, 0.0, {}};
  sensors.nominalRate = Hertz(25600);
  sensors.actualRate = Hertz(25498);
  sensors.actualRateSd = Hertz(4);
  sensors.lostFrames = 512;
  session_.touch();
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("peak 12")));
  EXPECT_TRUE(told(QStringLiteral("498\u00a0\u00b14\u00a0Hz measured, 512 samples lost")));
  sensors.channel[0].fault = {ReasonCode::InputLoose, {0.0}};
  sensors.fault = {ReasonCode::InputRate, {25498.0, 25600.0}};
  session_.touch();
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("its sensor is loose")));
  EXPECT_TRUE(told(QStringLiteral("instead of")));
}

TEST_F(SetupPageTest, TheChosenDeviceIsListenedToBesideTheCutAndLetGo) {
  openSetup();
  press("setup-sensors");
  EXPECT_FALSE(find<TouchButton>("device-listen")->isEnabled()) << "no device is chosen";
  pressKind("source-alsa");
  press("device-listen");
  EXPECT_EQ(controller_.listenedTo, QStringLiteral("alsa"));
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("THE CHOSEN DEVICE")));
  EXPECT_TRUE(told(QStringLiteral("Opening the device")));

  SessionInfo info = session_.info();
  info.setup.channels = {{"mic", SensorQuantity::Sound, 1.0, ""}};
  Snapshot heard = session_.snapshot();
  heard.sensors.channels = 1;
  heard.sensors.channel[0] = {0.5, 2.0, 0.0, {}};
  controller_.ears = {DevicePreview::State::Running, &info, &heard, {}};
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("mic: 0.50")));
  EXPECT_TRUE(find<LevelSpectrum>()->alive());
  tick(2000);
  EXPECT_TRUE(told(QStringLiteral("No samples come"))) << "a picture that stands still is not shown as live";

  controller_.ears = {DevicePreview::State::Failed, nullptr, nullptr, QStringLiteral("hw:1: busy")};
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("hw:1: busy")));
  press("device-listen");
  EXPECT_EQ(controller_.listenedTo, QStringLiteral("alsa")) << "tried once more";
  press("setup-tools");
  EXPECT_TRUE(controller_.listenedTo.isEmpty()) << "nobody looks: the device is free";

  press("setup-sensors");
  tick(40);
  press("device-listen");
  EXPECT_EQ(controller_.listenedTo, QStringLiteral("alsa"));
  pressKind("source-simulated");
  EXPECT_TRUE(controller_.listenedTo.isEmpty()) << "it is not the chosen device any more";
}

TEST_F(SetupPageTest, JoinedDevicesTellHowWellTheyAreAligned) {
  openSetup();
  press("setup-sensors");
  controller_.ears.clocks = {{2, Hertz(25598.7), Seconds(4.2e-6)}};
  session_.touch();
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("Joined device, 2 channels")));
  EXPECT_TRUE(told(QStringLiteral("steady within 4.2")));
}

TEST_F(SetupPageTest, ACalibratorSetsTheChosenChannelRight) {
  openSetup();
  press("setup-sensors");
  EXPECT_FALSE(find<TouchButton>("calibrator-begin")->isEnabled()) << "no device is chosen";
  pressKind("source-alsa");
  press("channel-add");
  press("channel-add");
  find<QTableView>("channels")->setCurrentIndex(find<QTableView>("channels")->model()->index(1, 0));
  find<QLineEdit>("calibrator-level")->setText(QStringLiteral("1 g"));
  find<QLineEdit>("calibrator-frequency")->setText(QStringLiteral("159,2"));
  press("calibrator-begin");
  EXPECT_EQ(controller_.calibrated, QStringLiteral("1 1 g 159.2"));
  EXPECT_FALSE(find<TouchButton>("calibrator-begin")->isEnabled()) << "one at a time";
  EXPECT_TRUE(told(QStringLiteral("Listening to the calibrator")));
  controller_.askedByHand.found.front().second.scale = 98.7;
  controller_.askedByHand.state = SensorTrial::State::Good;
  controller_.askedByHand.said = QStringLiteral("y: a tone of 159.2 Hz");
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("a tone of 159.2 Hz")));
  press("setup-profile");
  find<QLineEdit>("profile-name")->setText(QStringLiteral("mill"));
  press("profile-save");
  ASSERT_EQ(controller_.kept[QStringLiteral("mill")].cut.channels.size(), 2U);
  EXPECT_EQ(controller_.kept[QStringLiteral("mill")].cut.channels[1].scale, 98.7);
  EXPECT_NE(controller_.kept[QStringLiteral("mill")].cut.channels[0].scale, 98.7);
}

TEST_F(SetupPageTest, KnocksExchangeTheAxes) {
  openSetup();
  press("setup-sensors");
  pressKind("source-alsa");
  press("channel-add");
  press("channel-add");
  QAbstractItemModel* channels = find<QTableView>("channels")->model();
  find<QTableView>("channels")->setCurrentIndex(channels->index(1, 0));
  EXPECT_TRUE(find<TouchButton>("knock-begin")->isEnabled());
  press("knock-begin");
  EXPECT_EQ(controller_.knockedAlong, 1);
  EXPECT_FALSE(find<TouchButton>("calibrator-begin")->isEnabled()) << "one at a time";
  EXPECT_TRUE(told(QStringLiteral("Knock along")));
  ChannelInfo first = controller_.askedByHand.found.front().second, second = first;
  first.axis = "y";
  second.axis = "x";
  controller_.askedByHand = {
      SensorTrial::State::Good, QStringLiteral("'x' and 'y' are exchanged"), {{0, first}, {1, second}}};
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("are exchanged")));
  press("setup-profile");
  find<QLineEdit>("profile-name")->setText(QStringLiteral("mill"));
  press("profile-save");
  ASSERT_EQ(controller_.kept[QStringLiteral("mill")].cut.channels.size(), 2U);
  EXPECT_EQ(controller_.kept[QStringLiteral("mill")].cut.channels[0].axis, "y");
  EXPECT_EQ(controller_.kept[QStringLiteral("mill")].cut.channels[1].axis, "x");
}

TEST_F(SetupPageTest, WhatTheCalibratorCannotSayIsASentence) {
  openSetup();
  press("setup-sensors");
  pressKind("source-alsa");
  press("channel-add");
  find<QLineEdit>("calibrator-frequency")->setText(QStringLiteral("much"));
  press("calibrator-begin");
  EXPECT_TRUE(controller_.calibrated.isEmpty());
  EXPECT_TRUE(told(QStringLiteral("The frequency is no number")));
  find<QLineEdit>("calibrator-frequency")->setText(QStringLiteral("1000"));
  press("calibrator-begin");
  controller_.askedByHand = {SensorTrial::State::Bad, QStringLiteral("no tone within 5 % of 1000 Hz"), {}};
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("no tone within 5 %")));
}

TEST(SetupModels, PassTheModelTester) {
  SetupDraft draft;
  ChannelModel channels(draft);
  ToolModel tools;
  const auto fatal = QAbstractItemModelTester::FailureReportingMode::Fatal;
  const QAbstractItemModelTester a(&channels, fatal), b(&tools, fatal);
  channels.add();
  channels.add();
  EXPECT_TRUE(channels.setData(channels.index(0, ChannelModel::Quantity), QStringLiteral("force")));
  EXPECT_TRUE(channels.setData(channels.index(0, ChannelModel::Scale), QStringLiteral("9,81")));
  for (const char* wrong : {"0", "nan", "much"}) {
    EXPECT_FALSE(channels.setData(channels.index(0, ChannelModel::Scale), QString::fromLatin1(wrong))) << wrong;
  }
  EXPECT_FALSE(channels.setData(channels.index(0, ChannelModel::Quantity), QStringLiteral("colour")));
  EXPECT_DOUBLE_EQ(draft.profile().cut.channels[0].scale, 9.81);
  channels.remove(1);
  EXPECT_EQ(channels.rowCount(), 1);
  tools.add({});
  tools.add({});
  tools.remove(0);
  EXPECT_EQ(tools.rowCount(), 1);
}

TEST(SetupModels, SettingsAreLabelledByTheirKeys) {
  EXPECT_EQ(settingLabel("hal_port"), QStringLiteral("Hal port"));
  EXPECT_EQ(settingLabel("lowest_speed_percent"), QStringLiteral("Lowest speed [%]"));
}

class SetupPictures : public SetupPageTest, public testing::WithParamInterface<PageLook> {};

TEST_P(SetupPictures, EveryTabFits) {
  ToolEntry tool;
  tool.name = QStringLiteral("T12 D12 Z4 R0.5");
  tool.holder = QStringLiteral("HSK63 shrink-fit, stick-out 48");
  tool.teeth = 4;
  tool.diameter_mm = 12.0;
  tool.chattered = {{8800.0, 1.5, 1713.0, QStringLiteral("slot, first pass")}};
  controller_.shop = {tool};
  controller_.kept[QStringLiteral("mill3")] = {};
  openSetup(GetParam().width, GetParam().height, GetParam().theme);
  savePage(*window_, "setup", GetParam(), "guide");
  press("setup-machine");
  press("link-linuxcnc");
  controller_.finding = twoServersOfOneMill();
  controller_.test = {
      LinkTest::State::Good,
      {{QStringLiteral("Connect"), QStringLiteral("LinuxCNC answers"), true},
       {QStringLiteral("Read the machine"),
        QStringLiteral("program running; spindle 8000 rpm, programmed 8000; overrides 100 % speed, 100 % feed"), true},
       {QStringLiteral("Measure the delay"), QStringLiteral("a look takes 0.3 ms, and what it shows is 0.3 ms old"),
        true},
       {QStringLiteral("What it can do"),
        QStringLiteral(
            "speed 50 to 150 %, feed 0 to 150 %; the machine goes back by itself when nothing comes from here"),
        true}}};
  controller_.changed = true;
  play(0.4);
  savePage(*window_, "setup", GetParam(), "machine");
  press("setup-sensors");
  pressKind("source-simulated");
  press("channel-add");
  play(0.1);
  savePage(*window_, "setup", GetParam(), "sensors");
  press("setup-tools");
  play(0.1);
  savePage(*window_, "setup", GetParam(), "tools");
  press("setup-recording");
  press("record-every");
  press("record-mode-around-events");
  controller_.recording = {QStringLiteral("/home/mill/recordings/Housing 7/T12/2026-11-22_08-30-00.h5"),
                           RecordingNow::State::Writes, 2, QStringLiteral("/rec/2026-08-01_10-00-00.h5")};
  play(0.1);
  savePage(*window_, "setup", GetParam(), "recording");
  press("setup-profile");
  press("profile-try");
  play(0.1);
  savePage(*window_, "setup", GetParam(), "profile");
}

INSTANTIATE_TEST_SUITE_P(Looks, SetupPictures, testing::ValuesIn(kPageLooks), lookName);

}  // namespace
}  // namespace stillcut::ui
