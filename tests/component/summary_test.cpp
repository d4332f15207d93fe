// The summary of a recording: sensors as they were, curves and spectrogram of bounded size, gaps counted; and of a
// history of features the same chatter as of the cut that it was kept of.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/compose/scenario_rig.h"
#include "core/evaluate/session_summary_builder.h"
#include "tests/support/demo_cut.h"
#include "tests/support/kept_features.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

class Recording {
 public:
  explicit Recording(const std::string& text)
      : path_((std::filesystem::temp_directory_path() / ("stillcut-summary-" + std::to_string(getpid()) + ".csv"))
                  .string()) {
    std::ofstream(path_) << text;
  }
  ~Recording() { std::remove(path_.c_str()); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// x: a sine of 1 g peak; y: the same, clipped at 0.5; z: nothing; w: a sine a hundredth as large on an offset.
std::string fourChannels(int frames) {
  std::string text = "t,x (g),y (m/s^2),z (m/s^2),w (m/s^2)\n";
  for (int i = 0; i < frames; ++i) {
    const double wave = std::sin(2.0 * M_PI * 50.0 * i / 1000.0 + 0.1);
    char line[120];
    std::snprintf(line, sizeof line, "%.3f,%.6f,%.6f,0,%.6f\n", i / 1000.0, wave, std::clamp(wave, -0.5, 0.5),
                  5.0 + 0.01 * wave);
    text += line;
  }
  return text;
}

TEST(Summary, SensorsAreCheckedInSiUnits) {
  const Recording file(fourChannels(4000));
  const auto summary = evaluate::summarizeRecording(file.path());
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  ASSERT_EQ(summary->sensors.size(), 4U);
  EXPECT_NEAR(summary->sensors[0].rms, 9.80665 / std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(summary->sensors[0].peak, 9.80665 * std::cos(0.1), 1e-3);
  EXPECT_EQ(summary->sensors[0].health, SensorHealth::InOrder);
  EXPECT_EQ(summary->sensors[1].health, SensorHealth::Clipped);
  EXPECT_EQ(summary->sensors[2].health, SensorHealth::Dead);
  EXPECT_EQ(summary->sensors[3].health, SensorHealth::Offset);
  EXPECT_FALSE(summary->session);
  EXPECT_NEAR(summary->length.value, 4.0, 1e-9);
}

TEST(Summary, LongRecordingsStaySmallAndKeepTheirPeak) {
  std::string text = "t,x (m/s^2)\n";
  constexpr int kFrames = 300'000;
  for (int i = 0; i < kFrames; ++i) {
    const bool burst = i >= 200'000 && i < 201'000;
    text += std::to_string(i) + "e-3," + (burst ? (i % 2 == 0 ? "7\n" : "-7\n") : (i % 2 == 0 ? "1\n" : "-1\n"));
  }
  const Recording file(text);
  const auto summary = evaluate::summarizeRecording(file.path());
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  EXPECT_LE(summary->curve.size(), 4096U);
  EXPECT_LE(summary->spectrogram.size(), 2048U);
  EXPECT_GT(summary->spectrogram.size(), 500U);
  const auto loudest = std::max_element(summary->curve.begin(), summary->curve.end(),
                                        [](const auto& a, const auto& b) { return a.vibration < b.vibration; });
  EXPECT_GT(loudest->vibration, 4.0);
  EXPECT_NEAR(loudest->time.value, 200.5, 1.5);
  for (std::size_t i = 1; i < summary->curve.size(); ++i) {
    ASSERT_GT(summary->curve[i].time.value, summary->curve[i - 1].time.value) << i;
  }
}

TEST(Summary, ASpanIsSummarizedAlone) {
  const Recording file(fourChannels(4000));
  const auto summary = evaluate::summarizeRecording(file.path(), {}, {Seconds(1.0), Seconds(3.0)});
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  EXPECT_NEAR(summary->length.value, 2.0, 1e-9);
  EXPECT_FALSE(evaluate::summarizeRecording(file.path(), {}, {Seconds(8.0), Seconds(9.0)}).ok());
}

// The demo's cut, everything kept.
std::string recordDemo(const std::string& path, const std::string& strategy, Authority authority) {
  ScenarioOptions options;
  options.methods.strategy = strategy;
  auto built = buildScenarioRig(test::demoCut(), options);
  EXPECT_TRUE(built.ok());
  EXPECT_TRUE(built->rig->recordTo(path, "").ok());
  built->rig->send({OperatorAction::SetAuthority, authority});
  built->rig->runToEnd({});
  EXPECT_TRUE(built->rig->recorder()->finish().ok());
  return path;
}

// The interval only says how much is kept. What it leaves out is the same as what is kept, so that no time is counted
// for a verdict that came later.
TEST(Summary, AHistoryOfFeaturesTellsTheChatterOfTheWholeRecording) {
  const record::TempFolder folder;
  struct Cut {
    const char* strategy;
    Authority authority;
  };
  for (const Cut& cut : {Cut{"monitor", Authority::Off}, Cut{"lobe-center", Authority::Auto}}) {
    SCOPED_TRACE(cut.strategy);
    const std::string whole = recordDemo(folder / (std::string(cut.strategy) + ".h5"), cut.strategy, cut.authority);
    const auto all = evaluate::summarizeRecording(whole);
    ASSERT_TRUE(all.ok()) << all.error().line();
    ASSERT_GE(all->alarms, 1U);
    const double block = all->setup.blockFrames / all->setup.rate.value;
    for (const double interval : {0.5, 1.0, 3.0}) {
      SCOPED_TRACE(interval);
      const std::string path = folder / (cut.strategy + std::to_string(interval) + ".h5");
      test::keepFeatures(whole, path, Seconds(interval));
      const auto kept = evaluate::summarizeRecording(path);
      ASSERT_TRUE(kept.ok()) << kept.error().line();
      EXPECT_EQ(kept->alarms, all->alarms);
      EXPECT_NEAR(kept->chatterTime.value, all->chatterTime.value, 1.5 * block);
      ASSERT_EQ(kept->interventions.size(), all->interventions.size());
      for (std::size_t k = 0; k < all->interventions.size(); ++k) {
        EXPECT_EQ(kept->interventions[k].began, all->interventions[k].began);
        EXPECT_EQ(kept->interventions[k].quiet, all->interventions[k].quiet);
        EXPECT_NEAR(kept->interventions[k].timeToStable.value, all->interventions[k].timeToStable.value, 1.5 * block);
      }
    }
  }
}

// The list is bounded; what it leaves out is counted, so that a report can say how many more.
TEST(Summary, EverySettingThatWasChangedIsCounted) {
  const record::TempFolder folder;
  const auto reader = record::openRecording(recordDemo(folder / "cut.h5", "monitor", Authority::Off));
  ASSERT_TRUE(reader.ok());
  record::SessionHeader header;
  header.setup = *(*reader)->format().setup;
  const auto writer = record::SessionWriter::create(folder / "tuned.h5", header);
  ASSERT_TRUE(writer.ok());
  SampleBlock block;
  block.allocate(static_cast<int>(header.setup.channels.size()), header.setup.blockFrames);
  for (int step = 0; step < 200; ++step) {
    ASSERT_TRUE(*(*reader)->read(block));
    StepInput input = (*reader)->recordedStep()->input;
    input.inputCount = 3;
    for (OperatorInput& asked : input.inputs) asked = {OperatorAction::SetParameter, Authority::Off, 0, 1, 0.5};
    ASSERT_TRUE((*writer)->add(input, (*reader)->recordedStep()->output).ok());
  }
  ASSERT_TRUE((*writer)->close().ok());
  const auto summary = evaluate::summarizeRecording(folder / "tuned.h5");
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  EXPECT_EQ(summary->settingChangeCount, 600U);
  EXPECT_LT(summary->settingChanges.size(), 600U);
  EXPECT_FALSE(summary->settingChanges.empty());
}

}  // namespace
}  // namespace stillcut::app
