// The desks behind the Sessions, Tune and Lobes pages on real recordings, simulated machines and files of a folder.

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/compose/scenario_rig.h"
#include "app/compose/session_summary_builder.h"
#include "app/session/replay_desk.h"
#include "app/session/session.h"
#include "app/session/tool_library.h"
#include "core/detect/energy_ratio.h"
#include "core/record/session_markers.h"
#include "tests/component/demo_cut.h"
#include "tests/ui/wait_for.h"

namespace stillcut::app {
namespace {

// The short demo, recorded without control: chatter from 2 s on.
std::string recordDemo(const QString& folder) {
  QDir().mkpath(folder + QStringLiteral("/Housing/T12"));
  std::string path = (folder + QStringLiteral("/Housing/T12/demo.h5")).toStdString();
  ScenarioOptions options;
  options.methods.strategy = "monitor";
  auto built = buildScenarioRig(test::demoCut(), options);
  EXPECT_TRUE(built.ok());
  EXPECT_TRUE(built->rig->recordTo(path, "").ok());
  built->rig->runToEnd({});
  EXPECT_TRUE(built->rig->recorder()->finish().ok());
  return path;
}

class ReplayDeskTest : public testing::Test {
 protected:
  void SetUp() override {
    path_ = QString::fromStdString(recordDemo(folder_.path()));
    desk_.setFolder(folder_.path());
    test::waitFor(desk_, [this] { return !desk_.entries().empty(); });
    desk_.open(path_);
    test::waitFor(desk_, [this] { return desk_.replay().open && desk_.replayed() != nullptr; });
  }
  void waitForTask() {
    test::waitFor(desk_, [this] { return !desk_.task().running; });
    EXPECT_TRUE(desk_.task().problem.isEmpty()) << desk_.task().problem.toStdString();
  }

