// Devices that are plugged in are listed by their makers' names on the Set up page, and taken by one touch.
#include <QTableView>

#include "tests/ui/support/setup_fixture.h"

namespace stillcut::ui {
namespace {

FoundDevice microphone() {
  return {QStringLiteral("USB measurement microphone"),
          QStringLiteral("1 channels, 48000 Hz, 24 bits"),
          {"alsa", {{"device", "hw:CARD=UMIK,DEV=0"}}},
          {"microphone", SensorQuantity::Sound, 1.0, ""}};
}

TEST_F(SetupPageTest, AMicrophoneThatIsPluggedInIsTakenByOneTouch) {
  controller_.pluggedIn = {microphone()};
  openSetup();
  press("setup-sensors");
  play(0.1);
  EXPECT_EQ(controller_.lookedForDevices, 1) << "when somebody looks, and not before";
  auto* button = find<TouchButton>("device-found-0");
  ASSERT_NE(button, nullptr);
  EXPECT_EQ(button->text(), QStringLiteral("USB measurement microphone"));
  EXPECT_TRUE(button->hint().contains(QStringLiteral("48000"))) << button->hint().toStdString();
  EXPECT_FALSE(button->isChecked());
  press("device-found-0");
  EXPECT_TRUE(button->isChecked());
  ASSERT_TRUE(controller_.begun);
  EXPECT_EQ(controller_.begun->source.id, "alsa");
  EXPECT_EQ(controller_.begun->source.settings.at("device"), "hw:CARD=UMIK,DEV=0");
  ASSERT_EQ(controller_.begun->cut.channels.size(), 1U);
  EXPECT_EQ(controller_.begun->cut.channels[0].quantity, SensorQuantity::Sound);
  press("device-listen");
  EXPECT_EQ(controller_.listenedTo, QStringLiteral("alsa"));
  expectWholePage(*window_);
  window_->showPage(QStringLiteral("operate"));
  EXPECT_TRUE(controller_.listenedTo.isEmpty()) << "let go when nobody looks";
}

TEST_F(SetupPageTest, ChannelsOfItsKindThatWereSetUpStay) {
  config::Profile kept;
  kept.cut.channels = {{"left", SensorQuantity::Sound, 0.02, ""}, {"right", SensorQuantity::Sound, 0.02, ""}};
  controller_.begun = kept;
  openSetup();
  press("setup-sensors");
  play(0.1);
  EXPECT_EQ(find<TouchButton>("device-found-0"), nullptr) << "nothing is plugged in";
  controller_.pluggedIn = {microphone()};
  controller_.changed = true;
  play(0.1);
  press("device-found-0");
  EXPECT_EQ(controller_.begun->cut.channels.size(), 2U);
}

}  // namespace
}  // namespace stillcut::ui
