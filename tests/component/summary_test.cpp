// The summary of a recording: sensors as they were, curves and spectrogram of bounded size, gaps counted.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/compose/session_summary_builder.h"

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
  const auto summary = summarizeRecording(file.path());
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
  const auto summary = summarizeRecording(file.path());
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
  const auto summary = summarizeRecording(file.path(), {}, {Seconds(1.0), Seconds(3.0)});
  ASSERT_TRUE(summary.ok()) << summary.error().line();
  EXPECT_NEAR(summary->length.value, 2.0, 1e-9);
  EXPECT_FALSE(summarizeRecording(file.path(), {}, {Seconds(8.0), Seconds(9.0)}).ok());
}

}  // namespace
}  // namespace stillcut::app
