// The shop's tools on the Set up page, driven as a person would: what goes into the profile, and what is never lost.
#include <QLineEdit>
#include <QListView>

#include "core/config/override_limits.h"
#include "tests/ui/support/setup_fixture.h"
#include "ui/models/setup_draft.h"

namespace stillcut::ui {
namespace {

// The gate, which has the last word, reads it from the profile; so does the diagram.
TEST_F(SetupPageTest, SpeedPitchAndModesOfAToolGoIntoTheProfileAndLeaveWithIt) {
  ToolEntry measured;
  measured.name = QStringLiteral("T12 D12 Z4");
  measured.teeth = 4;
  measured.pitch = QStringLiteral("80 100 80,0 100");
  measured.modes = QStringLiteral("t12.toml");
  measured.highestSpeed_rpm = 8000.0;
  ToolEntry plain;
  plain.name = QStringLiteral("T3 D6 Z2");
  controller_.shop = {measured, plain};
  openSetup();
  const auto saved = [this] {
    press("setup-profile");
    type(QStringLiteral("profile-name"), QStringLiteral("mill3"));
    press("profile-save");
    return controller_.kept.at(QStringLiteral("mill3"));
  };
  press("setup-tools");
  press("tool-use");
  const config::Profile with = saved();
  EXPECT_EQ(with.model, "t12.toml");
  EXPECT_EQ(with.pitch, (std::vector<double>{80.0, 100.0, 80.0, 100.0}));
  const auto limits = config::checkOverrideLimits(with.params, with.cut, "test");
  ASSERT_TRUE(limits.ok()) << limits.error().line();
  EXPECT_EQ(limits->fastest, Rpm(8000.0));
  press("setup-tools");
  auto* list = find<QListView>("tools");
  list->setCurrentIndex(list->model()->index(1, 0));
  press("tool-use");
  const config::Profile without = saved();
  EXPECT_EQ(without.model, "") << "the modes of this one are not known";
  EXPECT_TRUE(without.pitch.empty());
  EXPECT_TRUE(without.params.isAutomatic(config::kToolSpeed)) << "no limit is said of this one";
}

// What is learned of a tool is found again by these.
TEST_F(SetupPageTest, AToolThatSticksOutOtherwiseIsAnotherTool) {
  ToolEntry tool;
  tool.name = QStringLiteral("T12");
  tool.holder = QStringLiteral("HSK63 shrink-fit");
  tool.stickOut_mm = 60.5;
  SetupDraft draft;
  draft.useTool(tool);
  EXPECT_EQ(draft.profile().cut.tool, "T12");
  EXPECT_EQ(draft.profile().holder, "HSK63 shrink-fit");
  EXPECT_NEAR(draft.profile().stickOut.value, 60.5e-3, 1e-12);
  tool.holder.clear();
  tool.stickOut_mm = 0.0;
  draft.useTool(tool);
  EXPECT_TRUE(draft.profile().holder.empty());
  EXPECT_EQ(draft.profile().stickOut.value, 0.0) << "not that of the tool before";
}

TEST_F(SetupPageTest, APitchThatDoesNotGoOnceAroundIsNotKept) {
  ToolEntry tool;
  tool.name = QStringLiteral("T12 D12 Z4");
  tool.teeth = 4;
  tool.highestSpeed_rpm = 8000.0;
  controller_.shop = {tool};
  openSetup();
  press("setup-tools");
  for (const char* wrong : {"90 90 90", "90 90 90 80", "90 90 90 x"}) {
    type(QStringLiteral("tool-pitch"), QString::fromLatin1(wrong));
    press("tool-save");
    EXPECT_TRUE(told(QStringLiteral("one angle per tooth"))) << wrong;
    EXPECT_EQ(controller_.shop[0].pitch, QString());
  }
  type(QStringLiteral("tool-pitch"), QStringLiteral("85 95 85 95"));
  type(QStringLiteral("tool-limit"), QStringLiteral("8k"));
  press("tool-save");
  EXPECT_EQ(controller_.shop[0].pitch, QStringLiteral("85 95 85 95"));
  EXPECT_EQ(controller_.shop[0].highestSpeed_rpm, 8000.0) << "what is no number takes no limit away";
}

TEST_F(SetupPageTest, ARemovedToolIsPutBackWhereItWas) {
  ToolEntry first, second;
  first.name = QStringLiteral("T1");
  second.name = QStringLiteral("T2");
  first.highestSpeed_rpm = 9000.0;
  controller_.shop = {first, second};
  openSetup();
  press("setup-tools");
  EXPECT_FALSE(find<TouchButton>("tool-put-back")->isVisible());
  press("tool-remove");
  EXPECT_EQ(controller_.shop, std::vector<ToolEntry>{second});
  press("tool-put-back");
  EXPECT_EQ(controller_.shop, (std::vector<ToolEntry>{first, second}));
  EXPECT_EQ(find<QLineEdit>("tool-limit")->text(), QStringLiteral("9000"));
  EXPECT_FALSE(find<TouchButton>("tool-put-back")->isVisible());
}

TEST_F(SetupPageTest, WhatWasTypedOfAToolWaitsWhileAnotherIsLookedAt) {
  ToolEntry first, second;
  first.name = QStringLiteral("T1");
  second.name = QStringLiteral("T2");
  controller_.shop = {first, second};
  openSetup();
  press("setup-tools");
  auto* list = find<QListView>("tools");
  type(QStringLiteral("tool-holder"), QStringLiteral("HSK63"));
  list->setCurrentIndex(list->model()->index(1, 0));
  EXPECT_EQ(find<QLineEdit>("tool-holder")->text(), QString());
  EXPECT_FALSE(told(QStringLiteral("Not kept yet")));
  list->setCurrentIndex(list->model()->index(0, 0));
  EXPECT_EQ(find<QLineEdit>("tool-holder")->text(), QStringLiteral("HSK63"));
  EXPECT_TRUE(told(QStringLiteral("Not kept yet")));
  EXPECT_EQ(controller_.shop[0].holder, QString()) << "and nothing is kept that nobody asked to keep";
  press("tool-save");
  EXPECT_EQ(controller_.shop[0].holder, QStringLiteral("HSK63"));
  EXPECT_FALSE(told(QStringLiteral("Not kept yet")));
}

TEST_F(SetupPageTest, ToolsRememberWhereTheyChattered) {
  ToolEntry tool;
  tool.name = QStringLiteral("T3 D6 Z2");
  controller_.shop = {tool};
  openSetup();
  press("setup-tools");
  EXPECT_FALSE(find<TouchButton>("tool-chattered")->isEnabled());
  while (session_.snapshot().verdicts[0].state != CutState::Chatter) play(0.04);
  press("tool-chattered");
  ASSERT_EQ(controller_.shop[0].chattered.size(), 1U);
  EXPECT_NEAR(controller_.shop[0].chattered[0].speed_rpm, 8800.0, 50.0);
  EXPECT_GT(controller_.shop[0].chattered[0].frequency_hz, 1000.0);
  EXPECT_TRUE(told(QStringLiteral("Chattered at")));
}

TEST_F(SetupPageTest, AFileThatHoldsNoModesIsRefusedWhereItIsChosenAndAGoodOneGoesIntoTheHistory) {
  ToolEntry tool;
  tool.name = QStringLiteral("T12 D12 Z4");
  controller_.shop = {tool};
  openSetup();
  press("setup-tools");
  type(QStringLiteral("tool-modes"), QStringLiteral("letter.doc"));
  press("tool-save");
  EXPECT_TRUE(told(QStringLiteral("letter.doc: holds no [[mode]]")));
  EXPECT_EQ(controller_.shop[0].modes, QString());
  type(QStringLiteral("tool-modes"), QStringLiteral("modes/T12.toml"));
  type(QStringLiteral("tool-stick-out"), QStringLiteral("48"));
  type(QStringLiteral("tool-slowest"), QStringLiteral("4000"));
  type(QStringLiteral("tool-limit"), QStringLiteral("3000"));
  press("tool-save");
  EXPECT_TRUE(told(QStringLiteral("lies above the highest")));
  type(QStringLiteral("tool-limit"), QStringLiteral("12000"));
  press("tool-save");
  const ToolEntry& kept = controller_.shop[0];
  EXPECT_EQ(kept.modes, QStringLiteral("modes/T12.toml"));
  EXPECT_DOUBLE_EQ(kept.stickOut_mm, 48.0);
  EXPECT_DOUBLE_EQ(kept.lowestSpeed_rpm, 4000.0);
  ASSERT_EQ(kept.history.size(), 1U);
  EXPECT_TRUE(kept.history[0].what.contains(QStringLiteral("modes/T12.toml")));
}

}  // namespace
}  // namespace stillcut::ui
