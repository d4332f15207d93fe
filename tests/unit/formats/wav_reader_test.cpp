// Sound files: what is written comes back, and damaged headers are named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "core/formats/sound/wav_reader.h"
#include "core/session/open_recording.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

SampleBlock ramp(int channels, int frames) {
  SampleBlock block;
  block.allocate(channels, frames);
  block.frames = frames;
  block.rate = Hertz(8000.0);
  for (int c = 0; c < channels; ++c) {
    for (int f = 0; f < frames; ++f)
      block.channel(c)[static_cast<std::size_t>(f)] = 0.001F * static_cast<float>(f) - 0.25F * static_cast<float>(c);
  }
  return block;
}

std::string writeRamp(const TempFolder& folder, int channels, int frames) {
  std::string path = folder / "ramp.wav";
  auto writer = WavWriter::create(path, channels, Hertz(8000.0));
  EXPECT_TRUE(writer.ok());
  EXPECT_TRUE((*writer)->write(ramp(channels, frames)).ok());
  EXPECT_TRUE((*writer)->finish().ok());
  return path;
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(WavFiles, FloatsComeBackBitByBitInBlocks) {
  const TempFolder folder;
  const auto reader = openRecording(writeRamp(folder, 2, 1000));
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  RecordingReader& wav = **reader;
  EXPECT_EQ(wav.format().frames, 1000);
  EXPECT_EQ(wav.format().channels.size(), 2U);
  EXPECT_EQ(wav.format().channels[0].info.quantity, SensorQuantity::Sound);
  EXPECT_FALSE(wav.format().channels[0].quantityKnown);
  const SampleBlock expected = ramp(2, 1000);
  SampleBlock block;
  block.allocate(2, 300);
  int at = 0;
  std::uint64_t sequence = 0;
  for (const int frames : {300, 300, 300, 100}) {
    const Result<bool> more = wav.read(block);
    ASSERT_TRUE(more.ok() && *more);
    ASSERT_EQ(block.frames, frames);
    EXPECT_EQ(block.sequence, sequence++);
    EXPECT_EQ(toNs(block.firstSample), at * 125'000LL);
    EXPECT_EQ(block.has(kBlockEnd), frames == 100);
    for (int c = 0; c < 2; ++c) {
      for (int f = 0; f < frames; ++f) {
        ASSERT_EQ(block.channel(c)[static_cast<std::size_t>(f)], expected.channel(c)[static_cast<std::size_t>(at + f)]);
      }
    }
    at += frames;
  }
  const Result<bool> more = wav.read(block);
  EXPECT_TRUE(more.ok() && !*more);
}

TEST(WavFiles, EveryPcmFormatIsReadAsAFractionOfFullScale) {
  const TempFolder folder;
  struct Case {
    int format;
    double step;
  };
  for (const Case c :
       {Case{SF_FORMAT_WAV | SF_FORMAT_PCM_U8, 1.0 / 128}, Case{SF_FORMAT_WAV | SF_FORMAT_PCM_16, 1.0 / 32768},
        Case{SF_FORMAT_WAV | SF_FORMAT_PCM_24, 1e-6}, Case{SF_FORMAT_WAV | SF_FORMAT_PCM_32, 1e-6},
        Case{SF_FORMAT_WAV | SF_FORMAT_DOUBLE, 1e-7}, Case{SF_FORMAT_WAVEX | SF_FORMAT_FLOAT, 1e-7},
        Case{SF_FORMAT_RF64 | SF_FORMAT_PCM_16, 1.0 / 32768}, Case{SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 1.0 / 32768}}) {
    const std::string path = folder / "pcm.wav";
    SF_INFO info{};
    info.channels = 1;
    info.samplerate = 44100;
    info.format = c.format;
    SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
    ASSERT_NE(file, nullptr);
    const std::vector<double> values{0.0, 0.5, -0.5, 0.25};
    sf_write_double(file, values.data(), 4);
    sf_close(file);
    const auto reader = openRecording(path);
    ASSERT_TRUE(reader.ok()) << reader.error().line();
    SampleBlock block;
    block.allocate(1, 16);
    const Result<bool> more = (*reader)->read(block);
    ASSERT_TRUE(more.ok() && *more);
    ASSERT_EQ(block.frames, 4);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(block.channel(0)[i], values[i], c.step) << std::hex << c.format;
  }
}

TEST(WavFiles, ChannelsArePickedInTheOrderAskedFor) {
  const TempFolder folder;
  ReadOptions options;
  options.channels = {2};
  options.quantity = SensorQuantity::Acceleration;
  options.scale = 50.0;
  const auto reader = openRecording(writeRamp(folder, 3, 8), options);
  ASSERT_TRUE(reader.ok());
  ASSERT_EQ((*reader)->format().channels.size(), 1U);
  EXPECT_EQ((*reader)->format().channels[0].info.quantity, SensorQuantity::Acceleration);
  EXPECT_DOUBLE_EQ((*reader)->format().channels[0].info.scale, 50.0);
  SampleBlock block;
  block.allocate(1, 8);
  const Result<bool> more = (*reader)->read(block);
  ASSERT_TRUE(more.ok() && *more);
  EXPECT_EQ(block.channel(0)[0], -0.5F);
}

TEST(WavFiles, TruncatedAtAnyByteIsRefusedWithOneLineOrReadWithANote) {
  const TempFolder folder;
  const std::string whole = contentOf(writeRamp(folder, 2, 200));
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    const std::string path = folder.file("cut.wav", whole.substr(0, size));
    const auto reader = openRecording(path);
    if (reader.ok()) {
      EXPECT_LT((*reader)->format().frames, 200) << size;
      EXPECT_EQ((*reader)->format().notes.size(), 1U) << size;
      continue;
    }
    EXPECT_THAT(reader.error().line(), testing::StartsWith(path));
    EXPECT_EQ(reader.error().line().find('\n'), std::string::npos);
  }
}

TEST(WavFiles, AHeaderThatPromisesMoreThanThereIsIsReadWithANote) {
  const TempFolder folder;
  const std::string whole = contentOf(writeRamp(folder, 2, 200));
  std::string huge = whole;
  const std::size_t data = whole.find("data");
  ASSERT_NE(data, std::string::npos);
  huge.replace(data + 4, 4, std::string("\xF0\xFF\xFF\x7F", 4));
  const auto reader = openRecording(folder.file("huge.wav", huge));
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  EXPECT_EQ((*reader)->format().frames, 200);
  ASSERT_EQ((*reader)->format().notes.size(), 1U);
  EXPECT_THAT(text((*reader)->format().notes.front()), HasSubstr("its recorder did not end it"));
}

// Sixteen bits, two channels, `sizes` as the header gives those of the file and of its samples.
std::string pcmWav(std::uint32_t riff, std::uint32_t data, const std::vector<std::int16_t>& samples) {
  const auto word = [](std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xffU);
    return text;
  };
  std::string wav = "RIFF" + word(riff, 4) + "WAVEfmt " + word(16, 4) + word(1, 2) + word(2, 2) + word(8000, 4) +
                    word(32000, 4) + word(4, 2) + word(16, 2) + "data" + word(data, 4);
  for (const std::int16_t sample : samples) wav += word(static_cast<std::uint16_t>(sample), 2);
  return wav;
}

