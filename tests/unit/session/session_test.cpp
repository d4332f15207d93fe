// Session files: what was recorded comes back bit by bit; what is damaged is named; a crash costs half a second at
// most.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/session/file/session_reader.h"
#include "core/session/file/session_rows.h"
#include "core/session/file/session_writer.h"
#include "core/session/open_recording.h"
#include "core/storage/hdf5_file.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr int kFrames = 64;

SessionHeader header(const std::string& configuration = "[gate]\nmax = 1.2\n") {
  return {exampleSetup(), configuration, "0.1.0", true};
}

void record(const std::string& path, int steps) {
  auto writer = SessionWriter::create(path, header());
  ASSERT_TRUE(writer.ok()) << writer.error().line();
  for (int i = 0; i < steps; ++i) {
    const StepRecord step = exampleStep(i);
    ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  ASSERT_TRUE((*writer)->close().ok());
}

// Reads to the end; expects each step as it was recorded. Returns how many there were.
int expectAllSteps(RecordingReader& reader) {
  SampleBlock block;
  block.allocate(2, kFrames);
  int steps = 0;
  while (true) {
    const Result<bool> more = reader.read(block);
    EXPECT_TRUE(more.ok()) << more.error().line();
    if (!more || !*more) return steps;
    const StepRecord expected = exampleStep(steps);
    const StepRecord* got = reader.recordedStep();
    EXPECT_NE(got, nullptr);
    if (got == nullptr) return steps;
    EXPECT_EQ(bitsOf(got->input), bitsOf(expected.input)) << "step " << steps;
    EXPECT_EQ(bitsOf(got->output), bitsOf(expected.output)) << "step " << steps;
    EXPECT_EQ(block.firstSample, expected.input.block.firstSample);
    EXPECT_EQ(block.frames, expected.input.block.frames);
    EXPECT_EQ(block.channel(1)[0], expected.input.block.channel(1)[0]);
    if (testing::Test::HasFailure()) return steps;
    ++steps;
  }
}

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Session, EveryStepComesBackBitByBit) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  record(path, 1500);
  EXPECT_EQ(folder.files(), 1U);
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  EXPECT_EQ((*reader)->format().blocks, 1500);
  EXPECT_TRUE((*reader)->format().closedCleanly);
  EXPECT_EQ(expectAllSteps(**reader), 1500);
}

