// Devices that are plugged in are listed by their makers' names on the Set up page, and taken by one touch.
#include <QComboBox>
#include <QListWidget>
#include <QTableView>

#include "tests/ui/support/setup_fixture.h"
#include "ui/models/plain_words.h"
#include "ui/shell/manual_panel.h"

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
  EXPECT_EQ(controller_.listenedTo, QStringLiteral("alsa")) << "its meter moves at once";
  expectWholePage(*window_);
  window_->showPage(QStringLiteral("operate"));
  EXPECT_TRUE(controller_.listenedTo.isEmpty()) << "let go when nobody looks";
}

TEST_F(SetupPageTest, WhereNothingIsPluggedInThatIsSaidAndThreeKitsAreNamed) {
  openSetup();
  press("setup-sensors");
  play(0.1);
  EXPECT_TRUE(told(QStringLiteral("Nothing is plugged in")));
  EXPECT_FALSE(find<TouchButton>("source-alsa")->isVisible()) << "kinds are for whoever asks for them";
  for (const char* kit : {"kit-microphone", "kit-iepe", "kit-mems"}) EXPECT_TRUE(find<TouchButton>(kit)->isVisible());
  expectWholePage(*window_);
  const int looked = controller_.lookedForDevices;
  play(3.5);
  EXPECT_GT(controller_.lookedForDevices, looked) << "what is plugged in now shows by itself";
  press("kit-iepe");
  const auto* manual = find<ManualPanel>();
  ASSERT_TRUE(manual->isVisible());
  EXPECT_TRUE(manual->chapter().toString().contains(QStringLiteral("hardware")));
  EXPECT_TRUE(manual->headingOnTop().contains(QStringLiteral("IEPE"))) << manual->headingOnTop().toStdString();
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(manual->isVisible());
  press("device-other");
  EXPECT_TRUE(find<TouchButton>("source-alsa")->isVisible());
}

TEST_F(SetupPageTest, AnExampleThatComesWithTheProgramIsOffered) {
  openSetup();
  press("setup-profile");
  auto* list = find<QListWidget>("profiles");
  ASSERT_EQ(list->count(), 1);
  list->setCurrentRow(0);
  press("profile-load");
  EXPECT_EQ(find<QLineEdit>("profile-name")->text(), QStringLiteral("microphone"));
  ASSERT_TRUE(controller_.begun);
  EXPECT_EQ(controller_.begun->cut.machine, "Mill in bay 1");
}

TEST(PlainWords, NoKeyOfAFileStandsInASentence) {
  EXPECT_EQ(withoutKeys(QStringLiteral("A sound card: device, rate_hz, bits, inputs")), QStringLiteral("A sound card"));
  EXPECT_EQ(withoutKeys(QStringLiteral("A recording: what it heard")), QStringLiteral("A recording: what it heard"));
  const QString said = plainWords(QStringLiteral("source 'iio': rate_hz is missing (0 [[channels]] in the profile)"));
  EXPECT_FALSE(said.contains(u'_') || said.contains(QStringLiteral("[["))) << said.toStdString();
  EXPECT_TRUE(said.contains(QStringLiteral("Rate"))) << said.toStdString();
}

TEST_F(SetupPageTest, AQuantityIsChosenFromAList) {
  config::Profile kept;
  kept.cut.channels = {{"left", SensorQuantity::Acceleration, 1.0, "x"}};
  controller_.begun = kept;
  openSetup();
  press("setup-sensors");
  play(0.1);
  auto* table = find<QTableView>("channels");
  table->edit(table->model()->index(0, 1));
  auto* box = table->findChild<QComboBox*>(QStringLiteral("channel-quantity"));
  ASSERT_NE(box, nullptr);
  EXPECT_GE(box->width(), box->sizeHint().width());
  const int row = box->findData(QStringLiteral("sound"));
  ASSERT_GE(row, 0);
  box->setCurrentIndex(row);
  emit box->activated(row);
  EXPECT_EQ(controller_.begun->cut.channels[0].quantity, SensorQuantity::Sound);
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
