// What a session and its folder hand to the pages: the tools, the values of the Tune page, another run in its place.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/session/last_run.h"
#include "app/session/session.h"
#include "app/session/tool_library.h"
#include "core/detect/caliskan/energy_ratio.h"
#include "core/milling/stability/lobe_case.h"

namespace stillcut::app {
namespace {

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
  tool.lowestSpeed_rpm = 2000.0;
  tool.stickOut_mm = 48.0;
  tool.deepest_mm = 26.0;
  tool.response = QStringLiteral("t12.csv");
  tool.material = QStringLiteral("1045");
  tool.history = {{QStringLiteral("2026-05-04"), QStringLiteral("modes: t12.toml")}};
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

TEST(ToolLibrary, AFileOfModesIsAModesFileOrAWholeCutAndNothingElse) {
  const QTemporaryDir folder;
  const auto file = [&](const char* name, const char* content) {
    QFile out(folder.filePath(QLatin1String(name)));
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(content);
    return out.fileName().toStdString();
  };
  const char* const modes =
      "[[mode]]\nfrequency_hz = 900.0\ndamping = 0.03\nstiffness_n_per_m = 2e7\ndirection = [1.0, 0.0]\n";
  EXPECT_TRUE(checkModesFile(file("modes.toml", modes)).ok());
  const Status letter = checkModesFile(file("letter.toml", "dear = \"customer\"\n"));
  ASSERT_FALSE(letter.ok());
  EXPECT_NE(letter.error().line().find("letter.toml"), std::string::npos) << letter.error().line();
  EXPECT_FALSE(checkModesFile(folder.filePath(QStringLiteral("absent.toml")).toStdString()).ok());
  EXPECT_FALSE(checkResponseFile(file("letter.csv", "Dear customer,\nthank you.\n")).ok());
  EXPECT_TRUE(
      checkResponseFile(file("frf.csv",
                             "Frequency [Hz],Re [m/N],Im [m/N]\n100,1e-8,-1e-9\n101,1e-8,-2e-9\n102,2e-8,-3e-9\n"
                             "103,2e-8,-3e-9\n104,2e-8,-3e-9\n"))
          .ok());
}

TEST(ToolLibrary, AToolWithModesAloneGivesItsProfileAWholeCutOnceItsMaterialIsSaid) {
  const QTemporaryDir folder;
  const QString modes = folder.filePath(QStringLiteral("modes.toml"));
  QFile file(modes);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("[[mode]]\nfrequency_hz = 900.0\ndamping = 0.03\nstiffness_n_per_m = 2e7\ndirection = [1.0, 0.0]\n");
  file.close();
  MachineSetup setup;
  setup.keepIn(folder.path());
  ui::ToolEntry tool;
  tool.name = QStringLiteral("T12 D12/Z4");
  tool.teeth = 4;
  tool.diameter_mm = 12.0;
  tool.modes = modes;
  const auto without = setup.cutFile(tool);
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().line().find("say what the tool cuts"), std::string::npos) << without.error().line();
  tool.material = QStringLiteral("1045");
  const auto cut = setup.cutFile(tool);
  ASSERT_TRUE(cut) << cut.error().line();
  const auto back = milling::loadLobeCase(cut->toStdString());
  ASSERT_TRUE(back) << back.error().line();
  EXPECT_EQ(back->model.tool.teeth, 4);
  EXPECT_DOUBLE_EQ(back->model.engagement.radialImmersion, 1.0);
  EXPECT_EQ(back->model.modes.size(), 1U);
  tool.modes = *cut;
  const auto whole = setup.cutFile(tool);
  ASSERT_TRUE(whole);
  EXPECT_EQ(*whole, *cut) << "a whole cut is taken as it is";
}

TEST(LastRun, TheNextStartKnowsTheMachineAndHowItsRunEnded) {
  const QTemporaryDir folder;
  const QString mill = folder.filePath(QStringLiteral("mill.toml")), cut = folder.filePath(QStringLiteral("cut-12.h5"));
  EXPECT_TRUE(LastRun(folder.path()).before().profile.isEmpty());
  {
    LastRun killed(folder.path());
    killed.begin(mill);
    killed.recordTo(cut);
  }
  const LastRun after(folder.path());
  EXPECT_EQ(after.before().profile, mill);
  EXPECT_TRUE(after.before().endedBadly);
  EXPECT_TRUE(after.sentence().contains(QStringLiteral("cut-12.h5"))) << after.sentence().toStdString();
  {
    LastRun orderly(folder.path());
    orderly.begin(mill);
    orderly.end();
    orderly.begin({});  // the demonstration
  }
  const LastRun then(folder.path());
  EXPECT_EQ(then.before().profile, mill) << "no demonstration takes a machine's place";
  EXPECT_TRUE(then.sentence().isEmpty());
}

TEST(Session, EveryAutomaticParameterSaysHowItIsChosenAndWhatRunsWhatItChose) {
  auto session = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", false);
  ASSERT_TRUE(session.ok()) << session.error().line();
  int automatic = 0;
  for (const ui::TunableComponent& part : (*session)->tuning()->tunableParts()) {
    for (const config::ParamDecl* decl : part.params) {
      if (!decl->mayBeAutomatic) continue;
      ++automatic;
      EXPECT_NE(decl->meaning.find("auto: "), std::string_view::npos) << decl->key;
      if (part.running && part.role == ui::TunableComponent::Role::Detector) {
        EXPECT_EQ(part.chosen.count(decl->key), 1U) << decl->key;
      }
    }
  }
  EXPECT_GT(automatic, 10);
}

// Seen and heard first, then it ends, and the cut is quieter than it was.
TEST(Session, TheDemonstrationShowsChatterAndItsEnd) {
  auto session = openDemonstrationSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", false);
  ASSERT_TRUE(session.ok()) << session.error().line();
  const Snapshot* s = nullptr;
  while ((*session)->advance()) {
    s = (*session)->pull();
    if (s != nullptr && sinceEpoch(s->time) > Seconds(10.0)) break;
  }
  ASSERT_NE(s, nullptr);
  ASSERT_EQ(s->interventionCount, 1U);
  const Intervention& card = s->interventions[0];
  EXPECT_TRUE(card.finished && card.quiet);
  EXPECT_EQ(card.outcome, MoveOutcome::Helped);
  EXPECT_GT(s->chatterTime, Seconds(1.0)) << "long enough to be seen";
  EXPECT_LT(card.timeToStable, Seconds(3.0));
  EXPECT_LT(card.vibrationAfter, 0.6 * card.vibrationBefore) << "of what it was";
  EXPECT_LT(s->vibrationRms, 0.6 * card.vibrationBefore);
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
  config::ParamSet values = (*session)->tuning()->controller().values();
  ASSERT_TRUE(values.set(detect::kErChatter, 0.35, "test").ok());
  const auto kept = (*session)->tuning()->saveValues(values);
  ASSERT_TRUE(kept.ok()) << kept.error().line();
  QFile file(kept.value());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("chatter = 0.35"));
  (*session)->tuning()->controller().set(detect::kErChatter, 0.4);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return (*session)->pull() != nullptr && !(*session)->tuning()->controller().pending(); }, 20000));
  EXPECT_DOUBLE_EQ((*session)->liveInfo().limits.energyRatio, 0.4) << "the limit that is drawn is the one that decides";
  EXPECT_EQ((*session)->sessions()->tunedSettings(), QStringList{QStringLiteral("energy-ratio.chatter=0.4")});
  ASSERT_TRUE((*session)->setup()->startDemonstration().ok());
  EXPECT_GT((*session)->generation(), before);
  EXPECT_TRUE(QTest::qWaitFor([&] { return (*session)->pull() != nullptr; }, 20000)) << "the new cut moves";
  config::Profile nothing;  // no device
  const Status refused = (*session)->setup()->start(nothing, QStringLiteral("new"));
  ASSERT_FALSE(refused.ok());
  EXPECT_TRUE((*session)->setup()->profiles().isEmpty());
  const auto now = (*session)->generation();
  const std::uint64_t seen = (*session)->pull()->number;
  EXPECT_TRUE(QTest::qWaitFor([&] { return (*session)->pull()->number > seen; }, 20000))
      << "a profile is looked at before what runs is stopped";
  EXPECT_EQ((*session)->generation(), now);
  EXPECT_TRUE((*session)->stop().ok());
}

}  // namespace
}  // namespace stillcut::app