TEST(Session, TheHeaderComesBackEvenWithALargeConfiguration) {
  const TempFolder folder;
  const std::string configuration(300'000, 'x');
  const std::string path = folder / "cut.h5";
  {
    auto writer = SessionWriter::create(path, header(configuration));
    ASSERT_TRUE(writer.ok()) << writer.error().line();
    const StepRecord step = exampleStep(0);
    ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  const RecordingFormat& format = (*reader)->format();
  const CutSetup expected = exampleSetup();
  EXPECT_EQ(format.configuration, configuration);
  EXPECT_EQ(format.programVersion, "0.1.0");
  EXPECT_TRUE(format.simulated);
  ASSERT_TRUE(format.setup.has_value());
  EXPECT_EQ(format.setup->machine, expected.machine);
  EXPECT_EQ(format.setup->tool, expected.tool);
  EXPECT_EQ(format.setup->teeth, 4);
  EXPECT_EQ(format.setup->toolDiameter.value, expected.toolDiameter.value);
  EXPECT_EQ(format.setup->nominalSpeed.value, expected.nominalSpeed.value);
  EXPECT_EQ(format.setup->nominalFeed.value, expected.nominalFeed.value);
  EXPECT_EQ(format.rate.value, 25600.0);
  EXPECT_EQ(format.blockFrames, kFrames);
  ASSERT_EQ(format.channels.size(), 2U);
  EXPECT_EQ(format.channels[1].info.name, "y");
  EXPECT_EQ(format.channels[1].info.scale, expected.channels[1].scale);
  EXPECT_EQ(format.channels[1].info.quantity, SensorQuantity::Acceleration);
  for (std::size_t c = 0; c < 2; ++c) {
    for (const ChannelInfo& info : {format.channels[c].info, format.setup->channels[c]}) {
      EXPECT_EQ(info.sensitivity, expected.channels[c].sensitivity);
      EXPECT_EQ(info.volts, expected.channels[c].volts);
      EXPECT_EQ(info.coupling, expected.channels[c].coupling);
      EXPECT_EQ(info.place, expected.channels[c].place);
    }
  }
}

TEST(Session, ReasonsAreReadByTheirIdentifiersNotTheirNumbers) {
  const std::string ids = reasonIdentifiers();
  EXPECT_THAT(ids, testing::StartsWith("none\nlearning\n"));
  EXPECT_THAT(ids, HasSubstr("\nchatter-began\n"));
  // A file of another version, with other numbers and a code this program has never had.
  const ReasonCodes codes("none\nchatter-began\nfrom-the-future\nlearning");
  EXPECT_EQ(codes.fromFile(static_cast<ReasonCode>(1)), ReasonCode::ChatterBegan);
  EXPECT_EQ(codes.fromFile(static_cast<ReasonCode>(2)), ReasonCode::None);
  EXPECT_EQ(codes.fromFile(static_cast<ReasonCode>(3)), ReasonCode::Learning);
  EXPECT_EQ(codes.fromFile(static_cast<ReasonCode>(4000)), ReasonCode::None);
  const ReasonCodes own(ids);
  EXPECT_EQ(own.fromFile(ReasonCode::LinkLost), ReasonCode::LinkLost);
}

TEST(Session, TruthOfASimulatedCutIsKept) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  {
    auto writer = SessionWriter::create(path, header());
    ASSERT_TRUE(writer.ok());
    ASSERT_TRUE((*writer)->addTruth("chatter_frequency_hz", 898.5).ok());
    ASSERT_TRUE((*writer)->addTruth("chatter", instantFromNs(5), 1.0).ok());
    ASSERT_TRUE((*writer)->addTruth(std::string(100, 'n'), instantFromNs(6), 0.0).ok());
    ASSERT_TRUE((*writer)->close().ok());
    EXPECT_FALSE((*writer)->addTruth("late", 1.0).ok());
  }
  const auto counts = countSession(path);
  ASSERT_TRUE(counts.ok()) << counts.error().line();
  ASSERT_EQ(counts.value().truthValues.size(), 1U);
  EXPECT_EQ(counts.value().truthValues[0].first, "chatter_frequency_hz");
  EXPECT_EQ(counts.value().truthValues[0].second, 898.5);
  const auto series = readTruthSeries(path);
  ASSERT_TRUE(series.ok());
  ASSERT_EQ(series.value().size(), 2U);
  EXPECT_EQ(series.value()[0].name, "chatter");
  EXPECT_EQ(toNs(series.value()[0].time), 5);
  EXPECT_EQ(series.value()[1].name.size(), 47U);
}

TEST(Session, CanBeReadWhileItIsWritten) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  int written[2];
  int finish[2];
  ASSERT_EQ(pipe(written), 0);
  ASSERT_EQ(pipe(finish), 0);
  const pid_t child = fork();
  if (child == 0) {  // writes, tells, and keeps the file open until the other end is closed
    close(finish[1]);
    auto writer = SessionWriter::create(path, header());
    for (int i = 0; writer.ok() && i < 40; ++i) {
      const StepRecord step = exampleStep(i);
      (void)(*writer)->add(step.input, step.output).ok();
    }
    const bool good = writer.ok() && (*writer)->flush().ok();
    char sign = good ? 'y' : 'n';
    (void)!write(written[1], &sign, 1);
    (void)!read(finish[0], &sign, 1);
    _exit(good ? 0 : 1);
  }
  char sign = 0;
  ASSERT_EQ(read(written[0], &sign, 1), 1);
  EXPECT_EQ(sign, 'y');
  const auto reader = openRecording(path);
  EXPECT_TRUE(reader.ok()) << reader.error().line();
  if (reader) {
    EXPECT_FALSE((*reader)->format().closedCleanly);
    EXPECT_EQ(expectAllSteps(**reader), 40);
  }
  for (const int end : {finish[0], finish[1], written[0], written[1]}) close(end);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(Session, SelectedChannelsOfASession) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  record(path, 3);
  ReadOptions options;
  options.channels = {1};
  const auto reader = openRecording(path, options);
  ASSERT_TRUE(reader.ok());
  SampleBlock block;
  block.allocate(1, kFrames);
  const Result<bool> more = (*reader)->read(block);
  ASSERT_TRUE(more.ok() && *more);
  EXPECT_EQ(block.channel(0)[1], exampleStep(0).input.block.channel(1)[1]);
  EXPECT_EQ((*reader)->format().channels[0].info.name, "y");
  options.channels = {2};
  EXPECT_FALSE(openRecording(path, options).ok());
}

TEST(Session, WhatCannotBeCreatedLeavesNothingBehind) {
  const TempFolder folder;
  EXPECT_FALSE(SessionWriter::create(folder / "no/folder/cut.h5", header()).ok());
  const std::string taken = folder / "taken";
  std::filesystem::create_directory(taken);
  const auto writer = SessionWriter::create(taken, header());
  ASSERT_FALSE(writer.ok());
  EXPECT_EQ(writer.error().line().find('\n'), std::string::npos);
  SessionHeader nothing = header();
  nothing.setup.channels.clear();
  EXPECT_FALSE(SessionWriter::create(folder / "cut.h5", nothing).ok());
  EXPECT_EQ(folder.files(), 1U);
}

TEST(Session, AnotherHdf5FileIsNoSession) {
  const TempFolder folder;
  const std::string path = folder / "other.h5";
  Hdf5Id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)).reset();
  const auto reader = openRecording(path);
  ASSERT_FALSE(reader.ok());
  EXPECT_THAT(reader.error().line(), HasSubstr("not a Stillcut session"));
}

