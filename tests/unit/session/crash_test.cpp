// Whatever ends a recording, what was flushed is there: kill -9, the power, a full, a read-only, a slow disk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <semaphore>

#include "core/session/describe_recording.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "core/session/open_recording.h"
#include "core/session/recorder.h"
#include "core/storage/hdf5_file.h"
#include "core/storage/journaled_file.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr int kStepsPerSecond = 400;  // of exampleStep()

std::vector<std::byte> contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST(NeverLost, ARecordingKilledAtAnyMomentOpensWithAllButTheLastSecond) {
  const TempFolder folder;
  std::mt19937 random(20);
  for (int round = 0; round < 20; ++round) {
    const std::string path = folder / ("killed" + std::to_string(round) + ".h5");
    const int added = recordUntilKilled(path, std::uniform_int_distribution<int>(0, 1500)(random));
    ASSERT_GT(added, 0);
    const WhatIsLeft left = look(path);
    ASSERT_TRUE(left.opens) << left.error;
    EXPECT_FALSE(left.damaged) << left.error;
    EXPECT_GE(left.steps, added - kStepsPerSecond);
    EXPECT_LE(left.steps, added);
    // Opening has repaired it.
    EXPECT_FALSE(std::filesystem::exists(journalPath(path)));
    const auto again = openRecording(path);
    ASSERT_TRUE(again.ok());
    EXPECT_TRUE((*again)->format().closedCleanly);
  }
}

TEST(NeverLost, AfterAPowerLossAtAnyMomentEveryFlushedStepIsThere) {
  const TempFolder folder;
  RememberingDisk disk;
  struct Flushed {
    std::size_t operations;
    int steps;
  };
  std::vector<Flushed> flushed;
  {
    SessionWriterOptions options;
    options.powerSafe = true;
    options.disk = &disk;
    auto writer = SessionWriter::create(folder / "cut.h5", exampleHeader(), options);
    ASSERT_TRUE(writer.ok()) << writer.error().line();
    flushed.push_back({disk.operations(), 0});
    for (int i = 0; i < 1300; ++i) {
      const StepRecord step = exampleStep(i);
      ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
      if (i % 31 == 0) {  // often, so that chunks and their index fill up in every way
        ASSERT_TRUE((*writer)->flush().ok());
      }
      if (disk.operations() != flushed.back().operations) flushed.push_back({disk.operations(), i + 1});
    }
    ASSERT_TRUE((*writer)->close().ok());
    flushed.push_back({disk.operations(), 1300});
  }
  ASSERT_GT(flushed.size(), 40U);
  std::mt19937 random(7);
  for (int round = 0; round < 100; ++round) {
    const std::size_t at =
        std::uniform_int_distribution<std::size_t>(flushed.front().operations, disk.operations())(random);
    const std::string image = folder / "image.h5";
    disk.powerLoss(at, random, image);
    const auto last =
        std::find_if(flushed.rbegin(), flushed.rend(), [at](const Flushed& f) { return f.operations <= at; });
    const WhatIsLeft left = look(image);
    ASSERT_TRUE(left.opens) << "operation " << at << ": " << left.error;
    ASSERT_FALSE(left.damaged) << "operation " << at << ": " << left.error;
    ASSERT_GE(left.steps, last->steps) << "operation " << at;
  }
}

TEST(NeverLost, AMarkerAddedWhileThePowerGoesIsThereOrNotAndNothingElseChanges) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  {
    auto writer = SessionWriter::create(path, exampleHeader());
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 50; ++i) {
      const StepRecord step = exampleStep(i);
      ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
    }
  }
  const std::vector<std::byte> before = contentOf(path);
  ASSERT_TRUE(addMarker(path, {0, instantFromNs(10), instantFromNs(20), "chatter", "Ada", "loud", 0}).ok());
  const std::vector<std::byte> after = contentOf(path);
  ASSERT_NE(before, after);
  const auto count = readMarkers(path);
  ASSERT_TRUE(count.ok());
  // The journal of that change, made again, with the file in every state between.
  std::vector<std::byte> place = before;
  place.resize(after.size());
  const JournalContent journal{1, before.size(), {{0, after, place}}, after.size()};
  const std::vector<std::byte> bytes = encodeJournal(journal);
  for (std::size_t part = 0; part <= 8; ++part) {
    std::vector<std::byte> torn = after;
    std::copy_n(before.begin(), std::min(before.size(), torn.size()) * part / 8, torn.begin());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(torn.data()), static_cast<long>(torn.size()));
    std::ofstream(journalPath(path), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
    const auto markers = readMarkers(path);
    ASSERT_TRUE(markers.ok()) << markers.error().line();
    EXPECT_EQ(markers->size(), count->size());
    EXPECT_EQ(look(path).steps, 50);
  }
}

