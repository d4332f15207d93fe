// The desk behind the page for a file, on recordings made here: its answer is that of `stillcut-cli analyze`, and what
// was recorded stays as it was recorded.
#include "app/session/file/file_controller.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>

#include "app/compose/recording_rig.h"
#include "app/compose/scenario_rig.h"
#include "app/session/file/indicator_curve.h"
#include "core/evaluate/answer_text.h"
#include "tests/support/demo_cut.h"
#include "tests/support/field_cases/slot_chatter.h"
#include "tests/support/field_cases/wav_header.h"
#include "tests/ui/support/wait_for.h"

namespace stillcut::app {
namespace {

constexpr auto kMain = ui::FileController::Main;
constexpr auto kBeside = ui::FileController::Beside;

// What the command says, by its own parts.
RecordingAnswer answerOfCommand(const QString& path, int teeth, Rpm speed) {
  RecordingOptions options;
  options.teeth = teeth;
  options.speed = speed;
  auto built = buildRecordingRig(path.toStdString(), options);
  EXPECT_TRUE(built);
  evaluate::RecordingJudge judge(built->rig->chain(), built->judged);
  built->rig->runToEnd([&](const StepInput& in, const StepOutput& out) { judge.observe(in, out); });
  return judge.answer(0);
}

class FileDesk : public testing::Test {
 protected:
  // A slot in aluminium with two flutes, chatter from 1.5 s on.
  QString chatter() {
    const auto made = field::wavFile(
        field::slotChatter({.speed = 10'100.0, .order = 7.9, .entry = 0.5, .stable = 1.5, .exit = 5.0, .length = 5.5}),
        field::WavHeader::Killed);
    return write(QStringLiteral("cut.wav"), made.content);
  }
  QString write(const QString& name, const std::string& content) {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content.data(), static_cast<qint64>(content.size()));
    return file.fileName();
  }
  void settle() {
    test::waitFor(desk_, [this] {
      return !desk_.reading(kMain).running && !desk_.answering(kMain).running && !desk_.comparing();
    });
  }

  QTemporaryDir folder_;
  DeskFileController desk_;
};

// Chatter from the entry on, close beside the eighth order: what is followed by its phases is pulled onto it (9868
// rev/min for 7.816 orders), so that exactly four waves seemed to fit between two teeth and the nearest stable speed
// was not named.
TEST_F(FileDesk, TheSpeedOfTheAnswerIsTheSpindlesAndNotTheChatters) {
  for (const double order : {7.816, 8.05}) {
    field::SlotChatter slot;
    slot.order = order;
    slot.begin = field::ChatterBegin::Entry;
    slot.entry = 0.5;
    slot.exit = 5.0;
    slot.length = 5.5;
    const QString path =
        write(QStringLiteral("slot.wav"), field::wavFile(field::slotChatter(slot), field::WavHeader::Killed).content);
    const RecordingAnswer answer = answerOfCommand(path, 2, Rpm(10'100.0));
    ASSERT_EQ(answer.finding, Finding::Chatter) << order;
    EXPECT_NEAR(answer.advice.present.value, 10'100.0, 10.0) << order;
    EXPECT_NEAR(answer.advice.waves, 0.5 * order, 0.01) << order;
  }
}

TEST_F(FileDesk, SaysWhatTheCommandSays) {
  const QString path = chatter();
  desk_.open(kMain, path);
  desk_.ask(kMain, {2, Rpm(10'100.0)});
  settle();
  const RecordingAnswer right = answerOfCommand(path, 2, Rpm(10'100.0));
  ASSERT_EQ(right.finding, Finding::Chatter);
  const auto answer = desk_.answer(kMain);
  ASSERT_NE(answer, nullptr);
  EXPECT_EQ(answer->finding, right.finding);
  EXPECT_EQ(answer->chatter, right.chatter);
  const evaluate::AnswerWriting writing = screenWriting();
  const QString told = QString::fromStdString(text(evaluate::findingSentence(right, writing)));
  EXPECT_EQ(answer->headline.toLower(), told.toLower());
  EXPECT_EQ(answer->advice.mid(1).toStdString(), text(evaluate::adviceSentence(right.advice, writing)).substr(1));
  EXPECT_TRUE(answer->advice.contains(QStringLiteral("rpm"))) << answer->advice.toStdString();
  EXPECT_GT(answer->tracks.size(), 1U) << "every detector has its row";
  const auto& states = answer->tracks.front().states;
  ASSERT_FALSE(states.empty());
  for (std::size_t k = 1; k < states.size(); ++k) EXPECT_LE(states[k - 1].end.value, states[k].begin.value + 1e-6);
  EXPECT_NEAR(states.back().end.value, desk_.contents(kMain)->length.value, 1e-3);
  const ui::FileCurve& curve = answer->tracks.front().curve;
  EXPECT_EQ(curve.name, QStringLiteral("er"));
  EXPECT_NEAR(curve.step.value * static_cast<double>(curve.highest.size()), states.back().end.value, 0.2);
  EXPECT_GT(*std::max_element(curve.highest.begin(), curve.highest.end(),
                              [](float a, float b) { return std::isnan(a) || a < b; }),
            curve.limit);
}

TEST(IndicatorCurve, KeepsTheLargestWhateverTheLength) {
  IndicatorCurve line;
  Verdict verdict;
  const double end = 3600.0;
  for (double t = 0.0; t < end; t += 0.1) {
    verdict.valid = t < 1000.0 || t > 1200.0;
    verdict.indicators[0] = std::abs(t - 2000.0) < 0.05 ? 0.9 : 0.1;
    line.add(verdict, Seconds(t), Seconds(t + 0.1));
  }
  const ui::FileCurve curve = line.curve({}, 0.3);
  ASSERT_LE(curve.highest.size(), IndicatorCurve::kMost);
  const auto at = [&](double t) { return curve.highest.at(static_cast<std::size_t>(t / curve.step.value)); };
  EXPECT_NEAR(at(2000.05), 0.9, 1e-6);
  EXPECT_NEAR(at(2500.0), 0.1, 1e-6);
  EXPECT_TRUE(std::isnan(at(1100.0)));
  EXPECT_NEAR(at(end - 1.0), 0.1, 1e-6);
}

TEST_F(FileDesk, WhatIsLackingIsSaidAndTheFileReadWithIt) {
  const auto table = [](const std::string& header, bool times) {
    std::string text = header;
    for (int i = 0; i < 4000; ++i) {
      const std::string value = std::to_string(std::sin(0.7 * i));
      text += times ? std::to_string(0.1 * i) + "," + value + "\n" : value + ",0.5\n";
    }
    return text;
  };
  desk_.open(kMain, write(QStringLiteral("ms.csv"), table("time,ax\n", true)));
  settle();
  EXPECT_EQ(desk_.contents(kMain), nullptr);
  EXPECT_EQ(desk_.lacking(kMain), ui::FileLack::TimeUnit);
  desk_.tellTiming(kMain, {Hertz(), 1e-3});
  settle();
  EXPECT_EQ(desk_.lacking(kMain), ui::FileLack::None);
  ASSERT_NE(desk_.contents(kMain), nullptr);
  EXPECT_NEAR(desk_.contents(kMain)->rate.value, 10'000.0, 1e-3);
  EXPECT_NE(desk_.answer(kMain), nullptr) << "judged with it as well";

  desk_.open(kMain, write(QStringLiteral("bare.csv"), table("ax,ay\n", false)));
  settle();
  EXPECT_EQ(desk_.lacking(kMain), ui::FileLack::Rate);
  desk_.tellTiming(kMain, {Hertz(8'000.0), 0.0});
  settle();
  ASSERT_NE(desk_.contents(kMain), nullptr);
  EXPECT_NEAR(desk_.contents(kMain)->rate.value, 8'000.0, 1e-3);

  desk_.open(kMain, write(QStringLiteral("letter.csv"), "no numbers\n"));
  settle();
  EXPECT_EQ(desk_.lacking(kMain), ui::FileLack::None);
}

TEST_F(FileDesk, AnotherQuestionTakesThePlaceOfTheOneBefore) {
  const QString path = chatter();
  desk_.open(kMain, path);
  for (int teeth = 1; teeth <= 4; ++teeth) desk_.ask(kMain, {teeth, Rpm(9'000.0)});
  desk_.ask(kMain, {2, Rpm(10'100.0)});
  EXPECT_EQ(desk_.asked(kMain), (ui::FileQuestion{2, Rpm(10'100.0)}));
  settle();
  ASSERT_NE(desk_.answer(kMain), nullptr);
  EXPECT_EQ(desk_.answer(kMain)->question, desk_.asked(kMain));
  EXPECT_EQ(desk_.answer(kMain)->teeth, 2);
  test::waitFor(desk_, [this] { return desk_.findings().speed_rpm.value > 0.0; });
  EXPECT_NEAR(desk_.findings().speed_rpm.value, 10'100.0, 60.0);
}

TEST_F(FileDesk, TheWholeFileAndAnyStretchOfIt) {
  desk_.open(kMain, chatter());
  settle();
  const auto file = desk_.contents(kMain);
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(file->channels.size(), 1U);
  EXPECT_NEAR(file->length.value, 5.5, 0.01);
  EXPECT_EQ(file->channels.front().wave.samples(), std::llround(file->length.value * file->rate.value));
  EXPECT_FALSE(file->notes.isEmpty()) << "the header of a killed recorder is told";
  EXPECT_FALSE(file->recorded.has_value());
  desk_.askSpectra(kMain, {0, 2048, SpectraWindow::Hann, 0.5, Seconds(3.0), Seconds(4.0), 300});
  test::waitFor(desk_, [this] { return desk_.spectra(kMain) != nullptr; });
  const auto spectra = desk_.spectra(kMain);
  const float* column = spectra->column(spectra->columnAt(Seconds(3.5)));
  const double loudest =
      spectra->binWidth * static_cast<double>(std::max_element(column, column + spectra->bins) - column);
  EXPECT_NEAR(loudest, 7.9 * 10'100.0 / 60.0, 2.0 * spectra->binWidth);
}

TEST_F(FileDesk, WhatWasRecordedIsShownAsRecordedWhateverIsAsked) {
  const std::string path = folder_.filePath(QStringLiteral("demo.h5")).toStdString();
  ScenarioOptions options;
  options.methods.strategy = "monitor";
  auto built = buildScenarioRig(test::demoCut(), options);
  ASSERT_TRUE(built.ok());
  ASSERT_TRUE(built->rig->recordTo(path, "").ok());
  built->rig->runToEnd({});
  ASSERT_TRUE(built->rig->recorder()->finish().ok());
  desk_.open(kMain, QString::fromStdString(path));
  settle();
  const auto file = desk_.contents(kMain);
  ASSERT_NE(file, nullptr);
  ASSERT_TRUE(file->recorded.has_value());
  EXPECT_GT(file->wallMs, 0);
  EXPECT_GT(file->told.teeth, 0);
  const std::vector<ui::FileState> before = file->recorded->states;
  ASSERT_TRUE(std::any_of(before.begin(), before.end(), [](const auto& s) { return s.state == CutState::Chatter; }));
  desk_.ask(kMain, {7, Rpm(4'000.0)});
  desk_.askSpectra(kMain, {0, 512, SpectraWindow::Hann, 0.5, Seconds(1.0), Seconds(1.5), 100});
  settle();
  const std::vector<ui::FileState>& after = desk_.contents(kMain)->recorded->states;
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t k = 0; k < after.size(); ++k) EXPECT_EQ(after[k].state, before[k].state);
}

TEST_F(FileDesk, TheOneBesideHasAQuestionAndAnAnswerOfItsOwn) {
  const QString path = chatter();
  desk_.open(kMain, path);
  desk_.ask(kMain, {2, Rpm(10'100.0)});
  desk_.open(kBeside, path);
  EXPECT_EQ(desk_.asked(kBeside), ui::FileQuestion());
  desk_.ask(kBeside, {2, Rpm(10'100.0)});
  settle();
  test::waitFor(desk_, [this] { return !desk_.answering(kBeside).running; });
  ASSERT_NE(desk_.answer(kBeside), nullptr);
  EXPECT_EQ(desk_.answer(kBeside)->finding, Finding::Chatter);
  EXPECT_EQ(desk_.answer(kBeside)->headline, desk_.answer(kMain)->headline);
  EXPECT_EQ(desk_.answer(kBeside)->tracks.size(), 1U) << "of the first detector";
  desk_.ask(kBeside, {3, Rpm(10'100.0)});
  EXPECT_EQ(desk_.asked(kMain), (ui::FileQuestion{2, Rpm(10'100.0)}));
  EXPECT_FALSE(desk_.answering(kMain).running);
}

TEST_F(FileDesk, AFileThatCannotBeReadSaysWhyAndASecondOneLiesBeside) {
  desk_.open(kMain, folder_.filePath(QStringLiteral("none.wav")));
  settle();
  EXPECT_EQ(desk_.contents(kMain), nullptr);
  EXPECT_EQ(desk_.answer(kMain), nullptr);
  EXPECT_FALSE(desk_.reading(kMain).problem.isEmpty());
  desk_.open(kMain, write(QStringLiteral("letter.csv"), "dear machine,\nstop it\n"));
  settle();
  EXPECT_FALSE(desk_.reading(kMain).problem.isEmpty());

  const QString path = chatter();
  desk_.open(kMain, path);
  desk_.open(kBeside, path);
  settle();
  test::waitFor(desk_, [this] { return desk_.contents(kBeside) != nullptr; });
  desk_.close(kBeside);
  EXPECT_EQ(desk_.answer(kBeside), nullptr);
  EXPECT_EQ(desk_.contents(kBeside), nullptr);
  EXPECT_NE(desk_.contents(kMain), nullptr);
}

}  // namespace
}  // namespace stillcut::app
