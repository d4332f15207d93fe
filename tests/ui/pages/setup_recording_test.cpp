// The Set up page's tab of recordings: what is chosen there is saved in the profile, and what is recorded now is told.
#include "tests/ui/support/setup_fixture.h"

namespace stillcut::ui {
namespace {

TEST_F(SetupPageTest, RecordingIsChosenOnTheScreenAndSavedInTheProfile) {
  openSetup();
  press("setup-recording");
  const auto visible = [this](const char* field) { return find<QLineEdit>(field)->isVisible(); };
  EXPECT_FALSE(visible("record.before")) << "continuous: there is no before";
  type(QStringLiteral("record-operator"), QStringLiteral("Ada"));
  type(QStringLiteral("record-job"), QStringLiteral("Housing 7"));
  press("record-every");
  EXPECT_EQ(find<QLineEdit>("record-folder")->text(), QStringLiteral("/home/mill/recordings"));
  press("record-mode-features");
  EXPECT_TRUE(visible("record.history"));
  EXPECT_EQ(find<QLineEdit>("record.history")->text(), QStringLiteral("24"));
  press("record-mode-around-events");
  EXPECT_TRUE(visible("record.before"));
  EXPECT_FALSE(visible("record.history"));
  EXPECT_EQ(find<QLineEdit>("record.before")->text(), QStringLiteral("30")) << "as it comes";
  EXPECT_EQ(find<QLineEdit>("record.after")->text(), QStringLiteral("30"));
  type(QStringLiteral("record.before"), QStringLiteral("12,5"));
  type(QStringLiteral("record.keep-days"), QStringLiteral("30"));
  type(QStringLiteral("record.keep-size"), QStringLiteral("20"));
  EXPECT_TRUE(told(QStringLiteral("Housing 7/")));
  type(QStringLiteral("record.after"), QStringLiteral("0"));
  EXPECT_TRUE(told(QStringLiteral("Kept after an event"))) << "out of its range, and said so";
  press("setup-profile");
  type(QStringLiteral("profile-name"), QStringLiteral("mill3"));
  press("profile-save");

  const config::Profile& kept = controller_.kept.at(QStringLiteral("mill3"));
  EXPECT_EQ(kept.operatorName, "Ada");
  EXPECT_EQ(kept.recording.job, "Housing 7");
  EXPECT_EQ(kept.recording.folder, "/home/mill/recordings");
  const record::RecordPlan plan = record::recordPlan(kept.params);
  EXPECT_EQ(plan.mode, record::RecordMode::AroundEvents);
  EXPECT_DOUBLE_EQ(plan.before.value, 12.5);
  EXPECT_DOUBLE_EQ(plan.after.value, 30.0) << "what is wrong changes nothing";
  EXPECT_DOUBLE_EQ(plan.keepFor.value, 30.0 * 86'400.0);
  EXPECT_EQ(plan.keepBytes, 20'000'000'000U);
  press("setup-recording");
  press("record-every");
  EXPECT_TRUE(find<QLineEdit>("record-folder")->text().isEmpty());
}

TEST_F(SetupPageTest, WhatIsRecordedNowIsToldWithWhatHadToGo) {
  openSetup();
  press("setup-recording");
  play(0.1);
  EXPECT_TRUE(told(QStringLiteral("Nothing is recorded")));
  controller_.recording = {QStringLiteral("/rec/Housing/T12/a.h5"), RecordingNow::State::Waits, 0, {}};
  play(0.1);
  EXPECT_TRUE(told(QStringLiteral("with the next event")));
  controller_.recording.state = RecordingNow::State::Writes;
  controller_.recording.deleted = 3;
  controller_.recording.lastDeleted = QStringLiteral("/rec/Housing/T12/old.h5");
  play(0.1);
  EXPECT_TRUE(told(QStringLiteral("Writes /rec/Housing/T12/a.h5")));
  EXPECT_TRUE(told(QStringLiteral("3, the last one old.h5")));
  EXPECT_FALSE(told(QStringLiteral("could not be deleted")));
  for (const char* const name : {"one", "two", "three", "four"}) {
    controller_.recording.notDeleted << QStringLiteral("%1.h5 (Permission denied)").arg(QLatin1String(name));
  }
  play(0.1);
  EXPECT_TRUE(told(QStringLiteral("could not be deleted: 4.")));
  EXPECT_TRUE(told(QStringLiteral("one.h5 (Permission denied), two.h5")));
  EXPECT_FALSE(told(QStringLiteral("four.h5"))) << "named as far as there is room";
}

}  // namespace
}  // namespace stillcut::ui
