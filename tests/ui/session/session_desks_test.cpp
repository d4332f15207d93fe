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
#include "app/session/replay/replay_controller.h"
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
    controller_.setFolder(folder_.path());
    test::waitFor(controller_, [this] { return !controller_.entries().empty(); });
    controller_.open(path_);
    test::waitFor(controller_, [this] { return controller_.replay().open && controller_.replayed() != nullptr; });
  }
  // The disk has it, and the replay goes on.
  void mark(Seconds from, Seconds to, const char* label, const char* note = "") {
    const std::size_t before = controller_.markers().size();
    ASSERT_TRUE(controller_.mark(from, to, QString::fromUtf8(label), QString::fromUtf8(note)).ok());
    test::waitFor(controller_, [&] { return controller_.markers().size() == before + 1; });
  }
  void waitForTask() {
    test::waitFor(controller_, [this] { return !controller_.task().running; });
    EXPECT_TRUE(controller_.task().problem.isEmpty()) << controller_.task().problem.toStdString();
  }

  QTemporaryDir folder_;
  QString path_;
  ReplayController controller_;
};

TEST_F(ReplayDeskTest, ListsOpensPlaysJumpsAndBeginsAnew) {
  ASSERT_EQ(controller_.entries().size(), 1U);
  EXPECT_EQ(controller_.entries()[0].job, QStringLiteral("Housing"));
  EXPECT_EQ(controller_.entries()[0].tool, QStringLiteral("T12"));
  EXPECT_NEAR(controller_.replay().length.value, 5.0, 0.1);
  EXPECT_FALSE(controller_.replay().playing);
  controller_.goTo(Seconds(3.0));
  test::waitFor(controller_, [this] { return std::abs(controller_.replay().position.value - 3.0) < 0.1; });
  ASSERT_NE(controller_.replayed(), nullptr);
  controller_.setPace(0.0);
  controller_.play();
  test::waitFor(controller_, [this] { return controller_.replay().finished; });
  EXPECT_NEAR(controller_.replay().position.value, 5.0, 0.1);
  controller_.goTo(Seconds(1.0));
  test::waitFor(controller_, [this] { return std::abs(controller_.replay().position.value - 1.0) < 0.1; });
  controller_.loop(Seconds(1.0), Seconds(1.5));
  controller_.play();
  test::waitFor(controller_,
                [this] { return controller_.replayed() != nullptr && controller_.replayed()->health.blocks > 300; });
  EXPECT_LT(controller_.replay().position.value, 1.7) << "it goes round and round";
}

TEST_F(ReplayDeskTest, MarksStayInTheFileWhileItIsReplayed) {
  mark(Seconds(2.4), Seconds(4.0), "chatter", "deep slot");
  mark(Seconds(1.0), Seconds(1.0), "heard");
  ASSERT_EQ(controller_.markers().size(), 2U);
  EXPECT_NEAR(controller_.markerTime(controller_.markers()[1]).value, 2.4, 1e-6);
  ASSERT_TRUE(controller_.removeMark(controller_.markers()[0].number).ok());
  test::waitFor(controller_,
                [this] { return controller_.markers().size() == 1U && controller_.replayed() != nullptr; });
  ReplayController second;
  second.open(path_);
  test::waitFor(second, [&] { return second.replay().open; });
  ASSERT_EQ(second.markers().size(), 1U);
  EXPECT_EQ(second.markers()[0].note, "deep slot");
}

