// Export: converted recordings open again and say the same.
#include "core/session/convert_recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/formats/gap_list.h"
#include "core/session/file/session_reader.h"
#include "core/session/file/session_writer.h"
#include "core/session/open_recording.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

SampleBlock readBlock(const std::string& path) {
  SampleBlock block;
  auto reader = openRecording(path);
  EXPECT_TRUE(reader.ok()) << (reader ? "" : reader.error().line());
  if (!reader) return block;
  block.allocate(static_cast<int>((*reader)->format().channels.size()), 64);
  const Result<bool> more = (*reader)->read(block);
  EXPECT_TRUE(more.ok() && *more);
  return block;
}

constexpr std::string_view kCut = "t,Accel X (g),Fy (kN)\n0,1,2\n0.001,3,4\n0.002,5,6\n0.005,7,8\n0.006,9,10\n";

TEST(Convert, CsvIsInSiUnitsAndKeepsGapsAndQuantities) {
  const TempFolder folder;
  const std::string to = folder / "out.csv";
  ASSERT_TRUE(convertRecording(folder.file("in.csv", kCut), to).ok());
  const auto reader = openRecording(to);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  const RecordingFormat& format = (*reader)->format();
  EXPECT_DOUBLE_EQ(format.rate.value, 1000.0);
  ASSERT_EQ(format.channels.size(), 2U);
  EXPECT_EQ(format.channels[0].info.quantity, SensorQuantity::Acceleration);
  EXPECT_EQ(format.channels[1].info.quantity, SensorQuantity::Force);
  EXPECT_DOUBLE_EQ(format.channels[0].info.scale, 1.0);
  SampleBlock block;
  block.allocate(2, 64);
  Result<bool> more = (*reader)->read(block);
  ASSERT_TRUE(more.ok() && *more);
  EXPECT_EQ(block.frames, 3);
  EXPECT_FLOAT_EQ(block.channel(0)[1], 3.0F * 9.80665F);
  EXPECT_FLOAT_EQ(block.channel(1)[1], 4000.0F);
  more = (*reader)->read(block);
  ASSERT_TRUE(more.ok() && *more);
  EXPECT_EQ(block.lostFrames, 2U);
}

TEST(Convert, OtherProgramsFindZerosInTheGapsOfASoundFileAndAListBesideIt) {
  const TempFolder folder;
  const std::string to = folder / "out.wav";
  ASSERT_TRUE(convertRecording(folder.file("in.csv", kCut), to).ok());
  std::ifstream list(gapListPath(to));
  const std::string text{std::istreambuf_iterator<char>(list), {}};
  EXPECT_EQ(text, "first_frame,frames,from_s,to_s\n3,2,0.003000000,0.005000000\n");
  std::filesystem::remove(gapListPath(to));
  const SampleBlock block = readBlock(to);
  ASSERT_EQ(block.frames, 7);
  EXPECT_FLOAT_EQ(block.channel(0)[2], 5.0F * 9.80665F);
  EXPECT_EQ(block.channel(0)[3], 0.0F);
  EXPECT_EQ(block.channel(1)[4], 0.0F);
  EXPECT_FLOAT_EQ(block.channel(1)[6], 10000.0F);
}

TEST(Convert, ASessionBecomesATable) {
  const TempFolder folder;
  const std::string from = folder / "in.h5";
  auto writer = SessionWriter::create(from, {exampleSetup(), "", "0.1.0", false});
  ASSERT_TRUE(writer.ok());
  StepRecord step = exampleStep(1);
  step.input.block.firstSample = Instant{};
  ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  ASSERT_TRUE((*writer)->close().ok());
  const std::string to = folder / "out.csv";
  const Status converted = convertRecording(from, to);
  ASSERT_TRUE(converted.ok()) << converted.error().line();
  const SampleBlock block = readBlock(to);
  ASSERT_EQ(block.frames, step.input.block.frames);
  EXPECT_FLOAT_EQ(block.channel(1)[3],
                  static_cast<float>(step.input.block.channel(1)[3] * exampleSetup().channels[1].scale));
}

TEST(Convert, ATableOfALiveSessionBeginsAtZeroAndOneOfASpanWhereTheSpanDoes) {
  const TempFolder folder;
  const std::string from = folder / "in.h5";
  auto writer = SessionWriter::create(from, {exampleSetup(), "", "0.1.0", false});
  ASSERT_TRUE(writer.ok());
  StepRecord step = exampleStep(1);
  for (int i = 0; i < 8; ++i) {
    step.input.block.frames = 64;
    step.input.block.flags = 0;
    step.input.block.lostFrames = 0;
    step.input.block.rate = exampleSetup().rate;
    step.input.block.firstSample =
        instantFromNs(86'045'000'000'000) + toDuration(Seconds(i * 64 / exampleSetup().rate.value));
    ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  ASSERT_TRUE((*writer)->close().ok());
  const auto firstTime = [&](const TimeSpan& span) {
    const std::string to = folder / "out.csv";
    const Status converted = convertRecording(from, to, {}, span);
    EXPECT_TRUE(converted.ok()) << converted.error().line();
    std::ifstream in(to);
    std::string line;
    std::getline(in, line);
    std::getline(in, line);
    return std::stod(line);
  };
  EXPECT_NEAR(firstTime({}), 0.0, 1e-9);
  TimeSpan span;
  span.from = Seconds(320.0 / exampleSetup().rate.value);
  EXPECT_NEAR(firstTime(span), span.from->value, 1e-6);
}

TEST(Convert, NoSessionIsReplaced) {
  const TempFolder folder;
  const std::string session = folder / "cut.h5";
  auto writer = SessionWriter::create(session, {exampleSetup(), "", "0.1.0", false});
  ASSERT_TRUE(writer.ok());
  const StepRecord step = exampleStep(1);
  ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  ASSERT_TRUE((*writer)->close().ok());
  const std::string other = folder.file("other.csv", "Time (s),ax (g)\n0,1\n0.001,2\n0.002,3\n");
  const Status converted = convertRecording(other, session);
  ASSERT_FALSE(converted.ok());
  EXPECT_THAT(converted.error().line(), testing::HasSubstr("is not replaced"));
  EXPECT_TRUE(countSession(session).ok());
}

TEST(Convert, WhatFailsLeavesNothingBehind) {
  const TempFolder folder;
  const std::string good = folder.file("in.csv", kCut);
  const std::string bad = folder.file("bad.csv", std::string(kCut) + "0.0001,1,1\n");
  const std::string pause = folder.file("pause.csv", std::string(kCut) + "99,1,2\n");
  EXPECT_FALSE(convertRecording(good, folder / "out.xyz").ok());
  EXPECT_FALSE(convertRecording(bad, folder / "out.wav").ok());
  EXPECT_FALSE(convertRecording(pause, folder / "out.wav").ok());
  EXPECT_FALSE(convertRecording(good, folder / "no/folder.csv").ok());
  EXPECT_FALSE(convertRecording(folder / "missing.csv", folder / "out.csv").ok());
  EXPECT_EQ(folder.files(), 3U);
}

}  // namespace
}  // namespace stillcut::record
