// The shared recordings as they are. Skipped, saying so, where the folder is absent.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/session/open_recording.h"

namespace stillcut::record {
namespace {

struct Expected {
  const char* path;
  double rateOption;  // 0: not given
  double rate;
  std::size_t channels;
  std::int64_t frames;
  SensorQuantity quantity;
};

class SharedRecording : public testing::TestWithParam<Expected> {};

TEST_P(SharedRecording, OpensAndReadsToItsEnd) {
  const Expected& e = GetParam();
  const std::filesystem::path path = std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings" / e.path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "not here: " << path;
  ReadOptions options;
  if (e.rateOption > 0.0) options.rate = Hertz(e.rateOption);
  const auto reader = openRecording(path.string(), options);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  const RecordingFormat& format = (*reader)->format();
  EXPECT_NEAR(format.rate.value, e.rate, 1e-9 * e.rate);
  ASSERT_EQ(format.channels.size(), e.channels);
  EXPECT_EQ(format.channels[0].info.quantity, e.quantity);
  EXPECT_EQ(format.frames, e.frames);
  SampleBlock block;
  block.allocate(static_cast<int>(e.channels), 512);
  std::int64_t frames = 0;
  bool ended = false;
  while (true) {
    const Result<bool> more = (*reader)->read(block);
    ASSERT_TRUE(more.ok()) << more.error().line();
    if (!*more) break;
    EXPECT_FALSE(block.has(kBlockGap));
    frames += block.frames;
    ended = block.has(kBlockEnd);
  }
  EXPECT_EQ(frames, e.frames);
  EXPECT_TRUE(ended);
}

using Q = SensorQuantity;
INSTANTIATE_TEST_SUITE_P(
    All, SharedRecording,
    testing::Values(Expected{"hurco_end_mill/EBI_F20IN_T100_D0p125IN_4000RPM.csv", 0, 1651, 3, 25600, Q::Acceleration},
                    Expected{"hurco_end_mill/EBI_F20IN_T75_D0p125IN_4000RPM.csv", 0, 1651, 3, 25600, Q::Acceleration},
                    Expected{"hurco_end_mill/EBI_T100_0p375IN_7000RPMto6000RPM.csv", 0, 1650, 3, 25600,
                             Q::Acceleration},
                    Expected{"hurco_end_mill/EBI_T25_0p25IN_6900RPM.csv", 0, 1651, 3, 25600, Q::Acceleration},
                    Expected{"hurco_end_mill/EBI_T50_0p25IN_6900RPM.csv", 0, 1650, 3, 25600, Q::Acceleration},
                    Expected{"slot_force/6-n6000f300ap3ae25.csv", 0, 10000, 3, 10001, Q::Force},
                    Expected{"slot_force/6-n6000f900ap3ae25.csv", 0, 10000, 3, 10001, Q::Force},
                    Expected{"turning_force_lvm/f416_a100.lvm", 0, 10000, 3, 65000, Q::Force},
                    Expected{"tap_test/impact_time_Point1_Channel1_CH1.txt", 0, 51200, 2, 51200, Q::Acceleration},
                    Expected{"lmas_milling_audio/audio_T2503", 8000, 8000, 1, 376239, Q::Acceleration},
                    Expected{"lmas_milling_audio/accel_T2503", 1000, 1000, 3, 47029, Q::Acceleration},
                    Expected{"face_mill_audio/Chatter.wav", 0, 48000, 2, 883712, Q::Sound},
                    Expected{"face_mill_audio/Stable.wav", 0, 48000, 2, 373760, Q::Sound},
                    Expected{"face_mill_audio/Idle Sound.wav", 0, 48000, 2, 547840, Q::Sound},
                    Expected{"uff_format_samples/Sample_UFF58b_bin.uff", 0, 65536, 1, 79292, Q::Sound},
                    Expected{"uff_format_samples/binary8byte.uff", 0, 100, 1, 250, Q::Acceleration}),
    [](const auto& instance) { return "number" + std::to_string(instance.index); });

TEST(SharedText, WithoutARateTheLineNamesTheOption) {
  const std::filesystem::path folder = std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "not here: " << folder;
  for (const char* name : {"lmas_milling_audio/audio_T2503", "lmas_milling_audio/accel_T2503"}) {
    const auto reader = openRecording((folder / name).string());
    ASSERT_FALSE(reader.ok());
    EXPECT_NE(reader.error().line().find("--rate"), std::string::npos) << reader.error().line();
  }
  for (const char* name :
       {"hurco_end_mill/TRUTH.csv", "lmas_milling_audio/metadata25.csv", "README.md",
        "uff_format_samples/sample_dataset58_psd.uff", "uff_format_samples/dataset_milestone_in_header.uff"}) {
    EXPECT_FALSE(openRecording((folder / name).string()).ok()) << name;
  }
}

}  // namespace
}  // namespace stillcut::record