// However slow the disk is: a mark is written beside the screen, and what is touched meanwhile is not forgotten.
TEST_F(ReplayDeskTest, AMarkWaitsForNoDiskAndTheReplayGoesOnWhereItWas) {
  controller_.goTo(Seconds(3.0));
  test::waitFor(controller_, [this] { return std::abs(controller_.replay().position.value - 3.0) < 0.1; });
  ASSERT_TRUE(controller_.mark(Seconds(2.4), Seconds(4.0), QStringLiteral("burr"), {}).ok());
  EXPECT_TRUE(controller_.markers().empty()) << "it is not waited for";
  EXPECT_EQ(controller_.task().what, ui::TaskState::What::Marking);
  EXPECT_TRUE(controller_.replay().open);
  EXPECT_NEAR(controller_.replay().position.value, 3.0, 0.1);
  ASSERT_TRUE(controller_.mark(Seconds(1.0), Seconds(1.5), QStringLiteral("tick"), {}).ok()) << "and another at once";
  controller_.loop(Seconds(2.0), Seconds(2.5));
  controller_.play();
  EXPECT_TRUE(controller_.replay().playing);
  EXPECT_NEAR(controller_.replay().position.value, 2.0, 1e-9);
  test::waitFor(controller_,
                [this] { return controller_.markers().size() == 2U && controller_.replayed() != nullptr; });
  test::waitFor(controller_,
                [this] { return controller_.replayed() != nullptr && controller_.replayed()->health.blocks > 100; });
  EXPECT_TRUE(controller_.replay().playing);
  EXPECT_LT(controller_.replay().position.value, 2.7) << "it goes round and round";
  EXPECT_TRUE(controller_.task().problem.isEmpty()) << controller_.task().problem.toStdString();
}

// Whoever opens another recording, or leaves, straight after a touch has marked all the same.
TEST_F(ReplayDeskTest, WhatWasMarkedLastIsWritten) {
  const QString copy = folder_.filePath(QStringLiteral("copy.h5"));
  ASSERT_TRUE(QFile::copy(path_, copy));
  {
    ReplayController hasty;
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
  test::waitFor(controller_, [this] { return controller_.summaryWhole(); });
  ASSERT_TRUE(controller_.removeMark(77).ok());
  test::waitFor(controller_, [this] { return !controller_.task().problem.isEmpty(); });
  EXPECT_TRUE(controller_.replay().open);
  mark(Seconds(1.0), Seconds(1.0), "heard");
  EXPECT_TRUE(controller_.task().problem.isEmpty()) << controller_.task().problem.toStdString();
}

// What was marked after it was read stands in the report as well.
TEST_F(ReplayDeskTest, TheSummaryHasTheMarkersOfNow) {
  test::waitFor(controller_, [this] { return controller_.summaryWhole(); });
  const auto before = controller_.summary();
  mark(Seconds(2.4), Seconds(4.0), "burr", "deep slot");
  ASSERT_EQ(controller_.summary()->markers.size(), 1U);
  EXPECT_TRUE(controller_.summaryWhole()) << "nothing has to be read again for it";
  EXPECT_EQ(controller_.summary()->markers[0].note, "deep slot");
  EXPECT_NEAR(sinceEpoch(controller_.summary()->markers[0].begin).value, 2.4, 1e-6);
  EXPECT_EQ(controller_.summary()->alarms, before->alarms);
  EXPECT_TRUE(before->markers.empty()) << "whoever holds one keeps it";
  const auto read = evaluate::summarizeRecording(path_.toStdString());
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->markers.size(), 1U);
  EXPECT_EQ(read->markers[0].begin, controller_.summary()->markers[0].begin);
  ASSERT_TRUE(controller_.removeMark(controller_.markers()[0].number).ok());
  test::waitFor(controller_, [this] { return controller_.summary()->markers.empty(); });
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
  ASSERT_NE(controller_.summary(), nullptr);
  EXPECT_FALSE(controller_.summary()->curve.empty());
  controller_.runDetectors({});
  test::waitFor(controller_, [this] { return controller_.summaryWhole(); });
  waitForTask();
  EXPECT_EQ(controller_.summary()->alarms, 1U);
  EXPECT_FALSE(controller_.summary()->spectrogram.empty());
  EXPECT_EQ(controller_.tracks().size(), 4U);
}

