// Sound files that break off or lie about their length: what is there is read, with a note; nothing of a library is
// told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr int kRate = 48'000, kFrames = 96'000;

std::string soundOf(const TempFolder& folder, const char* name, int format) {
  SF_INFO info{};
  info.channels = 1;
  info.samplerate = kRate;
  info.format = format;
  const std::string path = folder / name;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  if (file == nullptr) return {};
  std::vector<float> samples(kFrames);
  unsigned state = 1;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    state = state * 1664525U + 1013904223U;  // noise does not pack
    samples[i] =
        0.4F * std::sin(0.05F * static_cast<float>(i)) + 0.1F * (static_cast<float>(state >> 8U) / 16777216.0F);
  }
  sf_writef_float(file, samples.data(), kFrames);
  sf_close(file);
  return path;
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Kind {
  const char* name;
  int format;
};

class SoundDamage : public testing::TestWithParam<Kind> {};

TEST_P(SoundDamage, WhatIsThereIsReadWithANote) {
  const TempFolder folder;
  const std::string path = soundOf(folder, GetParam().name, GetParam().format);
  if (path.empty()) GTEST_SKIP() << "this libsndfile does not write " << GetParam().name;
  const WholeRecording whole = readAll(path);
  ASSERT_EQ(whole.error, "");
  EXPECT_TRUE(whole.format.notes.empty());
  EXPECT_NEAR(static_cast<double>(whole.format.frames), kFrames, 3000.0);
  const std::string content = contentOf(path);
  const WholeRecording part = readAll(folder.file(GetParam().name, content.substr(0, content.size() * 6 / 10)));
  ASSERT_EQ(part.error, "");
  EXPECT_GT(part.format.frames, kFrames / 3);
  EXPECT_LT(part.format.frames, kFrames * 7 / 10);
  EXPECT_EQ(static_cast<std::int64_t>(part.values.at(0).size()), part.format.frames);
  EXPECT_EQ(part.format.notes.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(All, SoundDamage,
                         testing::Values(Kind{"cut.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16},
                                         Kind{"cut.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS},
                                         Kind{"cut.mp3", SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III},
                                         Kind{"cut.aiff", SF_FORMAT_AIFF | SF_FORMAT_PCM_16},
                                         Kind{"cut.au", SF_FORMAT_AU | SF_FORMAT_PCM_16},
                                         Kind{"cut.w64", SF_FORMAT_W64 | SF_FORMAT_PCM_16},
                                         Kind{"cut.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16}),
                         [](const auto& instance) { return std::string(instance.param.name).substr(4); });

// Nothing of the decoder of MP3 is heard, neither on the error stream nor in the line.
TEST(SoundDamageTold, AnMp3WithoutSoundIsRefusedInOneLine) {
  const TempFolder folder;
  testing::internal::CaptureStderr();
  const std::string error = readAll(folder.file("cut.mp3", "ID3\4" + std::string(60, '\0'))).error;
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(error, HasSubstr("is no sound file that can be read"));
  EXPECT_THAT(error, testing::Not(HasSubstr("pipe")));
}

TEST(SoundDamageTold, AnRf64WithoutItsSizesIsAStream) {
  const TempFolder folder;
  std::string content = contentOf(soundOf(folder, "cut.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16));
  content.replace(0, 8, "RF64\xFF\xFF\xFF\xFF");
  content.replace(content.find("data") + 4, 4, "\xFF\xFF\xFF\xFF");
  const WholeRecording all = readAll(folder.file("cut.wav", content));
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.frames, kFrames);
  EXPECT_EQ(all.format.notes.size(), 1U);
}

}  // namespace
}  // namespace stillcut::record
