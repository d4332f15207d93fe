// The desks behind the Sessions and Lobes pages on real recordings, simulated machines and files of a folder.

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/compose/scenario_rig.h"
#include "app/session/lobe_worker.h"
#include "app/session/replay_desk.h"
#include "core/evaluate/session_summary_builder.h"
#include "core/session/file/session_markers.h"
#include "tests/support/demo_cut.h"
#include "tests/ui/support/wait_for.h"

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
  // The disk has it, and the replay goes on.
  void mark(Seconds from, Seconds to, const char* label, const char* note = "") {
    const std::size_t before = desk_.markers().size();
    ASSERT_TRUE(desk_.mark(from, to, QString::fromUtf8(label), QString::fromUtf8(note)).ok());
    test::waitFor(desk_, [&] { return desk_.markers().size() == before + 1; });
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
  test::waitFor(desk_, [this] { return desk_.replayed() != nullptr && desk_.replayed()->health.blocks > 300; });
  EXPECT_LT(desk_.replay().position.value, 1.7) << "it goes round and round";
}

TEST_F(ReplayDeskTest, MarksStayInTheFileWhileItIsReplayed) {
  mark(Seconds(2.4), Seconds(4.0), "chatter", "deep slot");
  mark(Seconds(1.0), Seconds(1.0), "heard");
  ASSERT_EQ(desk_.markers().size(), 2U);
  EXPECT_NEAR(desk_.markerTime(desk_.markers()[1]).value, 2.4, 1e-6);
  ASSERT_TRUE(desk_.removeMark(desk_.markers()[0].number).ok());
  test::waitFor(desk_, [this] { return desk_.markers().size() == 1U && desk_.replayed() != nullptr; });
  ReplayDesk second;
  second.open(path_);
  test::waitFor(second, [&] { return second.replay().open; });
  ASSERT_EQ(second.markers().size(), 1U);
  EXPECT_EQ(second.markers()[0].note, "deep slot");
}

// However slow the disk is: a mark is written beside the screen, and what is touched meanwhile is not forgotten.
TEST_F(ReplayDeskTest, AMarkWaitsForNoDiskAndTheReplayGoesOnWhereItWas) {
  desk_.goTo(Seconds(3.0));
  test::waitFor(desk_, [this] { return std::abs(desk_.replay().position.value - 3.0) < 0.1; });
  ASSERT_TRUE(desk_.mark(Seconds(2.4), Seconds(4.0), QStringLiteral("burr"), {}).ok());
  EXPECT_TRUE(desk_.markers().empty()) << "it is not waited for";
  EXPECT_EQ(desk_.task().what, ui::TaskState::What::Marking);
  EXPECT_TRUE(desk_.replay().open);
  EXPECT_NEAR(desk_.replay().position.value, 3.0, 0.1);
  ASSERT_TRUE(desk_.mark(Seconds(1.0), Seconds(1.5), QStringLiteral("tick"), {}).ok()) << "and another at once";
  desk_.loop(Seconds(2.0), Seconds(2.5));
  desk_.play();
  EXPECT_TRUE(desk_.replay().playing);
  EXPECT_NEAR(desk_.replay().position.value, 2.0, 1e-9);
  test::waitFor(desk_, [this] { return desk_.markers().size() == 2U && desk_.replayed() != nullptr; });
  test::waitFor(desk_, [this] { return desk_.replayed() != nullptr && desk_.replayed()->health.blocks > 100; });
  EXPECT_TRUE(desk_.replay().playing);
  EXPECT_LT(desk_.replay().position.value, 2.7) << "it goes round and round";
  EXPECT_TRUE(desk_.task().problem.isEmpty()) << desk_.task().problem.toStdString();
}

// Whoever opens another recording, or leaves, straight after a touch has marked all the same.
TEST_F(ReplayDeskTest, WhatWasMarkedLastIsWritten) {
  const QString copy = folder_.filePath(QStringLiteral("copy.h5"));
  ASSERT_TRUE(QFile::copy(path_, copy));
  {
    ReplayDesk hasty;
    hasty.open(copy);
    test::waitFor(hasty, [&] { return hasty.replay().open; });
    ASSERT_TRUE(hasty.mark(Seconds(1.0), Seconds(1.0), QStringLiteral("heard"), {}).ok());
    hasty.open(path_);
    EXPECT_FALSE(hasty.mark(Seconds(2.0), Seconds(2.0), QStringLiteral("note"), {}).ok()) << "nothing is open now";
  }
  const auto written = record::readMarkers(copy.toStdString());
  ASSERT_TRUE(written.ok()) << written.error().line();
  ASSERT_EQ(written->size(), 1U);
  EXPECT_EQ(written->front().label, "heard");
}

