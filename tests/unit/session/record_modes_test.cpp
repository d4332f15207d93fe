// What is kept: around events, features alone, names by job, tool and time, and what may be deleted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "core/session/open_recording.h"
#include "core/session/recorder.h"
#include "core/session/session_folder.h"
#include "core/storage/journal.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

// Steps of 10 ms, quiet, numbered by their sequence.
StepRecord quietStep(int number) {
  StepRecord step = exampleStep(0);
  step.input.block.frames = 64;
  step.input.block.flags = 0;
  step.input.block.lostFrames = 0;
  step.input.block.rate = Hertz(6400.0);
  step.input.block.sequence = static_cast<std::uint64_t>(number);
  step.input.block.firstSample = instantFromNs(number * 10'000'000LL);
  step.input.inputCount = 0;
  step.output.verdictCount = 1;
  step.output.inCharge = 0;
  step.output.verdicts[0].state = CutState::Stable;
  step.output.hasCommand = false;
  step.output.eventCount = 0;
  return step;
}

RecordPlan planAround(double before, double after) {
  RecordPlan plan;
  plan.before = Seconds(before);
  plan.after = Seconds(after);
  return plan;
}

// The only event of a step.
void addEvent(StepRecord& step, std::uint64_t number, EventLevel level, ReasonCode why) {
  step.output.eventCount = 1;
  step.output.events[0] = {step.input.block.end(), number, level, {why, {}}};
}

NextPath numbered(const TempFolder& folder, int& files) {
  return [&folder, &files]() -> Result<std::string> { return folder / (std::to_string(files++) + ".h5"); };
}

std::vector<std::uint64_t> sequencesOf(const std::string& path) {
  std::vector<std::uint64_t> found;
  const auto reader = openRecording(path);
  EXPECT_TRUE(reader.ok()) << (reader ? "" : reader.error().line());
  if (!reader) return found;
  SampleBlock block;
  block.allocate(2, 64);
  while (*(*reader)->read(block)) found.push_back(block.sequence);
  return found;
}

TEST(RecordModes, AroundEventsKeepsTheTimeBeforeAndAfterEachAndNothingElse) {
  const TempFolder folder;
  const RecordPlan plan = planAround(0.5, 0.3);
  int files = 0;
  auto recorder = Recorder::create(aroundEvents(exampleHeader(), plan, numbered(folder, files), {}), exampleSetup());
  for (int i = 0; i < 1000; ++i) {
    StepRecord step = quietStep(i);
    if (i == 200 || i == 220) {  // the second while the first still counts
      addEvent(step, 1, EventLevel::Warning, ReasonCode::ChatterBegan);
    }
    if (i == 600) {
      step.input.inputCount = 1;
      step.input.inputs[0] = {OperatorAction::ReportChatter, Authority::Off};
    }
    if (i == 800) {  // an event that is none to keep
      addEvent(step, 2, EventLevel::Info, ReasonCode::ChatterEnded);
    }
    ASSERT_TRUE(recorder->push(step.input, step.output));
    ASSERT_TRUE(recorder->drain());
  }
  ASSERT_TRUE(recorder->finish().ok());
  ASSERT_EQ(files, 2);
  const auto first = sequencesOf(folder / "0.h5");
  ASSERT_FALSE(first.empty());
  EXPECT_EQ(first.front(), 150U);
  EXPECT_EQ(first.back(), 250U);
  EXPECT_EQ(first.size(), 101U) << "each step once";
  const auto second = sequencesOf(folder / "1.h5");
  ASSERT_FALSE(second.empty());
  EXPECT_EQ(second.front(), 550U);
  EXPECT_EQ(second.back(), 630U);
  const auto markers = readMarkers(folder / "1.h5");
  ASSERT_TRUE(markers.ok());
  EXPECT_EQ(markers->size(), 1U);
}

class CountingDisk final : public Disk {
 public:
  bool sync(int file) override {
    ++syncs;
    return Disk::sync(file);
  }
  int syncs = 0;
};

