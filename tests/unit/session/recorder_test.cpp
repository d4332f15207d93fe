// The tap: nothing allocated on the worker's side, nothing lost while the disk keeps up, and a loud, clean stop when
// not.
#include "core/session/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <thread>

#include "core/session/describe_recording.h"
#include "core/session/open_recording.h"
#include "tests/support/path_counter.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

SessionHeader header() {
  return {exampleSetup(), "[cut]\n", "0.1.0", true};
}

// Steps in the file that equal exampleStep(0), (1), ... in all that was recorded.
int stepsAsRecorded(const std::string& path) {
  const auto reader = openRecording(path);
  EXPECT_TRUE(reader.ok()) << (reader ? "" : reader.error().line());
  if (!reader) return -1;
  SampleBlock block;
  block.allocate(2, exampleSetup().blockFrames);
  int steps = 0;
  while (true) {
    const Result<bool> more = (*reader)->read(block);
    EXPECT_TRUE(more.ok());
    if (!more || !*more) return steps;
    const StepRecord expected = exampleStep(steps);
    if (bitsOf((*reader)->recordedStep()->input) != bitsOf(expected.input) ||
        bitsOf((*reader)->recordedStep()->output) != bitsOf(expected.output)) {
      return steps;
    }
    ++steps;
  }
}

TEST(Recorder, WithoutAThreadItWritesWhenDrained) {
  const TempFolder folder;
  auto recorder = Recorder::create(folder / "cut.h5", header());
  ASSERT_TRUE(recorder.ok()) << recorder.error().line();
  for (int i = 0; i < 300; ++i) {
    const StepRecord step = exampleStep(i);
    ASSERT_TRUE((*recorder)->push(step.input, step.output));
    if (i % 7 == 0) {
      ASSERT_TRUE((*recorder)->drain());
    }
  }
  EXPECT_TRUE((*recorder)->status().recording);
  ASSERT_TRUE((*recorder)->finish().ok());
  EXPECT_FALSE((*recorder)->status().recording);
  EXPECT_EQ((*recorder)->status().written, 300U);
  EXPECT_EQ((*recorder)->status().dropped, 0U);
  EXPECT_EQ(stepsAsRecorded(folder / "cut.h5"), 300);
}

TEST(Recorder, ItsThreadWritesEverythingBeforeFinishReturns) {
  const TempFolder folder;
  auto recorder = Recorder::create(folder / "cut.h5", header());
  ASSERT_TRUE(recorder.ok());
  (*recorder)->startThread();
  constexpr int kSteps = 1000;  // fit into the buffer of four seconds: none may be dropped
  for (int i = 0; i < kSteps; ++i) {
    const StepRecord step = exampleStep(i);
    ASSERT_TRUE((*recorder)->push(step.input, step.output));
  }
  ASSERT_TRUE((*recorder)->finish().ok());
  EXPECT_EQ((*recorder)->status().dropped, 0U);
  EXPECT_EQ(stepsAsRecorded(folder / "cut.h5"), kSteps);
}

TEST(Recorder, TheWorkersSideNeitherAllocatesNorLocks) {
  if (!test::PathCounter::works()) GTEST_SKIP() << "allocations cannot be counted in this build";
  const TempFolder folder;
  RecorderOptions options;
  options.buffer = Seconds(0.2);  // 80 slots: the ring overflows as well
  auto recorder = Recorder::create(folder / "cut.h5", header(), options);
  ASSERT_TRUE(recorder.ok());
  const StepRecord step = exampleStep(1);
  const test::PathCounter counter;
  for (int i = 0; i < 500; ++i) (void)(*recorder)->push(step.input, step.output);
  EXPECT_TRUE(counter.counts().none());
  EXPECT_GT((*recorder)->status().dropped, 300U);
}

TEST(Recorder, DroppedStepsAreCountedAndLeaveAGap) {
  const TempFolder folder;
  RecorderOptions options;
  options.buffer = Seconds(0.0);
  auto recorder = Recorder::create(folder / "cut.h5", header(), options);
  ASSERT_TRUE(recorder.ok());
  StepRecord step = exampleStep(0);
  step.input.block.flags = 0;
  step.input.block.lostFrames = 0;
  int taken = 0;
  while ((*recorder)->push(step.input, step.output)) ++taken;
  EXPECT_FALSE((*recorder)->push(step.input, step.output));
  ASSERT_TRUE((*recorder)->drain());
  ASSERT_TRUE((*recorder)->push(step.input, step.output));
  ASSERT_TRUE((*recorder)->finish().ok());
  EXPECT_EQ((*recorder)->status().dropped, 2U);

  const auto reader = openRecording(folder / "cut.h5");
  ASSERT_TRUE(reader.ok());
  SampleBlock block;
  block.allocate(2, exampleSetup().blockFrames);
  for (int i = 0; i <= taken; ++i) {
    const Result<bool> more = (*reader)->read(block);
    ASSERT_TRUE(more.ok() && *more);
    EXPECT_EQ(block.has(kBlockGap), i == taken) << i;
  }
  EXPECT_EQ(block.lostFrames, 2U * static_cast<std::uint64_t>(step.input.block.frames));
  EXPECT_TRUE(block.has(kBlockEnd));
}