TEST(WavFiles, ASizeOfNothingOrOfAPipeMeansAllThatIsThere) {
  const TempFolder folder;
  const std::vector<std::int16_t> samples{16384, -16384, 8192, 0, -8192, 1};
  for (const auto& [riff, data] : {std::pair{0U, 0U}, {36U, 0U}, {0xFFFFFFFFU, 0xFFFFFFFFU}}) {
    const auto reader = openRecording(folder.file("killed.wav", pcmWav(riff, data, samples)));
    ASSERT_TRUE(reader.ok()) << reader.error().line();
    EXPECT_EQ((*reader)->format().frames, 3);
    EXPECT_EQ((*reader)->format().rate.value, 8000.0);
    EXPECT_EQ((*reader)->format().notes.size(), 1U);
    SampleBlock block;
    block.allocate(2, 16);
    ASSERT_TRUE((*reader)->read(block).ok());
    ASSERT_EQ(block.frames, 3);
    EXPECT_FLOAT_EQ(block.channel(0)[0], 0.5F);
    EXPECT_FLOAT_EQ(block.channel(0)[2], -0.25F);
    EXPECT_FLOAT_EQ(block.channel(1)[0], -0.5F);
  }
}

// A file with holes: 4.5 GB that take no room.
TEST(WavFiles, ASizeThat32BitsDoNotHoldIsToldByWhatIsThere) {
  const TempFolder folder;
  constexpr std::uint64_t kBytes = 4'500'000'000;
  const std::string path =
      folder.file("long.wav", pcmWav(static_cast<std::uint32_t>(kBytes + 36), static_cast<std::uint32_t>(kBytes), {}));
  std::error_code problem;
  std::filesystem::resize_file(path, 44 + kBytes, problem);
  if (problem) GTEST_SKIP() << "no file of 4.5 GB with holes here: " << problem.message();
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  EXPECT_EQ((*reader)->format().frames, static_cast<std::int64_t>(kBytes / 4));
  ASSERT_EQ((*reader)->format().notes.size(), 1U);
  EXPECT_THAT(text((*reader)->format().notes.front()), HasSubstr("what 32 bits leave of 4500000000"));
}