// Where the file cannot be written the sentence says so, and the replay goes on.
TEST_F(ReplayDeskTest, AMarkThatCannotBeWrittenIsASentence) {
  test::waitFor(desk_, [this] { return desk_.summaryWhole(); });
  ASSERT_TRUE(desk_.removeMark(77).ok());
  test::waitFor(desk_, [this] { return !desk_.task().problem.isEmpty(); });
  EXPECT_TRUE(desk_.replay().open);
  mark(Seconds(1.0), Seconds(1.0), "heard");
  EXPECT_TRUE(desk_.task().problem.isEmpty()) << desk_.task().problem.toStdString();
}

// What was marked after it was read stands in the report as well.
TEST_F(ReplayDeskTest, TheSummaryHasTheMarkersOfNow) {
  test::waitFor(desk_, [this] { return desk_.summaryWhole(); });
  const auto before = desk_.summary();
  mark(Seconds(2.4), Seconds(4.0), "burr", "deep slot");
  ASSERT_EQ(desk_.summary()->markers.size(), 1U);
  EXPECT_TRUE(desk_.summaryWhole()) << "nothing has to be read again for it";
  EXPECT_EQ(desk_.summary()->markers[0].note, "deep slot");
  EXPECT_NEAR(sinceEpoch(desk_.summary()->markers[0].begin).value, 2.4, 1e-6);
  EXPECT_EQ(desk_.summary()->alarms, before->alarms);
  EXPECT_TRUE(before->markers.empty()) << "whoever holds one keeps it";
  const auto read = evaluate::summarizeRecording(path_.toStdString());
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->markers.size(), 1U);
  EXPECT_EQ(read->markers[0].begin, desk_.summary()->markers[0].begin);
  ASSERT_TRUE(desk_.removeMark(desk_.markers()[0].number).ok());
  test::waitFor(desk_, [this] { return desk_.summary()->markers.empty(); });
}

TEST_F(ReplayDeskTest, IsOpenAtOnceAndReadsTheWholeMeanwhile) {
  const auto glimpse = evaluate::glimpseOf(path_.toStdString());
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
  mark(Seconds(1.0), Seconds(1.0), "heard");
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
  mark(Seconds(2.0), Seconds(3.0), "note");
  EXPECT_EQ(demo.markers, 2) << "without listing the folder anew";
}

TEST_F(ReplayDeskTest, DetectorsRunSideBySideAndAreScored) {
  mark(Seconds(0.7), Seconds(1.5), "stable");
  mark(Seconds(2.4), Seconds(4.6), "chatter");
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
  mark(Seconds(2.4), Seconds(4.6), "chatter");
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
  mark(Seconds(2.4), Seconds(4.0), "burr");
  ASSERT_TRUE(desk_.changeMark(desk_.markers()[0].number, QStringLiteral("burr, deep"), QStringLiteral("0.2 mm")).ok());
  test::waitFor(desk_, [this] { return desk_.markers()[0].note == "0.2 mm"; });
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
  desk_.open(file);
  test::waitFor(desk_, [&] { return desk_.openedPath() == file; });
  EXPECT_TRUE(QString::fromStdString(desk_.info().setup.machine).contains(QStringLiteral("own.wav")))
      << "of a machine that the file does not know: " << desk_.info().setup.machine;
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
  profile.pitch = {170.0, 190.0};
  auto uneven = LobeWorker::ofProfile(profile, path);
  ASSERT_TRUE(uneven.ok()) << uneven.error().line();
  (*uneven)->ask({ui::LobeMethod::ZerothOrder, frame.lowest, frame.highest, 40, frame.maxDepth});
  EXPECT_TRUE(QTest::qWaitFor([&] { return (*uneven)->progress().state == ui::LobeProgress::State::Failed; }, 60000));
  EXPECT_TRUE((*uneven)->progress().problem.contains(QStringLiteral("regular pitch")))
      << "the lobes of an even pitch are not this tool's";
  EXPECT_EQ((*uneven)->diagram(), nullptr);
  profile.model = "nowhere.toml";
  const auto missing = LobeWorker::ofProfile(profile, path);
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().line().find("nowhere.toml"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::app