TEST(NeverLost, AJournalThatIsTornOrBelongsToAnotherFileIsLeftAlone) {
  const TempFolder folder;
  const std::string path = folder.file("cut.h5", std::string(100, 'a'));
  const auto five = [](char letter) { return std::vector<std::byte>(5, static_cast<std::byte>(letter)); };
  const auto recover = [&path] { return recoverFromJournal(path, [] { return Status(Done{}); }); };
  const std::vector<std::byte> journal = encodeJournal({1, 100, {{10, five('b'), five('a')}}, 100});
  const auto put = [&](const std::vector<std::byte>& bytes, std::size_t size) {
    std::ofstream(journalPath(path), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(size));
  };
  for (const std::size_t size : {std::size_t{0}, std::size_t{40}, std::size_t{64}, journal.size() - 1}) {
    put(journal, size);
    ASSERT_TRUE(recover().ok());
    EXPECT_EQ(contentOf(path)[10], std::byte{'a'});
  }
  std::vector<std::byte> bent = journal;
  bent[70] ^= std::byte{1};
  put(bent, bent.size());
  ASSERT_TRUE(recover().ok());
  EXPECT_EQ(contentOf(path)[10], std::byte{'a'});
  const std::vector<std::byte> longer = encodeJournal({1, 101, {{10, five('b'), five('a')}}, 101});
  const std::vector<std::byte> other = encodeJournal({1, 100, {{10, five('b'), five('c')}}, 100});
  for (const auto& foreign : {longer, other}) {
    put(foreign, foreign.size());
    ASSERT_TRUE(recover().ok());
    EXPECT_EQ(recover().value(), Recovery::AnothersJournal);
    EXPECT_EQ(contentOf(path)[10], std::byte{'a'});
    EXPECT_EQ(contentOf(journalPath(path)), foreign) << "it may fit the file it was made for";
  }
  put(journal, journal.size());
  EXPECT_FALSE(recoverFromJournal(path, [] { return Status(Error{message("cut.h5"), message("is cut short")}); }).ok());
  EXPECT_EQ(contentOf(path)[10], std::byte{'a'}) << "what would not be whole is not begun";
  ASSERT_TRUE(recover().ok());
  EXPECT_EQ(recover().value(), Recovery::Recovered) << "done twice as well";
  EXPECT_EQ(contentOf(path)[10], std::byte{'b'});
}

// h5clear -s, and then a data set of one's own: the journal that is left beside it must not undo that.
TEST(NeverLost, AStaleJournalChangesNothingInAFileThatWasClearedOrReplacedSince) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  ASSERT_GT(recordUntilKilled(path, 900), 0);
  ASSERT_TRUE(std::filesystem::exists(journalPath(path)));
  const std::vector<std::byte> journal = contentOf(journalPath(path));
  {
    const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS));
    const hbool_t yes = 1;
    ASSERT_GE(H5Pset(access.get(), "clear_status_flags", &yes), 0);
    ASSERT_GE(H5Pset(access.get(), "skip_eof_check", &yes), 0);
    const Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()));
    ASSERT_TRUE(static_cast<bool>(file));
    const Hdf5Id mine(H5Gcreate2(file.get(), "my_analysis", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    ASSERT_TRUE(static_cast<bool>(mine));
  }
  const auto expectUntouched = [&] {
    const std::vector<std::byte> before = contentOf(path);
    EXPECT_GT(look(path).steps, 0);
    EXPECT_TRUE(describeRecording(path).ok());
    (void)repairSession(path).ok();
    EXPECT_FALSE(addMarker(path, {0, {}, {}, "note", "Ada", "", 0}).ok()) << "its journal would take this one's place";
    EXPECT_TRUE(contentOf(path) == before);
    EXPECT_TRUE(contentOf(journalPath(path)) == journal);
  };
  expectUntouched();
  for (const int steps : {50, 1500}) {  // another session over the name, shorter and longer
    const std::string other = folder / "other.h5";
    {
      auto writer = SessionWriter::create(other, exampleHeader());
      ASSERT_TRUE(writer.ok());
      for (int i = 0; i < steps; ++i) {
        const StepRecord step = exampleStep(i);
        ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
      }
    }
    std::filesystem::rename(other, path);
    expectUntouched();
  }
  // A session that was cut off as well, whose own journal was not copied along. Earlier than the first: the same steps
  // cut off at the same place are the same bytes, and that journal would be right for both.
  const std::string cutOff = folder / "cutoff.h5";
  ASSERT_GT(recordUntilKilled(cutOff, 300), 0);
  std::filesystem::rename(cutOff, path);
  const std::vector<std::byte> before = contentOf(path);
  EXPECT_GT(look(path).steps, 0);
  EXPECT_FALSE(repairSession(path).ok());
  EXPECT_TRUE(contentOf(path) == before);
  std::filesystem::remove(journalPath(path));
  EXPECT_TRUE(repairSession(path).ok());
}