TEST_F(ReplayDeskTest, TheListTellsTheLengthAndTheMarkersOfEverySession) {
  QFile foreign(folder_.filePath(QStringLiteral("broken.h5")));
  ASSERT_TRUE(foreign.open(QIODevice::WriteOnly));
  foreign.write("nothing");
  foreign.close();
  mark(Seconds(1.0), Seconds(1.0), "heard");
  using Inside = ui::SessionEntry::Inside;
  const auto told = [this] {
    const auto& all = controller_.entries();
    return all.size() == 2U &&
           std::none_of(all.begin(), all.end(), [](const auto& e) { return e.inside == Inside::NotYet; });
  };
  controller_.setFolder(folder_.path());
  test::waitFor(controller_, [this] { return controller_.entries().size() == 2U; });
  const auto& entries = controller_.entries();
  for (const auto& entry : entries) EXPECT_EQ(entry.inside, Inside::NotYet) << "nobody has asked";
  controller_.lookInside({foreign.fileName()});
  test::waitFor(controller_, [&] {
    return std::any_of(entries.begin(), entries.end(), [](const auto& e) { return e.inside != Inside::NotYet; });
  });
  const auto seen = std::count_if(entries.begin(), entries.end(), [](const auto& e) { return e.inside == Inside::No; });
  EXPECT_EQ(seen, 1) << "the one that was asked for, and no other";
  controller_.lookInside({foreign.fileName(), path_});
  test::waitFor(controller_, told);
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
  controller_.runDetectors(
      {QStringLiteral("energy-ratio.onset-amplitude=1"), QStringLiteral("energy-ratio.chatter=1")});
  waitForTask();
  ASSERT_EQ(controller_.tracks().size(), 4U);
  for (const ui::DetectorTrack& track : controller_.tracks()) {
    if (track.detector != QStringLiteral("Energy ratio")) continue;
    EXPECT_TRUE(track.compared);
    EXPECT_GE(track.before.size(), 1U);
    EXPECT_NE(track.after, track.before) << "the limits have changed nothing";
  }
  controller_.score(false);
  waitForTask();
  ASSERT_EQ(controller_.scores().size(), 4U);
  for (const ui::ScoreLine& line : controller_.scores()) {
    EXPECT_EQ(line.spans, 1);
    if (line.detector == QStringLiteral("Energy ratio")) {
      EXPECT_EQ(line.found, 1);
    }
  }
}

TEST_F(ReplayDeskTest, ExportsTheSpan) {
  const QString file = folder_.filePath(QStringLiteral("span.wav"));
  controller_.exportSpan(Seconds(2.0), Seconds(3.0), file);
  waitForTask();
  const double frames = static_cast<double>(QFile(file).size()) /
                        (4.0 * static_cast<double>(controller_.summary()->setup.channels.size()));
  EXPECT_NEAR(frames / controller_.summary()->setup.rate.value, 1.0, 0.05);
}

// Files that end whoever reads them: the one that is open stays, and the screen says why.
TEST_F(ReplayDeskTest, NoFileThatKillsItsReaderEndsTheDesktop) {
  const QDir hostile(QStringLiteral(STILLCUT_SHARED_DIR "/cases_hostile"));
  const QStringList names = hostile.entryList({QStringLiteral("*.h5")}, QDir::Files);
  if (names.isEmpty()) GTEST_SKIP() << "no such files here";
  for (const QString& name : names) {
    const QString copy = folder_.filePath(name);
    ASSERT_TRUE(QFile::copy(hostile.filePath(name), copy));
    controller_.open(copy);
    test::waitFor(controller_, [this] { return !controller_.task().running; });
    EXPECT_TRUE(controller_.openedPath() == copy || !controller_.task().problem.isEmpty()) << name.toStdString();
  }
}

// One bad file is no reason to score none.
TEST_F(ReplayDeskTest, AFolderIsScoredAroundTheFileThatCannotBeRead) {
  mark(Seconds(2.4), Seconds(4.6), "chatter");
  const QString broken = folder_.filePath(QStringLiteral("Housing/broken.h5"));
  ASSERT_TRUE(QFile::copy(path_, broken));
  ASSERT_TRUE(QFile::resize(broken, QFile(broken).size() / 2)) << "a copy that broke off";
  controller_.setFolder(folder_.path());
  test::waitFor(controller_, [this] { return controller_.entries().size() == 2U; });
  controller_.score(true);
  waitForTask();
  ASSERT_EQ(controller_.scores().size(), 4U);
  for (const ui::ScoreLine& line : controller_.scores()) EXPECT_EQ(line.spans, 1) << line.detector.toStdString();
  ASSERT_EQ(controller_.notScored().size(), 1);
  EXPECT_TRUE(controller_.notScored()[0].contains(QStringLiteral("broken.h5")))
      << controller_.notScored()[0].toStdString();
}

