// Folders that cannot hold a recording, names that two programs want, and a file that somebody cuts short: one line
// says what is not recorded, and no journal without a session is left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>

#include "core/formats/utf_text.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "core/session/open_recording.h"
#include "core/session/recorder.h"
#include "core/session/session_folder.h"
#include "core/storage/journal.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace {
bool locksAreThere = true;
}  // namespace

// In the place of the system's, as a share without locks answers it.
extern "C" int flock(int file, int operation) noexcept {
  if (locksAreThere) return static_cast<int>(syscall(SYS_flock, file, operation));
  errno = ENOLCK;
  return -1;
}

namespace stillcut::record {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class WithoutLocks {
 public:
  WithoutLocks() { locksAreThere = false; }
  ~WithoutLocks() { locksAreThere = true; }
};

TEST(DiskTroubles, AFolderWithoutLocksIsNamedAsSuchAndLeftEmpty) {
  const TempFolder folder;
  const WithoutLocks share;
  const auto writer = SessionWriter::create(folder / "cut.h5", exampleHeader());
  ASSERT_FALSE(writer.ok());
  EXPECT_THAT(writer.error().line(), HasSubstr("has no file locks"));
  EXPECT_THAT(writer.error().line(), Not(HasSubstr("being written already")));
  EXPECT_EQ(writer.error().line().find('\n'), std::string::npos);
  EXPECT_EQ(folder.files(), 0U);
}

TEST(DiskTroubles, ASessionThatWasCutOffIsReadInAFolderWithoutLocksAndLeftAsItIs) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  const int added = recordUntilKilled(path, 700);
  ASSERT_GT(added, 0);
  const auto size = fs::file_size(path);
  const WithoutLocks share;
  const auto reader = here::openSession(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  EXPECT_GE((*reader)->format().blocks, added - 400);
  EXPECT_EQ(fs::file_size(path), size);
  EXPECT_TRUE(fs::exists(journalPath(path)));
}

TEST(DiskTroubles, ANameThatAnotherProgramHasTakenMeanwhileIsLeftToItAndTheNextOneTaken) {
  const TempFolder folder;
  const std::string wanted = folder / "cut.h5";
  auto first = SessionWriter::create(wanted, exampleHeader());
  ASSERT_TRUE(first.ok());
  int asked = 0;
  const NextPath nextPath = [&]() -> Result<std::string> {  // the name was free when it was looked for
    return ++asked == 1 ? wanted : freeSessionPath(wanted);
  };
  for (const bool closed : {false, true}) {
    if (closed) {
      ASSERT_TRUE((*first)->close().ok());
    }
    asked = 0;
    auto second = createUnderNextName(nextPath, exampleHeader(), {});
    ASSERT_TRUE(second.ok()) << second.error().line();
    EXPECT_EQ((*second)->path(), folder / (closed ? "cut-3.h5" : "cut-2.h5"));
    EXPECT_EQ(asked, 2);
  }
  EXPECT_TRUE(look(wanted).opens) << "nothing is recorded over it";
}

TEST(DiskTroubles, AnErrorThatNoOtherNameMendsIsGivenAtOnce) {
  int asked = 0;
  const auto writer = createUnderNextName(
      [&]() -> Result<std::string> {
        ++asked;
        return std::string("/proc/cut.h5");
      },
      exampleHeader(), {});
  EXPECT_FALSE(writer.ok());
  EXPECT_EQ(asked, 1);
}

// Records one step into the folder, named by the same second as everybody's. 0: done.
int recordOneStep(const std::string& folder, int gate) {
  char go = 0;
  if (read(gate, &go, 1) < 0) return 1;
  constexpr std::int64_t kTime = 1'700'000'000'000'000'000;
  auto writer = createUnderNextName([&] { return newSessionPath(folder, "job", "tool", kTime); }, exampleHeader(), {});
  if (!writer) return 2;
  const StepRecord step = exampleStep(0);
  return (*writer)->add(step.input, step.output).ok() && (*writer)->close().ok() ? 0 : 3;
}

TEST(DiskTroubles, ProgramsThatBeginInOneSecondAllRecord) {
  constexpr int kPrograms = 8;
  const TempFolder folder;
  int gate[2];
  ASSERT_EQ(pipe(gate), 0);
  std::vector<pid_t> programs;
  for (int i = 0; i < kPrograms; ++i) {
    const pid_t program = fork();
    if (program == 0) {
      close(gate[1]);
      _exit(recordOneStep(folder / "", gate[0]));
    }
    programs.push_back(program);
  }
  close(gate[0]);
  close(gate[1]);  // go, all at once
  for (const pid_t program : programs) {
    int status = -1;
    ASSERT_EQ(waitpid(program, &status, 0), program);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  }
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder / "job/tool")) {
    files.insert(entry.path().filename().string());
    EXPECT_EQ(look(entry.path().string()).steps, 1) << entry.path();
  }
  EXPECT_EQ(files.size(), static_cast<std::size_t>(kPrograms)) << "and nothing beside the sessions";
}