TEST(NeverLost, TwoWritersOfOneFileAreRefused) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  auto first = SessionWriter::create(path, exampleHeader());
  ASSERT_TRUE(first.ok());
  const auto second = SessionWriter::create(path, exampleHeader());
  ASSERT_FALSE(second.ok());
  EXPECT_THAT(second.error().line(), HasSubstr("is being written already"));
  EXPECT_FALSE(addMarker(path, {0, {}, {}, "note", "Ada", "", 0}).ok());
  EXPECT_FALSE(repairSession(path).ok());
  const StepRecord step = exampleStep(0);
  ASSERT_TRUE((*first)->add(step.input, step.output).ok());
  ASSERT_TRUE((*first)->close().ok());
  EXPECT_EQ(look(path).steps, 1);
  EXPECT_EQ(folder.files(), 1U);
}

// Full after so many bytes.
class FullDisk final : public Disk {
 public:
  explicit FullDisk(std::uint64_t room) : room_(room) {}
  bool write(int file, std::uint64_t offset, std::span<const std::byte> bytes) override {
    const std::uint64_t fits = std::min<std::uint64_t>(room_, bytes.size());
    room_ -= fits;
    if (!Disk::write(file, offset, bytes.first(fits))) return false;
    errno = ENOSPC;
    return fits == bytes.size();
  }

 private:
  std::uint64_t room_;
};

TEST(NeverLost, AFullDiskStopsTheRecordingLoudlyAndWhatWasFlushedIsClosed) {
  const TempFolder folder;
  for (std::uint64_t room = 400'000; room < 2'000'000; room += 131'071) {
    const std::string path = folder / "full.h5";
    FullDisk disk(room);
    RecorderOptions options;
    options.disk = &disk;
    auto recorder = Recorder::create(path, exampleHeader(), options);
    ASSERT_TRUE(recorder.ok()) << recorder.error().line();
    int pushed = 0;
    while (pushed < 20'000) {
      const StepRecord step = exampleStep(pushed);
      if (!(*recorder)->push(step.input, step.output)) break;
      ++pushed;
      if (!(*recorder)->drain()) break;
    }
    const RecorderStatus status = (*recorder)->status();
    EXPECT_FALSE(status.recording);
    EXPECT_TRUE((*recorder)->stopped());
    EXPECT_THAT(text(status.fault), HasSubstr("No space left on device"));
    EXPECT_EQ(text(status.fault).find('\n'), std::string::npos);
    EXPECT_FALSE((*recorder)->finish().ok());
    EXPECT_FALSE(std::filesystem::exists(journalPath(path)));
    const WhatIsLeft left = look(path);
    ASSERT_TRUE(left.opens) << left.error;
    EXPECT_FALSE(left.damaged) << left.error;
    EXPECT_GE(left.steps, pushed - kStepsPerSecond);
    const auto reader = openRecording(path);
    ASSERT_TRUE(reader.ok());
    EXPECT_TRUE((*reader)->format().closedCleanly);
  }
}

// Every sync waits until it is let go.
class SlowDisk final : public Disk {
 public:
  bool sync(int file) override {
    waiting.release();
    go.acquire();
    return Disk::sync(file);
  }
  std::counting_semaphore<> waiting{0}, go{2};  // two for the set-up
};