// By what is in them: the names say nothing.
TEST(SoundFiles, EveryFormatOfTheLibraryIsToldByItsContent) {
  const TempFolder folder;
  for (const int format :
       std::initializer_list<int>{SF_FORMAT_AIFF, SF_FORMAT_AU, SF_FORMAT_AU | SF_ENDIAN_LITTLE, SF_FORMAT_CAF,
                                  SF_FORMAT_W64, SF_FORMAT_VOC, SF_FORMAT_NIST, SF_FORMAT_IRCAM, SF_FORMAT_AVR,
                                  SF_FORMAT_PAF, SF_FORMAT_SVX, SF_FORMAT_WAVEX, SF_FORMAT_RF64, SF_FORMAT_FLAC}) {
    const std::string path = folder / "recording.dat";
    SF_INFO info{};
    info.samplerate = 8000;
    info.channels = 1;
    info.format = format | SF_FORMAT_PCM_16;
    SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
    ASSERT_NE(file, nullptr) << std::hex << format << ": " << sf_strerror(nullptr);
    const std::vector<float> samples(500, 0.25F);
    ASSERT_EQ(sf_write_float(file, samples.data(), 500), 500);
    sf_close(file);
    const auto reader = openRecording(path);
    ASSERT_TRUE(reader.ok()) << std::hex << format << ": " << reader.error().line();
    EXPECT_EQ((*reader)->format().frames, 500) << std::hex << format;
    EXPECT_NEAR((*reader)->format().rate.value, 8000.0, 100.0) << "of VOC in whole microseconds";
  }
}

TEST(WavFiles, HeadersThatLieAreRefused) {
  const TempFolder folder;
  const std::string whole = contentOf(writeRamp(folder, 2, 200));
  std::string manyChannels = whole;
  manyChannels.replace(whole.find("fmt ") + 10, 2, std::string("\xFF\xFF", 2));
  EXPECT_FALSE(openRecording(folder.file("many.wav", manyChannels)).ok());
  EXPECT_FALSE(openRecording(folder.file("rubbish.wav", "this is no sound")).ok());
}

TEST(WavFiles, Rf64IsReadAndItsTruncationNoted) {
  const TempFolder folder;
  const std::string path = folder / "long.wav";
  SF_INFO info{};
  info.samplerate = 8000;
  info.channels = 1;
  info.format = SF_FORMAT_RF64 | SF_FORMAT_FLOAT;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  ASSERT_NE(file, nullptr);
  const std::vector<float> samples(500, 0.25F);
  ASSERT_EQ(sf_write_float(file, samples.data(), 500), 500);
  sf_close(file);
  const std::string whole = contentOf(path);
  ASSERT_TRUE(whole.starts_with("RF64"));
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  EXPECT_EQ((*reader)->format().frames, 500);
  const auto cut = openRecording(folder.file("cut.wav", whole.substr(0, whole.size() - 400)));
  ASSERT_TRUE(cut.ok()) << cut.error().line();
  EXPECT_EQ((*cut)->format().frames, 400);
  EXPECT_EQ((*cut)->format().notes.size(), 1U);
}

TEST(WavFiles, ASampleThatIsNoNumberEndsTheReadingWithItsPlace) {
  const TempFolder folder;
  const std::string path = folder / "nan.wav";
  auto writer = WavWriter::create(path, 2, Hertz(8000.0));
  ASSERT_TRUE(writer.ok());
  SampleBlock block = ramp(2, 10);
  block.channel(1)[7] = std::numeric_limits<float>::quiet_NaN();
  ASSERT_TRUE((*writer)->write(block).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok());
  const Result<bool> more = (*reader)->read(block);
  ASSERT_FALSE(more.ok());
  EXPECT_THAT(more.error().line(), HasSubstr("frame 7 of channel 1"));
}

TEST(WavFiles, AnUnfinishedWriterLeavesNothingBehind) {
  const TempFolder folder;
  {
    auto writer = WavWriter::create(folder / "x.wav", 1, Hertz(8000.0));
    ASSERT_TRUE(writer.ok());
    ASSERT_TRUE((*writer)->write(ramp(1, 10)).ok());
  }
  EXPECT_EQ(folder.files(), 0U);
  EXPECT_FALSE(WavWriter::create(folder / "no/such/folder.wav", 1, Hertz(8000.0)).ok());
}

TEST(OpenRecording, WhatIsNoFileIsNamed) {
  const TempFolder folder;
  const auto line = [](const std::string& path) {
    const auto reader = openRecording(path);
    return reader ? std::string("was accepted") : reader.error().line();
  };
  EXPECT_THAT(line(folder / "missing.wav"), HasSubstr("no such file"));
  EXPECT_THAT(line(folder / "."), HasSubstr("folder"));
  EXPECT_THAT(line("/dev/null"), HasSubstr("not a regular file"));
  EXPECT_THAT(line(folder.file("empty.wav", "")), HasSubstr("empty"));
}

}  // namespace
}  // namespace stillcut::record