// Records in a child that is killed after `steps` steps.
void recordAndBeKilled(const std::string& path, int steps) {
  const pid_t child = fork();
  if (child == 0) {
    auto writer = SessionWriter::create(path, header());
    for (int i = 0; writer.ok() && i < steps; ++i) {
      const StepRecord step = exampleStep(i);
      (void)(*writer)->add(step.input, step.output).ok();
    }
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(SessionCrash, AKilledWriterLosesHalfASecondAtMostAndTheFileOpens) {
  const TempFolder folder;
  constexpr int kStepsPerFlush = 201;  // 0.5 s in steps of 2.5 ms
  for (const int steps : {1, 199, 201, 202, 403, 500, 777, 1024, 1300}) {
    const std::string path = folder / ("killed" + std::to_string(steps) + ".h5");
    recordAndBeKilled(path, steps);
    const auto reader = openRecording(path);
    ASSERT_TRUE(reader.ok()) << reader.error().line();
    EXPECT_FALSE((*reader)->format().closedCleanly);
    const int got = expectAllSteps(**reader);
    EXPECT_GE(got, steps - kStepsPerFlush);
    EXPECT_LE(got, steps);
  }
}

TEST(SessionCrash, RepairMakesTheFileAnOrdinaryOne) {
  const TempFolder folder;
  const std::string path = folder / "killed.h5";
  recordAndBeKilled(path, 700);
  quietHdf5();
  EXPECT_FALSE(Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT))) << "the crash left no mark to repair";
  const auto repaired = repairSession(path);
  ASSERT_TRUE(repaired.ok()) << repaired.error().line();
  EXPECT_TRUE(repaired.value());
  EXPECT_TRUE(Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)));
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  EXPECT_TRUE((*reader)->format().closedCleanly);
  EXPECT_GE(expectAllSteps(**reader), 499);
  const auto again = repairSession(path);
  ASSERT_TRUE(again.ok());
  EXPECT_FALSE(again.value());
  EXPECT_FALSE(repairSession(folder.file("no.h5", "no session")).ok());
}

TEST(SessionCrash, ATruncatedFileNeverCrashesTheReader) {
  const TempFolder folder;
  const std::string whole = folder / "whole.h5";
  record(whole, 60);
  const std::string content = contentOf(whole);
  for (std::size_t part = 1; part < 40; ++part) {
    const std::string path = folder.file("part.h5", content.substr(0, content.size() * part / 40));
    const auto reader = openRecording(path);
    if (!reader) {
      EXPECT_EQ(reader.error().line().find('\n'), std::string::npos);
      continue;
    }
    SampleBlock block;
    block.allocate(2, kFrames);
    for (int i = 0; i < 60; ++i) {
      const Result<bool> more = (*reader)->read(block);
      if (!more || !*more) break;
    }
  }
}

TEST(SessionCrash, DamagedBytesAreRefusedOrReadButNeverHarm) {
  const TempFolder folder;
  const std::string whole = folder / "whole.h5";
  record(whole, 5);
  const std::string content = contentOf(whole);
  std::uint32_t state = 1;
  const auto random = [&state] { return (state = state * 1664525U + 1013904223U) >> 8U; };
  for (int round = 0; round < 150; ++round) {
    std::string damaged = content;
    // Half of the time where the header is, half of the time anywhere.
    const std::size_t reach = round % 2 == 0 ? 4000 : damaged.size();
    for (int i = 0; i < 3; ++i) damaged[random() % reach] = static_cast<char>(random());
    const std::string path = folder.file("damaged.h5", damaged);
    const auto reader = openRecording(path);
    if (!reader) {
      EXPECT_EQ(reader.error().line().find('\n'), std::string::npos);
      continue;
    }
    SampleBlock block;
    block.allocate(static_cast<int>((*reader)->format().channels.size()), (*reader)->format().blockFrames);
    for (int i = 0; i < 6; ++i) {
      const Result<bool> more = (*reader)->read(block);
      if (!more || !*more) break;
      EXPECT_LE(block.frames, block.capacityFrames);
    }
  }
}

TEST(SessionCrash, AFullDiskIsAnErrorAndWhatWasFlushedStaysReadable) {
  const TempFolder folder;
  const std::string path = folder / "full.h5";
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1'500'000, 1'500'000};  // as a full disk: no file may grow beyond
    setrlimit(RLIMIT_FSIZE, &limit);
    bool failed = false;
    {
      auto writer = SessionWriter::create(path, header());
      for (int i = 0; writer.ok() && i < 3000 && !failed; ++i) {
        const StepRecord step = exampleStep(i);
        failed = !(*writer)->add(step.input, step.output).ok();
      }
      if (failed) failed = !(*writer)->add(exampleStep(0).input, exampleStep(0).output).ok();
    }
    _exit(failed ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << "the writer must report, and survive reporting";
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  EXPECT_GT(expectAllSteps(**reader), 200);
}

}  // namespace
}  // namespace stillcut::record