TEST(NeverLost, ASlowDiskNeverHoldsUpTheWorkerAndTheGapIsInTheFile) {
  const TempFolder folder;
  const std::string path = folder / "slow.h5";
  SlowDisk disk;
  RecorderOptions options;
  options.disk = &disk;
  options.buffer = Seconds(0.5);
  auto recorder = Recorder::create(path, exampleHeader(), options);
  ASSERT_TRUE(recorder.ok()) << recorder.error().line();
  disk.waiting.acquire();
  (*recorder)->startThread();
  StepRecord step = exampleStep(0);
  step.input.block.frames = step.input.block.capacityFrames;
  step.input.block.flags = 0;
  step.input.block.lostFrames = 0;
  int taken = 0, refused = 0;
  const auto push = [&] {
    step.input.block.firstSample += std::chrono::microseconds(2500);
    ++((*recorder)->push(step.input, step.output) ? taken : refused);
  };
  // Steps go in until none is taken: the disk has not answered once since the first flush.
  while (refused < 100) push();
  EXPECT_TRUE((*recorder)->status().fault.empty()) << "slow is not broken";
  disk.go.release(1'000'000);
  while ((*recorder)->status().written < static_cast<std::uint64_t>(taken)) std::this_thread::yield();
  push();
  ASSERT_TRUE((*recorder)->finish().ok());
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok());
  SampleBlock block;
  block.allocate(2, exampleSetup().blockFrames);
  int steps = 0;
  std::uint64_t lost = 0;
  while (true) {
    const Result<bool> more = (*reader)->read(block);
    ASSERT_TRUE(more.ok());
    if (!*more) break;
    ++steps;
    lost += block.lostFrames;
  }
  EXPECT_EQ(steps, taken);
  EXPECT_EQ(lost, static_cast<std::uint64_t>(refused * block.frames));
}

// A share for reading, or a disc: what is there is read, nothing is changed, and what cannot be done is one line.
TEST(NeverLost, ACrashedSessionInAReadOnlyPlaceIsReadAsItIs) {
  namespace fs = std::filesystem;
  using fs::perms;
  const perms everybodyReads = perms::owner_read | perms::group_read | perms::others_read;
  const perms everybodyWrites = everybodyReads | perms::owner_write | perms::group_write | perms::others_write;
  const perms enters = perms::owner_exec | perms::group_exec | perms::others_exec;
  for (const bool filesToo : {true, false}) {
    const TempFolder folder;
    const std::string path = folder / "cut.h5";
    const int added = recordUntilKilled(path, 700);
    ASSERT_GT(added, 0);
    ASSERT_TRUE(fs::exists(journalPath(path))) << "it was cut off";
    for (const std::string& file : {path, journalPath(path)}) {
      fs::permissions(file, filesToo ? everybodyReads : everybodyWrites);
    }
    fs::permissions(fs::path(path).parent_path(), everybodyReads | enters);
    const std::vector<std::byte> before = contentOf(path);
    constexpr int kOutOfReach = 98;
    const int wrong = asAnybody([&] {
      if (access(path.c_str(), R_OK) != 0) return kOutOfReach;
      const WhatIsLeft left = look(path);
      if (!left.opens || left.damaged || left.steps < added - kStepsPerSecond) return 1;
      if (!readMarkers(path)) return 2;
      if (!filesToo) return 0;  // only the journal stays where it is
      const auto described = describeRecording(path);
      if (!described || toText(*described).find("cannot be written to") == std::string::npos) return 3;
      const auto repaired = repairSession(path);
      if (repaired || repaired.error().line().find('\n') != std::string::npos) return 4;
      if (repaired.error().line().find(path) == std::string::npos) return 5;
      return addMarker(path, {0, {}, {}, "note", "Ada", "", 0}) ? 6 : 0;
    });
    fs::permissions(fs::path(path).parent_path(), perms::owner_all);
    if (wrong == kOutOfReach) GTEST_SKIP() << "the folder for temporary files is not for everybody";
    EXPECT_EQ(wrong, 0) << "files too: " << filesToo;
    if (!filesToo) continue;
    EXPECT_EQ(contentOf(path), before) << "not a byte is changed";
  }
}

TEST(NeverLost, AFolderThatCannotBeWrittenIsNamed) {
  const auto recorder = Recorder::create("/proc/cut.h5", exampleHeader());
  ASSERT_FALSE(recorder.ok());
  EXPECT_THAT(recorder.error().line(), HasSubstr("/proc/cut.h5: the session file cannot be created ("));
}

}  // namespace
}  // namespace stillcut::record