TEST_F(ReplayDeskTest, LabelAndNoteOfASpanAreMendedInTheFile) {
  mark(Seconds(2.4), Seconds(4.0), "burr");
  ASSERT_TRUE(
      controller_.changeMark(controller_.markers()[0].number, QStringLiteral("burr, deep"), QStringLiteral("0.2 mm"))
          .ok());
  test::waitFor(controller_, [this] { return controller_.markers()[0].note == "0.2 mm"; });
  EXPECT_FALSE(controller_.changeMark(99, QStringLiteral("x"), {}).ok());
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
  controller_.setFolder(folder_.path());
  const auto listed = [this](const QString& name) {
    return std::any_of(controller_.scenarios().begin(), controller_.scenarios().end(),
                       [&name](const ui::SessionEntry& e) { return e.path.endsWith(name); });
  };
  test::waitFor(controller_, [&] { return listed(QStringLiteral("own.toml")); });
  EXPECT_TRUE(listed(QStringLiteral("scenarios/demo.toml"))) << "those of the program";
  EXPECT_FALSE(listed(QStringLiteral("notes.toml")));

  controller_.open(own);
  test::waitFor(controller_, [&] { return controller_.openedPath() == own && controller_.replayed() != nullptr; });
  const double length = controller_.replay().length.value;
  EXPECT_GT(length, 1.0);
  EXPECT_FALSE(controller_.summary()->session) << "nothing can be marked in it";
  controller_.goTo(Seconds(0.5));
  test::waitFor(controller_, [this] { return std::abs(controller_.replay().position.value - 0.5) < 0.1; });
  controller_.setPace(0.0);
  controller_.play();
  test::waitFor(controller_, [this] { return controller_.replay().finished; });
  test::waitFor(controller_, [this] { return controller_.summaryWhole(); });
  EXPECT_NEAR(controller_.summary()->length.value, length, 0.1);
  controller_.runDetectors({});
  waitForTask();
  EXPECT_EQ(controller_.tracks().size(), 4U);
  const QString file = folder_.filePath(QStringLiteral("own.wav"));
  controller_.exportSpan(Seconds(0.2), Seconds(0.7), file);
  waitForTask();
  EXPECT_GT(QFile(file).size(), 1000);
  controller_.open(file);
  test::waitFor(controller_, [&] { return controller_.openedPath() == file; });
  EXPECT_TRUE(QString::fromStdString(controller_.info().setup.machine).contains(QStringLiteral("own.wav")))
      << "of a machine that the file does not know: " << controller_.info().setup.machine;
}

TEST_F(ReplayDeskTest, WhatCannotBeReadIsASentence) {
  QFile broken(folder_.filePath(QStringLiteral("broken.h5")));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("nothing");
  broken.close();
  controller_.open(broken.fileName());
  test::waitFor(controller_, [this] { return !controller_.task().running; });
  EXPECT_TRUE(controller_.task().problem.contains(QStringLiteral("broken.h5")));
  EXPECT_EQ(controller_.openedPath(), path_) << "what was open stays";
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
  (*lobes)->ask({ui::LobeMethodChoice::ZerothOrder, frame.lowest, frame.highest, 40, frame.maxAxialDepth});
  EXPECT_TRUE(QTest::qWaitFor([&] { return (*lobes)->diagram() != nullptr; }, 60000));
  EXPECT_GE((*lobes)->diagram()->limits.size(), 40U);  // and more, where the line bends
  profile.pitch = {170.0, 190.0};
  auto uneven = LobeWorker::ofProfile(profile, path);
  ASSERT_TRUE(uneven.ok()) << uneven.error().line();
  (*uneven)->ask({ui::LobeMethodChoice::ZerothOrder, frame.lowest, frame.highest, 40, frame.maxAxialDepth});
  EXPECT_TRUE(QTest::qWaitFor([&] { return (*uneven)->progress().state == ui::LobeProgress::State::Failed; }, 60000));
  EXPECT_TRUE((*uneven)->progress().problem.contains(QStringLiteral("one pitch")))
      << "the lobes of an even pitch are not this tool's";
  EXPECT_EQ((*uneven)->diagram(), nullptr);
  profile.model = "nowhere.toml";
  const auto missing = LobeWorker::ofProfile(profile, path);
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().line().find("nowhere.toml"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::app
