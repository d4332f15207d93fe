// Replay: what a recording holds comes out of a source as it went in, at the pace asked for.
#include "core/daq/replay_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <limits>

#include "core/formats/sound/wav_reader.h"
#include "core/session/file/session_writer.h"
#include "core/session/open_recording.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"
#include "tests/support/virtual_clock.h"

namespace stillcut::daq {
namespace {

using record::bitsOf;
using record::exampleSetup;
using record::exampleStep;
using record::TempFolder;

std::unique_ptr<record::RecordingReader> opened(const std::string& path) {
  auto reader = record::openRecording(path);
  EXPECT_TRUE(reader.ok()) << (reader ? "" : reader.error().line());
  return reader ? std::move(*reader) : nullptr;
}

std::string session(const TempFolder& folder, int steps) {
  const std::string path = folder / "cut.h5";
  auto writer = record::SessionWriter::create(path, {exampleSetup(), "", "0.1.0", false});
  EXPECT_TRUE(writer.ok());
  for (int i = 0; i < steps; ++i) {
    const StepRecord step = exampleStep(i);
    EXPECT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  EXPECT_TRUE((*writer)->close().ok());
  return path;
}

// 100 frames at 1 kHz.
std::string table(const TempFolder& folder) {
  std::string text = "t,a (g)\n";
  for (int i = 0; i < 100; ++i) text += std::to_string(i * 1e-3) + "," + std::to_string(i) + "\n";
  return folder.file("cut.csv", text);
}

TEST(ReplaySource, ASessionComesBackInItsOwnBlocksWithItsMachineAndOperator) {
  const TempFolder folder;
  constexpr int kSteps = 120;
  ReplaySource source(opened(session(folder, kSteps)), {});
  const Result<SourceFormat> format = source.open();
  ASSERT_TRUE(format.ok());
  EXPECT_EQ(format.value().rate.value, 25600.0);
  EXPECT_EQ(format.value().blockFrames, exampleSetup().blockFrames);
  ASSERT_EQ(format.value().channels.size(), 2U);
  EXPECT_EQ(format.value().channels[1].scale, exampleSetup().channels[1].scale);
  SampleBlock block;
  block.allocate(2, format.value().blockFrames);
  for (int i = 0; i < kSteps; ++i) {
    ASSERT_TRUE(source.read(block)) << text(source.fault());
    const StepRecord expected = exampleStep(i);
    ASSERT_NE(source.recordedStep(), nullptr);
    EXPECT_EQ(bitsOf(*source.recordedStep()), bitsOf(expected.input));
    StepInput fed = *source.recordedStep();
    fed.block = block;
    if (i == kSteps - 1) {
      EXPECT_TRUE(block.has(kBlockEnd));
      fed.block.flags = expected.input.block.flags;
    }
    EXPECT_EQ(bitsOf(fed), bitsOf(expected.input)) << "the block handed out is the block recorded";
  }
  EXPECT_FALSE(source.read(block));
  EXPECT_TRUE(source.fault().empty());
}

TEST(ReplaySource, AnImportComesInEvenBlocksWithoutAMachine) {
  const TempFolder folder;
  ReplayOptions options;
  options.blockFrames = 32;
  ReplaySource source(opened(table(folder)), options);
  const Result<SourceFormat> format = source.open();
  ASSERT_TRUE(format.ok());
  EXPECT_EQ(format.value().blockFrames, 32);
  EXPECT_DOUBLE_EQ(format.value().channels[0].scale, 9.80665);
  SampleBlock block;
  block.allocate(1, 32);
  for (const int frames : {32, 32, 32, 4}) {
    ASSERT_TRUE(source.read(block));
    EXPECT_EQ(block.frames, frames);
    EXPECT_EQ(block.has(kBlockEnd), frames == 4);
    EXPECT_EQ(source.recordedStep(), nullptr);
  }
  EXPECT_FALSE(source.read(block));
}

TEST(ReplaySource, ABlockIsThereWhenItsLastSampleIsAndStopEndsTheWait) {
  const TempFolder folder;
  const test::VirtualClock still(instantFromNs(1'000));
  ReplayOptions options;
  options.blockFrames = 25;
  options.pace = 4.0;
  options.clock = &still;
  ReplaySource source(opened(table(folder)), options);
  ASSERT_TRUE(source.open().ok());
  SampleBlock block;
  block.allocate(1, 25);
  std::future<bool> waiting = std::async(std::launch::async, [&] { return source.read(block); });
  source.stop();
  EXPECT_FALSE(waiting.get()) << "no time has passed, so no block is there";
  EXPECT_TRUE(source.fault().empty());
}

// A clock that has gone on by `step` whenever it is read.
class WalkingClock final : public Clock {
 public:
  explicit WalkingClock(Duration step) : step_(step) {}
  Instant now() const noexcept override { return instantFromNs(step_.count() * reads_++); }
  int reads() const { return reads_; }

 private:
  Duration step_;
  mutable int reads_ = 0;
};

TEST(ReplaySource, PaceDividesTheTimeBetweenBlocks) {
  const TempFolder folder;
  // Blocks of 25 ms, four times as fast: each is due 6.25 ms after the one before, which one look at the clock brings.
  const WalkingClock clock(std::chrono::microseconds(6250));
  ReplayOptions options;
  options.blockFrames = 25;
  options.pace = 4.0;
  options.clock = &clock;
  ReplaySource source(opened(table(folder)), options);
  ASSERT_TRUE(source.open().ok());
  SampleBlock block;
  block.allocate(1, 25);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(source.read(block));
  EXPECT_EQ(clock.reads(), 5) << "one look for the start, one for each block";
}

TEST(ReplaySource, BadOptionsAndBadFilesAreNamed) {
  const TempFolder folder;
  ReplayOptions noClock;
  noClock.pace = 1.0;
  EXPECT_FALSE(ReplaySource(opened(table(folder)), noClock).open().ok());
  ReplayOptions noFrames;
  noFrames.blockFrames = 0;
  EXPECT_FALSE(ReplaySource(opened(table(folder)), noFrames).open().ok());

  // A sample that is no number, found while reading: the source ends with a line, it does not throw.
  SampleBlock block;
  block.allocate(1, 16);
  block.frames = 16;
  block.channel(0)[5] = std::numeric_limits<float>::quiet_NaN();
  auto writer = record::WavWriter::create(folder / "nan.wav", 1, Hertz(1000.0));
  ASSERT_TRUE(writer.ok());
  ASSERT_TRUE((*writer)->write(block).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  ReplaySource source(opened(folder / "nan.wav"), {});
  ASSERT_TRUE(source.open().ok());
  EXPECT_FALSE(source.read(block));
  EXPECT_THAT(text(source.fault()), testing::HasSubstr("frame 5"));
  EXPECT_FALSE(source.read(block));
}

}  // namespace
}  // namespace stillcut::daq