// What was kept of the time before comes at once: a disk that takes long for each wait must not hold up what follows.
TEST(RecordModes, AroundEventsWaitsForTheDiskOnceForAllThatWasBefore) {
  const TempFolder folder;
  CountingDisk disk;
  SessionWriterOptions options;
  options.disk = &disk;
  const RecordPlan plan = planAround(30.0, 5.0);
  int files = 0;
  const auto sink = aroundEvents(exampleHeader(), plan, numbered(folder, files), options);
  sink->setPowerSafe();
  const auto add = [&](int i) {
    StepRecord step = quietStep(i);
    if (i == 2999) step.output.verdicts[0].state = CutState::Chatter;
    ASSERT_TRUE(sink->add(step.input, step.output).ok());
  };
  for (int i = 0; i < 2999; ++i) add(i);
  EXPECT_EQ(disk.syncs, 0);
  add(2999);
  const int once = disk.syncs;
  EXPECT_GE(once, 1) << "it is on the disk";
  EXPECT_LT(once, 10) << "sixty half seconds";
  EXPECT_EQ(countSession(folder / "0.h5")->steps, 3000U) << "for everybody who looks";
  for (int i = 3000; i < 3200; ++i) add(i);
  EXPECT_GE(disk.syncs, once + 3) << "from then on every half second";
  ASSERT_TRUE(sink->close().ok());
  EXPECT_EQ(sequencesOf(folder / "0.h5").size(), 3200U);
}

// An alarm that is longer than what is kept after it, beginning with its event; and one that was there before.
TEST(RecordModes, AroundEventsGoesOnWhileAnAlarmLasts) {
  const TempFolder folder;
  const RecordPlan plan = planAround(0.5, 0.3);
  int files = 0;
  const auto sink = aroundEvents(exampleHeader(), plan, numbered(folder, files), {});
  for (int i = 0; i < 600; ++i) {
    StepRecord step = quietStep(i);
    if (i >= 100 && i < 300) step.output.verdicts[0].state = i < 120 ? CutState::Onset : CutState::Chatter;
    if (i >= 300 && i < 400) {  // nobody knows: no alarm
      step.output.verdicts[0].state = CutState::Chatter;
      step.output.verdicts[0].valid = false;
    }
    if (i == 100) addEvent(step, 1, EventLevel::Warning, ReasonCode::ChatterBegan);
    ASSERT_TRUE(sink->add(step.input, step.output).ok());
  }
  ASSERT_TRUE(sink->close().ok());
  ASSERT_EQ(files, 1) << "the alarm and what came of it are in one file";
  const auto kept = sequencesOf(folder / "0.h5");
  ASSERT_FALSE(kept.empty());
  EXPECT_EQ(kept.front(), 50U);
  EXPECT_EQ(kept.back(), 329U) << "so long after the last alarming step, not after the event";
  EXPECT_EQ(kept.size(), 280U);
}

