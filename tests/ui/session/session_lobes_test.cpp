// The lobes behind the Lobes page while a replay is shown: of the cut that was recorded, never of the machine's tool.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include "app/compose/profile_rig.h"
#include "app/compose/run_text.h"
#include "app/compose/scenario_rig.h"
#include "app/session/deletions.h"
#include "app/session/session.h"
#include "core/config/profile.h"
#include "tests/support/demo_cut.h"
#include "tests/ui/support/wait_for.h"

namespace stillcut::app {
namespace {

class RecordedLobes : public testing::Test {
 protected:
  void SetUp() override {
    auto opened = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", false);
    ASSERT_TRUE(opened.ok()) << opened.error().line();
    session_ = std::move(opened).value();
  }
  // The short demo under another name, recorded as made from `origin`, and shown on every page.
  void show(const std::string& origin) {
    const std::string path = folder_.filePath(QStringLiteral("cut.h5")).toStdString();
    auto built = buildScenarioRig(cut_, {});
    ASSERT_TRUE(built.ok());
    ASSERT_TRUE(built->rig->recordTo(path, origin).ok());
    built->rig->runToEnd({});
    ASSERT_TRUE(built->rig->recorder()->finish().ok());
    open(path);
  }
  void open(const std::string& path) {
    controller().open(QString::fromStdString(path));
    test::waitFor(controller(), [&] { return controller().replay().open && controller().replayed() != nullptr; });
    ASSERT_TRUE(controller().showEverywhere(true).ok());
  }
  ui::SessionController& controller() { return *session_->sessions(); }
  // The picture of that place.
  const Snapshot& at(Seconds time) {
    controller().goTo(time);
    test::waitFor(controller(), [&] {
      const Snapshot* s = session_->pull();
      return s != nullptr && std::abs((controller().replay().position - time).value) < 0.05;
    });
    return *session_->pull();
  }
  static milling::Scenario otherCut() {
    milling::Scenario cut = test::demoCut();
    cut.name = "other-tool";
    return cut;
  }

  QTemporaryDir folder_;
  milling::Scenario cut_ = otherCut();
  std::unique_ptr<Session> session_;
};

TEST_F(RecordedLobes, AreOfTheScenarioThatWasRecordedWithItsDepthAtEveryPlace) {
  const ui::LobeService* const own = session_->lobes();
  ASSERT_NE(own, nullptr);
  show(milling::scenarioText(cut_));
  ui::LobeService* lobes = session_->lobes();
  ASSERT_NE(lobes, nullptr);
  EXPECT_NE(lobes, own);
  EXPECT_EQ(lobes->frame().name, QStringLiteral("other-tool"));
  EXPECT_NEAR(lobes->axialDepthAt(at(Seconds(3.0)).time).value, 1.5e-3, 1e-6) << "beyond the ramp";
  EXPECT_NEAR(lobes->axialDepthAt(at(Seconds(1.0)).time).value, 0.7e-3, 1e-6) << "and back before it";
  ASSERT_TRUE(controller().showEverywhere(false).ok());
  EXPECT_EQ(session_->lobes(), own);
}

TEST_F(RecordedLobes, AScenarioThatIsReplayedHasItsOwn) {
  open(STILLCUT_SOURCE_DIR "/resources/scenarios/caliskan-1.toml");
  ASSERT_NE(session_->lobes(), nullptr);
  EXPECT_EQ(session_->lobes()->frame().name, QStringLiteral("caliskan-1"));
}

TEST_F(RecordedLobes, ARecordingThatDoesNotSayHasNone) {
  show("");
  EXPECT_EQ(session_->lobes(), nullptr) << "and least of all the machine's";
}

TEST_F(RecordedLobes, AProfilesModesAreLookedForWhereItNamedThem) {
  config::Profile profile;
  profile.cut = cut_.cutSetup();
  profile.model = folder_.filePath(QStringLiteral("modes.toml")).toStdString();
  const std::string origin = config::profileText(profile, {});
  show(origin);
  EXPECT_EQ(session_->lobes(), nullptr) << "the file is gone";
}

// A profile names its model beside itself, and its recordings lie in a folder of their own.
TEST_F(RecordedLobes, AProfilesModesAreFoundFromTheFolderOfItsRecordings) {
  const QTemporaryDir machine;
  QFile model(machine.filePath(QStringLiteral("modes.toml")));
  ASSERT_TRUE(model.open(QIODevice::WriteOnly));
  model.write(
      "name = \"long tool\"\n[tool]\nteeth = 4\ndiameter_mm = 10.0\n[engagement]\nradial_immersion = 0.5\n"
      "side = \"up\"\n[chart]\nmax_depth_mm = 6.0\n[material]\ntangential_n_per_m2 = 6e8\n"
      "radial_n_per_m2 = 2e8\n[[mode]]\nfrequency_hz = 950.0\ndamping = 0.02\nstiffness_n_per_m = 3e6\n"
      "direction = [1.0, 0.0]\n");
  model.close();
  config::Profile profile;
  profile.cut = cut_.cutSetup();
  profile.model = "modes.toml";
  show(profileOrigin(profile, machine.filePath(QStringLiteral("mill.toml")).toStdString()));
  ASSERT_NE(session_->lobes(), nullptr);
  EXPECT_EQ(session_->lobes()->frame().name, QStringLiteral("long tool"));
}

TEST(RunText, SaysWhatItWasMadeFrom) {
  const std::string origin = "version = 1\n\n[cut]\nspeed_rpm = 8000.0\n";
  EXPECT_EQ(runOrigin(runText({}, origin)), origin);
  EXPECT_EQ(runOrigin(runText({}, "")), "");
  RunText run;
  run.methods = {.detectors = {"energy-ratio"}, .fallback = {}, .strategy = "monitor"};
  EXPECT_TRUE(parseRunText(runText(run, origin), "text").ok());
}

TEST(Deletions, WhatCouldNotBeDeletedIsCountedOnceWithItsReason) {
  Deletions deletions;
  const auto tell = deletions.teller();
  for (int k = 0; k < 2; ++k) tell({"/rec/a/old.h5", "older than 90 days", "Permission denied"});
  tell({"/rec/a/older.h5", "older than 90 days", "Read-only file system"});
  tell({"/rec/a/gone.h5", "older than 90 days", ""});
  ui::RecordingNow now = deletions.told(nullptr);
  EXPECT_EQ(now.deleted, 1);
  EXPECT_EQ(now.notDeleted, QStringList({QStringLiteral("old.h5 (Permission denied)"),
                                         QStringLiteral("older.h5 (Read-only file system)")}));
  tell({"/rec/a/old.h5", "older than 90 days", ""});
  now = deletions.told(nullptr);
  EXPECT_EQ(now.deleted, 2);
  EXPECT_EQ(now.notDeleted.size(), 1) << "it has gone after all";
}

}  // namespace
}  // namespace stillcut::app
