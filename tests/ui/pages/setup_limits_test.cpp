// The Set up page's tab of limits: typed, checked against each other, and saved in the profile.
#include "core/config/override_limits.h"
#include "tests/ui/support/setup_fixture.h"

namespace stillcut::ui {
namespace {

TEST_F(SetupPageTest, LimitsOfTheMachineAreSetOnTheScreenAndSavedInTheProfile) {
  openSetup();
  press("setup-limits");
  EXPECT_TRUE(find<QLineEdit>("gate.highest-speed")->text().isEmpty()) << "none unless somebody says so";
  EXPECT_EQ(find<QLineEdit>("gate.lowest-speed-override")->text(), QStringLiteral("50")) << "as it comes";
  type(QStringLiteral("gate.highest-speed"), QStringLiteral("12 000"));
  type(QStringLiteral("gate.lowest-speed-override"), QStringLiteral("82,5"));
  press("setup-profile");
  type(QStringLiteral("profile-name"), QStringLiteral("mill3"));
  press("profile-save");
  const config::Profile& kept = controller_.kept.at(QStringLiteral("mill3"));
  const auto limits = config::checkOverrideLimits(kept.params, kept.cut, "test");
  ASSERT_TRUE(limits) << limits.error().line();
  EXPECT_EQ(limits->fastest, Rpm(12'000.0));
  EXPECT_DOUBLE_EQ(limits->lowestSpeed.value, 0.825);
}

// Set up, LIMITS, a field, START.
TEST_F(SetupPageTest, LimitsAreInForceInFourTouchesAlsoWithoutAName) {
  controller_.kept[QStringLiteral("machine")] = {};
  runsSimulated();
  openSetup();
  EXPECT_FALSE(find<TouchButton>("setup-start")->isVisible()) << "nothing was changed";
  press("setup-limits");
  auto* edit = find<QLineEdit>("gate.highest-speed");
  edit->setFocus();
  QTest::keyClicks(edit, QStringLiteral("9000"));
  ASSERT_TRUE(find<TouchButton>("setup-start")->isVisible());
  press("setup-start");
  EXPECT_EQ(controller_.inForce, QStringLiteral("machine-2")) << "nobody's profile is written over";
  const config::Profile& kept = controller_.kept.at(QStringLiteral("machine-2"));
  EXPECT_EQ(config::checkOverrideLimits(kept.params, kept.cut, "test")->fastest, Rpm(9'000.0));
  EXPECT_EQ(window_->currentPage(), QStringLiteral("operate"));
  window_->showPage(QStringLiteral("setup"));
  EXPECT_FALSE(find<TouchButton>("setup-start")->isVisible()) << "it is in force";
}

TEST_F(SetupPageTest, AStartThatFailsSaysWhyOnTheTabOfProfiles) {
  runsSimulated();
  openSetup();
  press("setup-limits");
  type(QStringLiteral("gate.highest-speed"), QStringLiteral("9000"));
  controller_.refuse = true;
  press("setup-start");
  EXPECT_EQ(window_->currentPage(), QStringLiteral("setup"));
  EXPECT_TRUE(find<TouchButton>("setup-profile")->isChecked());
  EXPECT_TRUE(told(QStringLiteral("under our authority")));
}

TEST_F(SetupPageTest, NothingStartsWithoutTheLimitThatWasTyped) {
  runsSimulated();
  openSetup();
  press("setup-limits");
  auto* edit = find<QLineEdit>("gate.highest-speed-override");
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, QStringLiteral("9000"));
  press("setup-start");
  EXPECT_TRUE(controller_.inForce.isEmpty());
  EXPECT_TRUE(find<TouchButton>("setup-limits")->isChecked());
  EXPECT_FALSE(find<QLabel>("limits-problem")->text().isEmpty());
  type(QStringLiteral("gate.highest-speed-override"), QStringLiteral("110"));
  press("setup-start");
  EXPECT_FALSE(controller_.inForce.isEmpty());
}

TEST_F(SetupPageTest, LimitsThatCrossOrAreOutOfRangeAreSaidByTheirLabels) {
  openSetup();
  press("setup-limits");
  const auto* problem = find<QLabel>("limits-problem");
  EXPECT_TRUE(problem->text().isEmpty());
  type(QStringLiteral("gate.highest-speed"), QStringLiteral("5000"));
  type(QStringLiteral("gate.lowest-speed"), QStringLiteral("6000"));
  EXPECT_TRUE(problem->text().contains(QStringLiteral("lowest speed is not below"))) << problem->text().toStdString();
  type(QStringLiteral("gate.lowest-speed"), QStringLiteral("4000"));
  EXPECT_TRUE(problem->text().isEmpty());
  type(QStringLiteral("gate.lowest-speed-override"), QStringLiteral("300"));
  EXPECT_FALSE(problem->text().isEmpty());
  EXPECT_FALSE(problem->text().contains(QStringLiteral("gate."))) << problem->text().toStdString();
  type(QStringLiteral("gate.lowest-speed-override"), QStringLiteral("60"));
  EXPECT_TRUE(problem->text().isEmpty());
}

}  // namespace
}  // namespace stillcut::ui