TEST(Recorder, ANearlyFullDiskStopsItLoudlyWithACleanFile) {
  const TempFolder folder;
  RecorderOptions options;
  options.reserveBytes = std::numeric_limits<std::uint64_t>::max();
  auto recorder = Recorder::create(folder / "cut.h5", header(), options);
  ASSERT_TRUE(recorder.ok());
  const StepRecord step = exampleStep(0);
  ASSERT_TRUE((*recorder)->push(step.input, step.output));
  EXPECT_FALSE((*recorder)->drain());
  EXPECT_FALSE((*recorder)->push(step.input, step.output)) << "control goes on, nothing is kept";
  const RecorderStatus status = (*recorder)->status();
  EXPECT_FALSE(status.recording);
  EXPECT_THAT(text(status.fault), HasSubstr("disk is nearly full"));
  EXPECT_EQ(status.dropped, 2U);
  const Status finished = (*recorder)->finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_THAT(finished.error().line(), HasSubstr("disk is nearly full"));
  const auto reader = openRecording(folder / "cut.h5");
  ASSERT_TRUE(reader.ok());
  EXPECT_TRUE((*reader)->format().closedCleanly);
}

TEST(Recorder, AFileThatIsDeletedOrMovedAwayStopsItLoudly) {
  for (const bool moved : {true, false}) {
    const TempFolder folder;
    const std::string path = folder / "cut.h5";
    auto recorder = Recorder::create(path, header());
    ASSERT_TRUE(recorder.ok()) << recorder.error().line();
    const StepRecord step = exampleStep(0);
    ASSERT_TRUE((*recorder)->push(step.input, step.output));
    ASSERT_TRUE((*recorder)->drain());
    if (moved) {
      std::filesystem::rename(path, folder / "moved.h5");
    } else {
      std::filesystem::remove(path);
    }
    for (int i = 1; i < 600 && !(*recorder)->stopped(); ++i) {
      const StepRecord next = exampleStep(i);
      if ((*recorder)->push(next.input, next.output)) (*recorder)->drain();
    }
    EXPECT_TRUE((*recorder)->stopped());
    EXPECT_THAT(text((*recorder)->status().fault), HasSubstr("deleted or moved away"));
    EXPECT_FALSE((*recorder)->finish().ok());
    if (!moved) continue;
    EXPECT_GT(stepsAsRecorded(folder / "moved.h5"), 0) << "what was written is closed, wherever it is";
  }
}

TEST(Recorder, CannotStartWhereNothingCanBeWritten) {
  const TempFolder folder;
  EXPECT_FALSE(Recorder::create(folder / "no/folder/cut.h5", header()).ok());
  EXPECT_EQ(folder.files(), 0U);
}

TEST(DescribeRecording, TellsWhatASessionHolds) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  {
    auto recorder = Recorder::create(path, header());
    ASSERT_TRUE(recorder.ok());
    for (int i = 0; i < 20; ++i) {
      const StepRecord step = exampleStep(i);
      ASSERT_TRUE((*recorder)->push(step.input, step.output));
    }
    ASSERT_TRUE((*recorder)->drain());
    ASSERT_TRUE((*recorder)->writer()->addTruth("chatter_frequency_hz", 898.5).ok());
    ASSERT_TRUE((*recorder)->finish().ok());
  }
  const auto description = describeRecording(path);
  ASSERT_TRUE(description.ok()) << description.error().line();
  const std::string text = toText(description.value());
  EXPECT_THAT(text, HasSubstr("Stillcut session"));
  EXPECT_THAT(text, HasSubstr("25600 Hz"));
  EXPECT_THAT(text, HasSubstr("Mill 3"));
  EXPECT_THAT(text, HasSubstr("steps        20"));
  EXPECT_THAT(text, HasSubstr("chatter_frequency_hz = 898.5"));
  const std::string json = toJson(description.value());
  EXPECT_THAT(json, HasSubstr("\"rate_hz\": 25600.0"));
  EXPECT_THAT(json, HasSubstr("\"configuration\": \"[cut]\\n\""));
  EXPECT_THAT(json, HasSubstr("\"steps\": 20"));
}

// A live session's clock does not begin with it.
TEST(DescribeRecording, EventsAreTimedFromTheFirstSampleAsMarkersAre) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  constexpr std::int64_t kBegin_ns = 86'045'000'000'000;
  {
    SessionWriterOptions options;
    options.samples = false;
    auto writer = SessionWriter::create(path, header(), options);
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 3; ++i) {
      StepRecord step = exampleStep(i);
      step.input.block.firstSample = instantFromNs(kBegin_ns + i * 2'000'000'000LL);
      step.output.eventCount = i == 2 ? 1 : 0;
      step.output.events[0].time = instantFromNs(kBegin_ns + 1'250'000'000);
      ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
    }
    ASSERT_TRUE((*writer)->close().ok());
  }
  const auto description = describeRecording(path);
  ASSERT_TRUE(description.ok()) << description.error().line();
  EXPECT_THAT(toText(description.value()), HasSubstr("event        1.25 s: "));
  EXPECT_THAT(toText(description.value()), HasSubstr("length       4 s")) << "of a history without samples";
  EXPECT_THAT(toJson(description.value()), HasSubstr("\"t_s\": 1.25"));
  EXPECT_THAT(toJson(description.value()), HasSubstr("\"length_s\": 4.0"));
}

TEST(DescribeRecording, TellsWhichColumnsOfATextAreChannels) {
  const TempFolder folder;
  const std::string path = folder.file("cut.csv",
                                       "Time (s),Accel X (g),\xFF"
                                       "Value\n0,1,2\n0.001,2,2\n0.002,3,2\n");
  const auto description = describeRecording(path);
  ASSERT_TRUE(description.ok()) << description.error().line();
  const std::string text = toText(description.value());
  EXPECT_THAT(text, HasSubstr("Accel X, acceleration, in g, times 9.80665 makes m/s"));
  EXPECT_THAT(text, HasSubstr("no channel   "));
  EXPECT_THAT(toJson(description.value()), HasSubstr("\"name\": \"Accel X\""))
      << "a name that is no UTF-8 does no harm";
  EXPECT_FALSE(describeRecording(folder / "missing").ok());
}

}  // namespace
}  // namespace stillcut::record