  QTemporaryDir folder_;
  QString path_;
  ReplayDesk desk_;
};

TEST_F(ReplayDeskTest, ListsOpensPlaysJumpsAndBeginsAnew) {
  ASSERT_EQ(desk_.entries().size(), 1U);
  EXPECT_EQ(desk_.entries()[0].job, QStringLiteral("Housing"));
  EXPECT_EQ(desk_.entries()[0].tool, QStringLiteral("T12"));
  EXPECT_NEAR(desk_.replay().length.value, 5.0, 0.1);
  EXPECT_FALSE(desk_.replay().playing);
  desk_.goTo(Seconds(3.0));
  test::waitFor(desk_, [this] { return std::abs(desk_.replay().position.value - 3.0) < 0.1; });
  ASSERT_NE(desk_.replayed(), nullptr);
  desk_.setPace(0.0);
  desk_.play();
  test::waitFor(desk_, [this] { return desk_.replay().finished; });
  EXPECT_NEAR(desk_.replay().position.value, 5.0, 0.1);
  desk_.goTo(Seconds(1.0));
  test::waitFor(desk_, [this] { return std::abs(desk_.replay().position.value - 1.0) < 0.1; });
  desk_.loop(Seconds(1.0), Seconds(1.5));
  desk_.play();
  test::waitFor(desk_, [this] { return desk_.replayed()->health.blocks > 300; });
  EXPECT_LT(desk_.replay().position.value, 1.7) << "it goes round and round";
}

TEST_F(ReplayDeskTest, MarksStayInTheFileWhileItIsReplayed) {
  ASSERT_TRUE(desk_.mark(Seconds(2.4), Seconds(4.0), QStringLiteral("chatter"), QStringLiteral("deep slot")).ok());
  ASSERT_TRUE(desk_.mark(Seconds(1.0), Seconds(1.0), QStringLiteral("heard"), {}).ok());
  ASSERT_EQ(desk_.markers().size(), 2U);
  EXPECT_NEAR(desk_.markerTime(desk_.markers()[1]).value, 2.4, 1e-6);
  ASSERT_TRUE(desk_.removeMark(desk_.markers()[0].number).ok());
  test::waitFor(desk_, [this] { return desk_.replayed() != nullptr; });
  ReplayDesk second;
  second.open(path_);
  test::waitFor(second, [&] { return second.replay().open; });
  ASSERT_EQ(second.markers().size(), 1U);
  EXPECT_EQ(second.markers()[0].note, "deep slot");
}

// What was marked after it was read stands in the report as well.
TEST_F(ReplayDeskTest, TheSummaryHasTheMarkersOfNow) {
  test::waitFor(desk_, [this] { return desk_.summaryWhole(); });
  const auto before = desk_.summary();
  ASSERT_TRUE(desk_.mark(Seconds(2.4), Seconds(4.0), QStringLiteral("burr"), QStringLiteral("deep slot")).ok());
  ASSERT_EQ(desk_.summary()->markers.size(), 1U);
  EXPECT_TRUE(desk_.summaryWhole()) << "nothing has to be read again for it";
  EXPECT_EQ(desk_.summary()->markers[0].note, "deep slot");
  EXPECT_NEAR(sinceEpoch(desk_.summary()->markers[0].begin).value, 2.4, 1e-6);
  EXPECT_EQ(desk_.summary()->alarms, before->alarms);
  EXPECT_TRUE(before->markers.empty()) << "whoever holds one keeps it";
  const auto read = summarizeRecording(path_.toStdString());
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->markers.size(), 1U);
  EXPECT_EQ(read->markers[0].begin, desk_.summary()->markers[0].begin);
  ASSERT_TRUE(desk_.removeMark(desk_.markers()[0].number).ok());
  EXPECT_TRUE(desk_.summary()->markers.empty());
}

TEST_F(ReplayDeskTest, IsOpenAtOnceAndReadsTheWholeMeanwhile) {
  const auto glimpse = glimpseOf(path_.toStdString());
  ASSERT_TRUE(glimpse.ok()) << glimpse.error().line();
  EXPECT_NEAR(glimpse->length.value, 5.0, 0.1);
  EXPECT_TRUE(glimpse->spectrogram.empty()) << "that would have needed every sample";
  double quiet = 0.0, loud = 0.0;
  for (const SummaryPoint& point : glimpse->curve) {
    double& most = point.time.value < 1.5 ? quiet : loud;
    most = std::max(most, point.vibration);
  }
  EXPECT_GT(loud, 1.5 * quiet) << "the chatter stands in the curve";
  ASSERT_NE(desk_.summary(), nullptr);
  EXPECT_FALSE(desk_.summary()->curve.empty());
  desk_.runDetectors({});
  test::waitFor(desk_, [this] { return desk_.summaryWhole(); });
  waitForTask();
  EXPECT_EQ(desk_.summary()->alarms, 1U);
  EXPECT_FALSE(desk_.summary()->spectrogram.empty());
  EXPECT_EQ(desk_.tracks().size(), 4U);
}

TEST_F(ReplayDeskTest, TheListTellsTheLengthAndTheMarkersOfEverySession) {
  QFile foreign(folder_.filePath(QStringLiteral("broken.h5")));
  ASSERT_TRUE(foreign.open(QIODevice::WriteOnly));
  foreign.write("nothing");
  foreign.close();
  ASSERT_TRUE(desk_.mark(Seconds(1.0), Seconds(1.0), QStringLiteral("heard"), {}).ok());
  using Inside = ui::SessionEntry::Inside;
  const auto told = [this] {
    const auto& all = desk_.entries();
    return all.size() == 2U &&
           std::none_of(all.begin(), all.end(), [](const auto& e) { return e.inside == Inside::NotYet; });
  };
  desk_.setFolder(folder_.path());
  test::waitFor(desk_, told);
  const auto& entries = desk_.entries();
  const ui::SessionEntry& demo = entries[0].path == path_ ? entries[0] : entries[1];
  const ui::SessionEntry& broken = entries[0].path == path_ ? entries[1] : entries[0];
  EXPECT_EQ(demo.inside, Inside::Known);
  EXPECT_NEAR(demo.length.value, 5.0, 0.1);
  EXPECT_EQ(demo.markers, 1);
  EXPECT_EQ(broken.inside, Inside::No);
  ASSERT_TRUE(desk_.mark(Seconds(2.0), Seconds(3.0), QStringLiteral("note"), {}).ok());
  EXPECT_EQ(demo.markers, 2) << "without listing the folder anew";
}

TEST_F(ReplayDeskTest, DetectorsRunSideBySideAndAreScored) {
  ASSERT_TRUE(desk_.mark(Seconds(0.7), Seconds(1.5), QStringLiteral("stable"), {}).ok());
  ASSERT_TRUE(desk_.mark(Seconds(2.4), Seconds(4.6), QStringLiteral("chatter"), {}).ok());
  desk_.runDetectors({QStringLiteral("energy-ratio.onset-amplitude=1"), QStringLiteral("energy-ratio.chatter=1")});
  waitForTask();
  ASSERT_EQ(desk_.tracks().size(), 4U);
  for (const ui::DetectorTrack& track : desk_.tracks()) {
    if (track.detector != QStringLiteral("Energy ratio")) continue;
    EXPECT_TRUE(track.compared);
    EXPECT_GE(track.before.size(), 1U);
    EXPECT_NE(track.after, track.before) << "the limits have changed nothing";
  }
  desk_.score(false);
  waitForTask();
  ASSERT_EQ(desk_.scores().size(), 4U);
  for (const ui::ScoreLine& line : desk_.scores()) {
    EXPECT_EQ(line.spans, 1);
    if (line.detector == QStringLiteral("Energy ratio")) {
      EXPECT_EQ(line.found, 1);
    }
  }
}

TEST_F(ReplayDeskTest, ExportsTheSpan) {
  const QString file = folder_.filePath(QStringLiteral("span.wav"));
  desk_.exportSpan(Seconds(2.0), Seconds(3.0), file);
  waitForTask();
  const double frames =
      static_cast<double>(QFile(file).size()) / (4.0 * static_cast<double>(desk_.summary()->setup.channels.size()));
  EXPECT_NEAR(frames / desk_.summary()->setup.rate.value, 1.0, 0.05);
}

// One bad file is no reason to score none.
TEST_F(ReplayDeskTest, AFolderIsScoredAroundTheFileThatCannotBeRead) {
  ASSERT_TRUE(desk_.mark(Seconds(2.4), Seconds(4.6), QStringLiteral("chatter"), {}).ok());
  const QString broken = folder_.filePath(QStringLiteral("Housing/broken.h5"));
  ASSERT_TRUE(QFile::copy(path_, broken));
  ASSERT_TRUE(QFile::resize(broken, QFile(broken).size() / 2)) << "a copy that broke off";
  desk_.setFolder(folder_.path());
  test::waitFor(desk_, [this] { return desk_.entries().size() == 2U; });
  desk_.score(true);
  waitForTask();
  ASSERT_EQ(desk_.scores().size(), 4U);
  for (const ui::ScoreLine& line : desk_.scores()) EXPECT_EQ(line.spans, 1) << line.detector.toStdString();
  ASSERT_EQ(desk_.notScored().size(), 1);
  EXPECT_TRUE(desk_.notScored()[0].contains(QStringLiteral("broken.h5"))) << desk_.notScored()[0].toStdString();
}

TEST_F(ReplayDeskTest, LabelAndNoteOfASpanAreMendedInTheFile) {
  ASSERT_TRUE(desk_.mark(Seconds(2.4), Seconds(4.0), QStringLiteral("burr"), {}).ok());
  ASSERT_TRUE(desk_.changeMark(desk_.markers()[0].number, QStringLiteral("burr, deep"), QStringLiteral("0.2 mm")).ok());
  EXPECT_FALSE(desk_.changeMark(99, QStringLiteral("x"), {}).ok());
  const auto markers = record::readMarkers(path_.toStdString());
  ASSERT_TRUE(markers.ok());
  ASSERT_EQ(markers->size(), 1U);
  EXPECT_EQ(markers->front().label, "burr, deep");
  EXPECT_EQ(markers->front().note, "0.2 mm");
  EXPECT_NEAR(secondsBetween(markers->front().begin, markers->front().end).value, 1.6, 1e-6);
}

// The program's own scenarios and those of the folder, replayed as a recording is: played, jumped in, held against the
// detectors, exported.
TEST_F(ReplayDeskTest, AScenarioIsReplayedAsARecordingIs) {
  const QString own = folder_.filePath(QStringLiteral("own.toml"));
  ASSERT_TRUE(QFile::copy(QStringLiteral(STILLCUT_SOURCE_DIR "/resources/scenarios/xu-aluminium.toml"), own));
  QFile other(folder_.filePath(QStringLiteral("notes.toml")));
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  other.write("a = 1\n");
  other.close();
  desk_.setFolder(folder_.path());
  const auto listed = [this](const QString& name) {
    return std::any_of(desk_.scenarios().begin(), desk_.scenarios().end(),
                       [&name](const ui::SessionEntry& e) { return e.path.endsWith(name); });
  };
  test::waitFor(desk_, [&] { return listed(QStringLiteral("own.toml")); });
  EXPECT_TRUE(listed(QStringLiteral("scenarios/demo.toml"))) << "those of the program";
  EXPECT_FALSE(listed(QStringLiteral("notes.toml")));

  desk_.open(own);
  test::waitFor(desk_, [&] { return desk_.openedPath() == own && desk_.replayed() != nullptr; });
  const double length = desk_.replay().length.value;
  EXPECT_GT(length, 1.0);
  EXPECT_FALSE(desk_.summary()->session) << "nothing can be marked in it";
  desk_.goTo(Seconds(0.5));
  test::waitFor(desk_, [this] { return std::abs(desk_.replay().position.value - 0.5) < 0.1; });
  desk_.setPace(0.0);
  desk_.play();
  test::waitFor(desk_, [this] { return desk_.replay().finished; });
  test::waitFor(desk_, [this] { return desk_.summaryWhole(); });
  EXPECT_NEAR(desk_.summary()->length.value, length, 0.1);
  desk_.runDetectors({});
  waitForTask();
  EXPECT_EQ(desk_.tracks().size(), 4U);
  const QString file = folder_.filePath(QStringLiteral("own.wav"));
  desk_.exportSpan(Seconds(0.2), Seconds(0.7), file);
  waitForTask();
  EXPECT_GT(QFile(file).size(), 1000);
}

TEST_F(ReplayDeskTest, WhatCannotBeReadIsASentence) {
  QFile broken(folder_.filePath(QStringLiteral("broken.h5")));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("nothing");
  broken.close();
  desk_.open(broken.fileName());
  test::waitFor(desk_, [this] { return !desk_.task().running; });
  EXPECT_TRUE(desk_.task().problem.contains(QStringLiteral("broken.h5")));
  EXPECT_EQ(desk_.openedPath(), path_) << "what was open stays";
}

TEST(Lobes, AProfilesModesGiveTheLobesPageItsDiagram) {
  const QTemporaryDir folder;
  QFile file(folder.filePath(QStringLiteral("cut.toml")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      "name = \"long tool\"\n[tool]\nteeth = 2\ndiameter_mm = 10.0\n[engagement]\nradial_immersion = 0.5\n"
      "side = \"up\"\n[chart]\nmax_depth_mm = 6.0\n[material]\ntangential_n_per_m2 = 6e8\n"
      "radial_n_per_m2 = 2e8\n[[mode]]\nfrequency_hz = 950.0\ndamping = 0.02\nstiffness_n_per_m = 3e6\n"
      "direction = [1.0, 0.0]\n");
  file.close();
  config::Profile profile;
  const std::string path = folder.filePath(QStringLiteral("mill.toml")).toStdString();
  ASSERT_TRUE(LobeWorker::ofProfile(profile, path).ok());
  EXPECT_EQ(*LobeWorker::ofProfile(profile, path), nullptr) << "it names no model";
  profile.model = "cut.toml";
  profile.cut.teeth = 2;
  profile.cut.nominalSpeed = Rpm(14000.0);
  profile.cut.nominalFeed = MetresPerSecond(28.0 / 60.0);
  profile.depth = Metres(1.2e-3);
  auto lobes = LobeWorker::ofProfile(profile, path);
  ASSERT_TRUE(lobes.ok()) << lobes.error().line();
  const ui::LobeFrame& frame = (*lobes)->frame();
  EXPECT_EQ(frame.name, QStringLiteral("long tool"));
  EXPECT_NEAR(frame.feedPerTooth.value, 1e-3, 1e-9);
  EXPECT_LE(frame.lowest, frame.reachLow);
  EXPECT_GT(frame.reachHigh, frame.reachLow);
  (*lobes)->ask({ui::LobeMethod::ZerothOrder, frame.lowest, frame.highest, 40, frame.maxDepth});
  EXPECT_TRUE(QTest::qWaitFor([&] { return (*lobes)->diagram() != nullptr; }, 60000));
  EXPECT_EQ((*lobes)->diagram()->limits.size(), 40U);
  profile.model = "nowhere.toml";
  const auto missing = LobeWorker::ofProfile(profile, path);
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().line().find("nowhere.toml"), std::string::npos);
}

TEST(ToolLibrary, ComesBackAsItWasAndNamesWhatIsWrong) {
  const QTemporaryDir folder;
  const std::string path = folder.filePath(QStringLiteral("data/tools.toml")).toStdString();
  EXPECT_TRUE(loadTools(path)->empty());
  ui::ToolEntry tool;
  tool.name = QStringLiteral("T12 \"D12\" Z4 µ");
  tool.holder = QStringLiteral("HSK63");
  tool.teeth = 4;
  tool.diameter_mm = 12.0;
  tool.highestSpeed_rpm = 18000.0;
  tool.chattered = {{8800.0, 1.5, 1713.0, QStringLiteral("slot")}, {8200.0, 0.0, 0.0, {}}};
  ui::ToolEntry plain;
  plain.name = QStringLiteral("T3");
  ASSERT_TRUE(saveTools({tool, plain}, path).ok());
  const auto back = loadTools(path);
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(*back, (std::vector<ui::ToolEntry>{tool, plain}));
  QFile file(QString::fromStdString(path));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("version = 1\n[[tool]]\nname = \"T1\"\nteeth = 0\ndiameter_mm = 3\n");
  file.close();
  const auto wrong = loadTools(path);
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().line().find("teeth"), std::string::npos) << wrong.error().line();
}

