// What phones and cameras make. Decoded in a process of its own; without libavformat, refused with the way out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <iterator>

#ifdef STILLCUT_MEDIA
#include "tests/support/media_file.h"
#endif
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

#ifdef STILLCUT_MEDIA

constexpr int kRate = 48'000;
constexpr double kTone_Hz = 1'000.0;
constexpr double kSeconds = 1.5;

// Amplitude of the tone in the middle second.
double toneIn(const std::vector<double>& values, double hz) {
  std::complex<double> sum;
  const std::size_t from = values.size() / 2 - kRate / 2;
  for (std::size_t i = 0; i < kRate; ++i)
    sum += values[from + i] * std::polar(1.0, -2.0 * M_PI * hz * static_cast<double>(i) / kRate);
  return 2.0 * std::abs(sum) / kRate;
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(MediaFiles, APhonesSoundIsReadByItsContent) {
  const TempFolder folder;
  for (const auto& [container, kind] : {std::pair{"ipod", AV_CODEC_ID_AAC},
                                        {"mp4", AV_CODEC_ID_AAC},
                                        {"mov", AV_CODEC_ID_PCM_S16LE},
                                        {"3gp", AV_CODEC_ID_AAC},
                                        {"adts", AV_CODEC_ID_AAC},
                                        {"asf", AV_CODEC_ID_WMAV2},
                                        {"matroska", AV_CODEC_ID_AAC},
                                        {"avi", AV_CODEC_ID_PCM_S16LE}}) {
    const std::string path = folder / "recording.dat";
    if (!test::MediaFile::write(path, container, kind, kRate, kSeconds, kTone_Hz)) {
      ADD_FAILURE() << "cannot make " << container;
      continue;
    }
    const WholeRecording all = readAll(path);
    ASSERT_EQ(all.error, "") << container;
    EXPECT_EQ(all.format.rate.value, kRate) << container;
    ASSERT_EQ(all.values.size(), 1U) << container;
    EXPECT_EQ(all.values[0].size(), static_cast<std::size_t>(all.format.frames)) << container;
    EXPECT_NEAR(static_cast<double>(all.format.frames) / kRate, kSeconds, 0.1) << "whole pieces, " << container;
    EXPECT_EQ(all.format.channels[0].info.quantity, SensorQuantity::Sound);
    EXPECT_NEAR(toneIn(all.values[0], kTone_Hz), 0.5, 0.03) << container;
    EXPECT_LT(toneIn(all.values[0], 1'370.0), 0.01) << container;
  }
}

TEST(MediaFiles, WhatIsDamagedEndsWithANoteOrIsRefusedInOneLine) {
  const TempFolder folder;
  const std::string path = folder / "whole.aac";
  ASSERT_TRUE(test::MediaFile::write(path, "adts", AV_CODEC_ID_AAC, kRate, kSeconds, kTone_Hz));
  const std::string whole = contentOf(path);
  const WholeRecording all = readAll(path);
  const WholeRecording half = readAll(folder.file("half.aac", whole.substr(0, whole.size() / 2)));
  ASSERT_EQ(half.error, "");
  EXPECT_NEAR(static_cast<double>(half.format.frames), 0.5 * static_cast<double>(all.format.frames), 0.1 * kRate);
  ASSERT_TRUE(test::MediaFile::write(path, "mp4", AV_CODEC_ID_AAC, kRate, kSeconds, kTone_Hz));
  const std::string boxes = contentOf(path);
  for (std::size_t keep = 100; keep < boxes.size(); keep += boxes.size() / 7) {
    const WholeRecording cut = readAll(folder.file("cut.mp4", boxes.substr(0, keep)));
    EXPECT_TRUE(cut.error.empty() || cut.error.find('\n') == std::string::npos) << cut.error;
    EXPECT_TRUE(!cut.error.empty() || cut.format.frames > 0);
  }
}

#else

TEST(MediaFiles, WithoutTheLibrariesTheRefusalNamesTheWayOut) {
  const TempFolder folder;
  const std::string head = std::string("\0\0\0\x20", 4) + "ftypM4A " + std::string(100, '\0');
  EXPECT_THAT(readAll(folder.file("memo.m4a", head)).error, HasSubstr("convert it to WAV: ffmpeg -i FILE cut.wav"));
}

#endif

}  // namespace
}  // namespace stillcut::record