TEST(RecordModes, FeaturesKeepAStepASecondAndEveryChangeWithoutSamplesAnHourAFile) {
  const TempFolder folder;
  RecordPlan plan;
  plan.interval = Seconds(1.0);
  int files = 0;
  auto recorder = Recorder::create(features(exampleHeader(), plan, numbered(folder, files), {}), exampleSetup());
  for (int i = 0; i < 400'000; ++i) {       // 4000 s
    if (i % 20 != 0 && i != 505) continue;  // the sink sees fewer, the times are the same
    StepRecord step = quietStep(i);
    if (i == 505) step.output.verdicts[0].state = CutState::Chatter;
    ASSERT_TRUE(recorder->push(step.input, step.output));
    ASSERT_TRUE(recorder->drain());
  }
  ASSERT_TRUE(recorder->finish().ok());
  ASSERT_EQ(files, 2);
  const auto first = sequencesOf(folder / "0.h5");
  EXPECT_EQ(first.size(), 3600U + 2U + 1U) << "one a second, into chatter and out of it, and the last of the hour";
  EXPECT_NE(std::find(first.begin(), first.end(), 505U), first.end());
  EXPECT_EQ(first.back(), 359'980U);
  EXPECT_EQ(sequencesOf(folder / "1.h5").back(), 399'980U) << "how long it was as it was";
  const auto reader = openRecording(folder / "0.h5");
  ASSERT_TRUE(reader.ok());
  EXPECT_EQ((*reader)->format().frames, 0) << "no samples";
  const auto counts = countSession(folder / "0.h5");
  ASSERT_TRUE(counts.ok());
  EXPECT_EQ(counts->verdicts, first.size());
  // 24 h of it at one verdict a step stay small.
  EXPECT_LT(std::filesystem::file_size(folder / "0.h5") * 24, 100'000'000U);
}

// Also where the step of the second is the one that changed.
TEST(RecordModes, FeaturesMissNoChangeOfStateOrValidity) {
  const TempFolder folder;
  RecordPlan plan;
  plan.interval = Seconds(0.1);
  int files = 0;
  const auto sink = features(exampleHeader(), plan, numbered(folder, files), {});
  for (int i = 0; i < 100; ++i) {
    StepRecord step = quietStep(i);
    step.output.verdicts[0].valid = i != 33;
    if (i == 20 || i == 47) step.output.verdicts[0].state = CutState::Chatter;
    ASSERT_TRUE(sink->add(step.input, step.output).ok());
  }
  ASSERT_TRUE(sink->close().ok());
  const auto kept = sequencesOf(folder / "0.h5");
  for (const std::uint64_t changed : {20U, 21U, 33U, 34U, 47U, 48U}) {
    EXPECT_THAT(kept, testing::Contains(changed));
  }
  EXPECT_LT(kept.size(), 25U) << "and nothing twice";
}

TEST(SessionFolder, NamesFilesByJobToolAndTime) {
  const TempFolder folder;
  constexpr std::int64_t kTime = 1'700'000'000'000'000'000;  // 2023-11-14T22:13:20Z
  const auto path = newSessionPath(folder / "", "Housing 7/b", "T2 D12 Z4, 48", kTime);
  ASSERT_TRUE(path.ok()) << path.error().line();
  EXPECT_THAT(path.value(), HasSubstr("/Housing 7-b/T2 D12 Z4, 48/2023-11-14_22-13-20.h5"));
  std::ofstream(path.value()) << "taken";
  EXPECT_THAT(newSessionPath(folder / "", "Housing 7/b", "T2 D12 Z4, 48", kTime).value(), HasSubstr("22-13-20_2.h5"));
  EXPECT_THAT(newSessionPath(folder / "", "../..", "", kTime).value(), HasSubstr("/-/tool/"));
  EXPECT_FALSE(newSessionPath("/proc", "a", "b", kTime).ok());
}

std::string session(const TempFolder& folder, const char* name, std::int64_t age_s, std::int64_t now_ns,
                    const SessionWriterOptions& options = {}) {
  std::string path = folder / name;
  auto writer = SessionWriter::create(path, exampleHeader(), options);
  EXPECT_TRUE(writer.ok());
  const StepRecord step = quietStep(0);
  EXPECT_TRUE((*writer)->add(step.input, step.output).ok());
  EXPECT_TRUE((*writer)->close().ok());
  const timespec then{static_cast<time_t>(now_ns / 1'000'000'000 - age_s), 0};
  const timespec times[2] = {then, then};
  EXPECT_EQ(utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  return path;
}

TEST(SessionFolder, RetentionDeletesTheOldestAndNeverWhatIsMarked) {
  const TempFolder folder;
  constexpr std::int64_t kDay = 86400;
  const std::int64_t now = nowUtc();
  const std::string marked = session(folder, "marked.h5", 0, now);
  ASSERT_TRUE(addMarker(marked, {0, {}, {}, "note", "Ada", "keep", 0}).ok());
  const timespec longAgo{static_cast<time_t>(now / 1'000'000'000 - 1000 * kDay), 0};
  const timespec times[2] = {longAgo, longAgo};
  ASSERT_EQ(utimensat(AT_FDCWD, marked.c_str(), times, 0), 0);
  const std::string old = session(folder, "old.h5", 100 * kDay, now);
  const std::string middle = session(folder, "middle.h5", 20 * kDay, now);
  const std::string fresh = session(folder, "fresh.h5", kDay, now);
  const std::string alive = session(folder, "alive.h5", 500 * kDay, now);
  std::ofstream(journalPath(alive)) << "";
  const std::string other = folder.file("other.h5", "not a session at all");
  ASSERT_EQ(utimensat(AT_FDCWD, other.c_str(), times, 0), 0);

  RecordPlan plan;
  plan.keepFor = Seconds(90.0 * kDay);
  plan.keepBytes = 1ULL << 40U;
  auto deleted = applyRetention(folder / "", plan, now);
  ASSERT_EQ(deleted.size(), 1U);
  EXPECT_EQ(deleted[0].file, old);
  EXPECT_EQ(deleted[0].why, "older than 90 days");
  EXPECT_FALSE(std::filesystem::exists(old));

  const std::uint64_t all = std::filesystem::file_size(middle) + std::filesystem::file_size(fresh) +
                            std::filesystem::file_size(marked) + std::filesystem::file_size(alive) +
                            std::filesystem::file_size(other);
  plan.keepBytes = all - 1;
  deleted = applyRetention(folder / "", plan, now);
  ASSERT_EQ(deleted.size(), 1U);
  EXPECT_EQ(deleted[0].file, middle) << "the oldest that nobody has marked";
  plan.keepBytes = 1;
  deleted = applyRetention(folder / "", plan, now);
  for (const std::string& kept : {marked, alive, other}) EXPECT_TRUE(std::filesystem::exists(kept)) << kept;
  EXPECT_FALSE(std::filesystem::exists(fresh));
}

std::vector<std::string> filesOf(const std::vector<Deleted>& deleted) {
  std::vector<std::string> files;
  for (const Deleted& d : deleted) files.push_back(d.file);
  return files;
}

TEST(SessionFolder, AHistoryOfFeaturesDeletesItsOwnAndNoFullRecordingSooner) {
  const TempFolder folder;
  constexpr std::int64_t kHour = 3600;
  const std::int64_t now = nowUtc();
  SessionWriterOptions featuresOnly;
  featuresOnly.samples = false;
  const std::string full = session(folder, "full.h5", 48 * kHour, now);
  const std::string features = session(folder, "features.h5", 48 * kHour, now, featuresOnly);
  const std::string young = session(folder, "young.h5", 23 * kHour, now, featuresOnly);
  const std::string longAgo = session(folder, "longAgo.h5", 91 * 24 * kHour, now);
  RecordPlan plan = recordPlan(config::ParamSet());
  ASSERT_EQ(plan.history.value, 24.0 * kHour);
  ASSERT_EQ(plan.keepFor.value, 90.0 * 24.0 * kHour);

  for (const RecordMode mode : {RecordMode::Continuous, RecordMode::AroundEvents}) {
    plan.mode = mode;
    const std::string again = session(folder, "again.h5", 91 * 24 * kHour, now);
    EXPECT_THAT(filesOf(applyRetention(folder / "", plan, now)), testing::Contains(again));
    EXPECT_TRUE(std::filesystem::exists(features)) << "nobody keeps a history, nobody ends one";
  }
  ASSERT_FALSE(std::filesystem::exists(longAgo));
  plan.mode = RecordMode::Features;
  const std::string again = session(folder, "again.h5", 91 * 24 * kHour, now);
  EXPECT_THAT(filesOf(applyRetention(folder / "", plan, now)), testing::UnorderedElementsAre(features, again));
  EXPECT_TRUE(std::filesystem::exists(full)) << "two days old, and kept for ninety";
  EXPECT_TRUE(std::filesystem::exists(young));

  // A history that is longer than recordings are kept.
  plan.history = Seconds(100.0 * 24.0 * kHour);
  const std::string old = session(folder, "old.h5", 95 * 24 * kHour, now);
  const std::string oldFeatures = session(folder, "oldFeatures.h5", 95 * 24 * kHour, now, featuresOnly);
  EXPECT_THAT(filesOf(applyRetention(folder / "", plan, now)), testing::ElementsAre(old));
  EXPECT_TRUE(std::filesystem::exists(oldFeatures));
}

// One old file of somebody else's must not forbid every new recording, nor cost a newer one its place.
TEST(SessionFolder, WhatCannotBeDeletedIsToldAndPassedOver) {
  namespace fs = std::filesystem;
  const TempFolder folder;
  constexpr std::int64_t kDay = 24 * 3600;
  const std::int64_t now = nowUtc();
  fs::create_directory(folder / "locked");
  const std::string locked = session(folder, "locked/old.h5", 500 * kDay, now);
  const std::string old = session(folder, "old.h5", 400 * kDay, now);
  const std::string fresh = session(folder, "fresh.h5", kDay, now);
  fs::permissions(folder / "", fs::perms::all);
  for (const std::string& file : {locked, old, fresh}) {
    fs::permissions(file, fs::perms::all & ~(fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec));
  }
  fs::permissions(folder / "locked", fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  RecordPlan plan;
  plan.keepFor = Seconds(90.0 * kDay);
  plan.keepBytes = fs::file_size(fresh);
  constexpr int kOutOfReach = 98;
  const int wrong = asAnybody([&] {
    if (access(old.c_str(), W_OK) != 0) return kOutOfReach;
    const std::vector<Deleted> told = applyRetention(folder / "", plan, now);
    if (told.size() != 2) return 1;
    if (told[0].file != locked || told[0].problem.empty()) return 2;
    if (told[1].file != old || !told[1].problem.empty()) return 3;
    return newSessionPath(folder / "", "job", "tool", now) ? 0 : 4;
  });
  if (wrong == kOutOfReach) GTEST_SKIP() << "the folder for temporary files is not for everybody";
  EXPECT_EQ(wrong, 0);
  EXPECT_TRUE(fs::exists(locked));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(fresh));
}

TEST(SessionFolder, NoNameIsGivenTwiceAndNoSessionIsReplaced) {
  const TempFolder folder;
  const std::string cut = folder / "cut.h5";
  EXPECT_EQ(freeSessionPath(cut), cut);
  const std::string recorded = session(folder, "cut.h5", 0, nowUtc());
  EXPECT_EQ(freeSessionPath(cut), folder / "cut-2.h5");
  folder.file("cut-2.h5.journal", "");
  EXPECT_EQ(freeSessionPath(cut), folder / "cut-3.h5") << "what was cut off has its journal";

  EXPECT_TRUE(checkReplaceable(folder / "none.h5", MayReplace::NoSession).ok());
  EXPECT_TRUE(checkReplaceable(folder.file("text.h5", "no session"), MayReplace::NoSession).ok());
  EXPECT_FALSE(checkReplaceable(recorded, MayReplace::NoSession).ok());
  EXPECT_TRUE(checkReplaceable(recorded, MayReplace::SimulatedSession).ok()) << "it can be run again";
  EXPECT_FALSE(checkReplaceable(folder / "cut-2.h5", MayReplace::SimulatedSession).ok());
  ASSERT_TRUE(addMarker(recorded, {0, {}, {}, "note", "Ada", "", 0}).ok());
  EXPECT_FALSE(checkReplaceable(recorded, MayReplace::SimulatedSession).ok());
}

}  // namespace
}  // namespace stillcut::record
