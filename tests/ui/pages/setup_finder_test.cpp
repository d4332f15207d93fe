// Finding and testing machines on the Set up page, driven as a person would.
#include <QLineEdit>
#include <QListWidget>

#include "tests/ui/support/setup_fixture.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

TEST_F(SetupPageTest, MachinesAreFoundWhenAskedChosenTestedAndSaved) {
  openSetup();
  press("setup-machine");
  EXPECT_TRUE(told(QStringLiteral("Nothing is looked for before you ask")));
  EXPECT_FALSE(find<TouchButton>("link-test")->isEnabled()) << "no link is chosen";
  type(QStringLiteral("find-hosts"), QStringLiteral("mill, 192.168.1.0/28"));
  EXPECT_TRUE(controller_.lookedAt.isEmpty()) << "typing is not asking";
  press("find-begin");
  EXPECT_EQ(controller_.lookedAt, QStringList{QStringLiteral("mill, 192.168.1.0/28")});
  EXPECT_TRUE(told(QStringLiteral("Looking")));
  EXPECT_EQ(find<TouchButton>("find-begin")->text(), QStringLiteral("STOP"));
  controller_.finding = twoServersOfOneMill();
  controller_.changed = true;
  tick(40);
  auto* places = find<QListWidget>("found-places");
  ASSERT_EQ(places->count(), 4);
  EXPECT_FALSE(find<TouchButton>("find-use")->isEnabled());
  places->setCurrentRow(3);
  EXPECT_FALSE(find<TouchButton>("find-use")->isEnabled()) << "no machine";
  places->setCurrentRow(1);
  press("find-use");
  EXPECT_EQ(find<QLineEdit>("link-setting-host")->text(), QStringLiteral("mill"));
  EXPECT_FALSE(find<TouchButton>("link-save")->isEnabled()) << "not tested";

  press("link-test");
  EXPECT_EQ(controller_.tested.id, "linuxcnc");
  EXPECT_EQ(controller_.tested.settings.at("host"), "mill");
  EXPECT_EQ(controller_.tested.settings.at("hal_component_port"), "5008") << "found on the same host";
  EXPECT_EQ(find<TouchButton>("link-test")->text(), QStringLiteral("STOP")) << "one at a time";
  controller_.test.steps = {{QStringLiteral("Connect"), QStringLiteral("LinuxCNC answers"), true}};
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("LinuxCNC answers")));
  controller_.test.steps.push_back({QStringLiteral("Measure the delay"),
                                    QStringLiteral("a look takes 0.3 ms, and what it shows is 0.3 ms old"), true});
  controller_.test.state = LinkTest::State::Good;
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("a look takes 0.3 ms")));
  EXPECT_FALSE(find<TouchButton>("link-save")->isEnabled()) << "the profile has no name yet";
  press("setup-profile");
  type(QStringLiteral("profile-name"), QStringLiteral("mill3"));
  press("setup-machine");
  press("link-save");
  EXPECT_EQ(controller_.kept.at(QStringLiteral("mill3")).link.settings.at("host"), "mill");
  EXPECT_TRUE(told(QStringLiteral("Saved: mill3")));
}

TEST_F(SetupPageTest, FindingAndTestingCanBeStopped) {
  openSetup();
  press("setup-machine");
  press("link-linuxcnc");
  for (const char* begin : {"find-begin", "link-test"}) {
    const QString before = find<TouchButton>(begin)->text();
    press(begin);
    EXPECT_EQ(find<TouchButton>(begin)->text(), QStringLiteral("STOP"));
    press(begin);
    EXPECT_EQ(find<TouchButton>(begin)->text(), before);
    EXPECT_FALSE(controller_.finding.runs);
    EXPECT_EQ(controller_.test.state, LinkTest::State::Off);
  }
  EXPECT_EQ(controller_.lookedAt.size(), 1);
}

TEST_F(SetupPageTest, WhatFindingAndTestingDoNotGiveIsSaid) {
  openSetup();
  press("setup-machine");
  press("find-begin");
  controller_.finding = {false, true, {}, {}};
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("Nothing answers")));
  press("find-begin");
  controller_.finding = {false, true, {}, QStringLiteral("10.0.0.0/8: is more than 256 addresses")};
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("more than 256 addresses")));
  press("link-linuxcnc");
  press("link-test");
  controller_.test = {LinkTest::State::Bad,
                      {{QStringLiteral("Connect"), QStringLiteral("127.0.0.1:5007: no answer"), false}}};
  controller_.changed = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("127.0.0.1:5007: no answer")));
  EXPECT_FALSE(find<TouchButton>("link-save")->isEnabled());
  EXPECT_TRUE(find<TouchButton>("link-test")->isEnabled()) << "once more";
}

}  // namespace
}  // namespace stillcut::ui
