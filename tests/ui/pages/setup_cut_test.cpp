// What the Set up page asks of the cut: its depth, in the unit of the screen and within what a profile can hold.
#include "core/config/param_set.h"
#include "core/config/profile.h"
#include "tests/ui/support/setup_fixture.h"
#include "ui/models/setup_draft.h"

namespace stillcut::ui {
namespace {

TEST_F(SetupPageTest, TheDepthOfCutIsTypedInItsUnitAndKeptWithTheProfile) {
  runsSimulated();
  openSetup();
  press("setup-machine");
  EXPECT_TRUE(told(QStringLiteral("Depth, mm")));
  type(QStringLiteral("machine-depth"), QStringLiteral("1,5"));
  EXPECT_NEAR(controller_.begun->depth.value, 1.5e-3, 1e-12) << "with a comma as well";
  press("display");
  press("units-1");
  QCoreApplication::processEvents();
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("Depth, in")));
  EXPECT_EQ(find<QLineEdit>("machine-depth")->text(), QStringLiteral("0.059055"));
  press("setup-profile");
  type(QStringLiteral("profile-name"), QStringLiteral("mill3"));
  press("profile-start");
  EXPECT_NEAR(controller_.kept.at(QStringLiteral("mill3")).depth.value, 1.5e-3, 1e-12)
      << "looking at it rounds nothing";
  window_->showPage(QStringLiteral("setup"));
  press("setup-machine");
  type(QStringLiteral("machine-depth"), QStringLiteral("0.1"));
  EXPECT_NEAR(controller_.begun->depth.value, 2.54e-3, 1e-12);
}

TEST_F(SetupPageTest, ASpeedWithItsThousandsPartedIsNoThousandthOfIt) {
  openSetup();
  press("setup-machine");
  for (const char* const speed : {"12,000", "12 000", "12000", "12000.0", "12'000"}) {
    type(QStringLiteral("machine-speed"), QStringLiteral("1"));
    type(QStringLiteral("machine-speed"), QString::fromUtf8(speed));
    EXPECT_EQ(controller_.begun->cut.nominalSpeed, Rpm(12'000.0)) << speed;
  }
  type(QStringLiteral("machine-speed"), QStringLiteral("8500,5"));
  EXPECT_EQ(controller_.begun->cut.nominalSpeed, Rpm(8500.5)) << "a decimal comma";
}

TEST_F(SetupPageTest, ADepthOutOfRangeIsRefusedInASentenceAndAnEmptyFieldMeansNotKnown) {
  openSetup();
  press("setup-machine");
  type(QStringLiteral("machine-depth"), QStringLiteral("2"));
  for (const char* const wrong : {"2000", "-1", "0", "deep"}) {
    type(QStringLiteral("machine-depth"), QString::fromUtf8(wrong));
    EXPECT_TRUE(told(QStringLiteral("The depth was not taken"))) << wrong;
    EXPECT_NEAR(controller_.begun->depth.value, 2e-3, 1e-12) << wrong;
  }
  auto* edit = find<QLineEdit>("machine-depth");
  edit->setFocus();
  edit->selectAll();
  QTest::keyClick(edit, Qt::Key_Delete);
  QTest::keyClick(edit, Qt::Key_Return);
  EXPECT_FALSE(told(QStringLiteral("The depth was not taken")));
  EXPECT_EQ(controller_.begun->depth.value, 0.0);
}

TEST(SetupDraft, TheDepthsItTakesAreThoseAProfileHolds) {
  const config::ParamCatalog catalog;
  const auto reads = [&](double depth_mm) {
    config::Profile profile;
    profile.cut.teeth = 4;
    profile.depth = Metres(depth_mm * 1e-3);
    return config::parseProfile(config::profileText(profile, catalog), "profile.toml", catalog).ok();
  };
  EXPECT_TRUE(reads(kShallowestCut.value * 1e3));
  EXPECT_TRUE(reads(kDeepestCut.value * 1e3));
  EXPECT_FALSE(reads(kShallowestCut.value * 1e3 * 0.9));
  EXPECT_FALSE(reads(kDeepestCut.value * 1e3 * 1.001));
}

}  // namespace
}  // namespace stillcut::ui