TEST(DiskTroubles, ANameIsCutBetweenLettersAndHoldsNoBrokenOnes) {
  const TempFolder folder;
  std::string job;
  for (int i = 0; i < 33; ++i) job += "铣";  // 99 bytes
  for (const std::string& asked : {job, "a" + job, std::string("M\xFCller")}) {
    const auto path = newSessionPath(folder / "", asked, asked, nowUtc());
    ASSERT_TRUE(path.ok()) << path.error().line();
    EXPECT_EQ(utf8Of(*path), *path);
    auto writer = SessionWriter::create(*path, exampleHeader());
    ASSERT_TRUE(writer.ok()) << writer.error().line();
    ASSERT_TRUE((*writer)->close().ok());
    EXPECT_TRUE(openRecording(*path).ok());
  }
}

TEST(DiskTroubles, AFileThatIsCutShortFromOutsideIsNoticedAndNotFilledWithZeros) {
  for (const std::uintmax_t left : {0U, 20'000U}) {
    const TempFolder folder;
    const std::string path = folder / "cut.h5";
    auto recorder = Recorder::create(path, exampleHeader());
    ASSERT_TRUE(recorder.ok());
    int pushed = 0;
    const auto record = [&](int steps) {
      for (int i = 0; i < steps; ++i) {
        const StepRecord step = exampleStep(pushed++);
        (void)(*recorder)->push(step.input, step.output);
        (void)(*recorder)->drain();
      }
    };
    record(1000);
    ASSERT_TRUE((*recorder)->status().recording);
    fs::resize_file(path, left);
    record(600);
    EXPECT_FALSE((*recorder)->status().recording);
    EXPECT_THAT(text((*recorder)->status().fault), HasSubstr("cut short by another program"));
    EXPECT_FALSE((*recorder)->finish().ok());
    EXPECT_EQ(fs::file_size(path), left);
    EXPECT_EQ(folder.files(), 1U) << "no journal is left that fits nothing";
  }
}

TEST(DiskTroubles, ARecordingThatCouldNotBeginCountsWhatIsLostAndSaysWhy) {
  const Error why{"/share/cut.h5", message("the session file cannot be created")};
  const auto recorder = Recorder::stopped("/share/cut.h5", why, exampleSetup());
  recorder->startThread();
  const StepRecord step = exampleStep(0);
  EXPECT_TRUE(recorder->stopped());
  EXPECT_FALSE(recorder->push(step.input, step.output));
  const RecorderStatus status = recorder->status();
  EXPECT_FALSE(status.recording);
  EXPECT_EQ(status.dropped, 1U);
  EXPECT_EQ(status.path, "/share/cut.h5");
  EXPECT_THAT(text(status.fault), HasSubstr("cannot be created"));
  const Status finished = recorder->finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_THAT(finished.error().line(), HasSubstr("cannot be created"));
}

TEST(DiskTroubles, ADiskWithoutRoomIsNamedBeforeAFileIsMade) {
  const TempFolder folder;
  EXPECT_TRUE(checkRoom(folder / "", 1).ok());
  const Status room = checkRoom(folder / "", ~0ULL);
  ASSERT_FALSE(room.ok());
  EXPECT_THAT(room.error().line(), HasSubstr("the disk is nearly full"));
}

}  // namespace
}  // namespace stillcut::record