TEST(Session, EveryAutomaticParameterSaysHowItIsChosenAndWhatRunsWhatItChose) {
  auto session = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", false);
  ASSERT_TRUE(session.ok()) << session.error().line();
  int automatic = 0;
  for (const ui::TunablePart& part : (*session)->tunableParts()) {
    for (const config::ParamDecl* decl : part.params) {
      if (!decl->mayBeAutomatic) continue;
      ++automatic;
      EXPECT_NE(decl->meaning.find("auto: "), std::string_view::npos) << decl->key;
      if (part.running && part.role == ui::TunablePart::Role::Detector) {
        EXPECT_EQ(part.chosen.count(decl->key), 1U) << decl->key;
      }
    }
  }
  EXPECT_GT(automatic, 10);
}

TEST(Session, TakesAnotherRunsPlaceAndKeepsTunedValues) {
  const QTemporaryDir folder;
  const std::string demo = STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml";
  auto session = openScenarioSession(demo, true);
  ASSERT_TRUE(session.ok()) << session.error().line();
  (*session)->keepStateIn(folder.path());
  (*session)->demonstrateWith(demo);
  (*session)->keepFlightsIn(folder.filePath(QStringLiteral("flights")).toStdString());
  (*session)->start();
  const std::uint32_t before = (*session)->generation();
  config::ParamSet values = (*session)->startValues();
  ASSERT_TRUE(values.set(detect::kErChatter, 0.35, "test").ok());
  const auto kept = (*session)->saveValues(values);
  ASSERT_TRUE(kept.ok()) << kept.error().line();
  QFile file(kept.value());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("chatter = 0.35"));
  (*session)->send({OperatorAction::SetParameter, Authority::Off, 0, config::parameterId(detect::kErChatter.key), 0.4});
  EXPECT_EQ((*session)->sessions()->tunedSettings(), QStringList{QStringLiteral("energy-ratio.chatter=0.4")});
  ASSERT_TRUE((*session)->setup()->startDemonstration().ok());
  EXPECT_GT((*session)->generation(), before);
  EXPECT_TRUE(QTest::qWaitFor([&] { return (*session)->pull() != nullptr; }, 20000)) << "the new cut moves";
  const Status refused = (*session)->setup()->start(QStringLiteral("no-such-profile"));
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("stopped"), std::string::npos);
  EXPECT_TRUE((*session)->stop().ok());
}

}  // namespace
}  // namespace stillcut::app
