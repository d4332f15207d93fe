// The manual's script reads a session with h5py alone, closed or while it is still being written; skipped where h5py is
// not installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "core/session/file/session_markers.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr const char* kPython = "/usr/bin/python3";  // the system's, which the package belongs to

struct Ran {
  int status = -1;
  std::string out;
};

Ran python(const std::string& arguments) {
  Ran ran;
  std::FILE* pipe = popen((std::string("exec ") + kPython + " " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return ran;
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) ran.out += part.data();
  ran.status = pclose(pipe);
  return ran;
}

class H5py : public testing::Test {
 protected:
  void SetUp() override {
    if (python("-c 'import h5py'").status != 0) GTEST_SKIP() << "python3-h5py is not installed";
  }
};

TEST_F(H5py, TheManualsScriptReadsASession) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  {
    auto writer = SessionWriter::create(path, exampleHeader());
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 300; ++i) {
      const StepRecord step = exampleStep(i);
      ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
    }
  }
  const auto number =
      addMarker(path, {0, instantFromNs(1'500'000'000), instantFromNs(2'000'000'000), "chatter", "Ada", "loud", 0});
  ASSERT_TRUE(number.ok());
  const Ran ran = python(STILLCUT_SOURCE_DIR "/resources/manual/read_session.py " + path);
  ASSERT_EQ(ran.status, 0) << ran.out;
  EXPECT_THAT(ran.out, HasSubstr("machine Mill 3"));
  EXPECT_THAT(ran.out, HasSubstr("steps 300 "));
  EXPECT_THAT(ran.out, HasSubstr("marker 1.5 2.0 chatter Ada loud"));

  // What the manual's lines for MATLAB take from a file is there, with these names and as numbers.
  const Ran lines = python("-c \"import h5py; f = h5py.File('" + path +
                           "', 'r'); x = f['samples/00'][:] * f['samples/00'].attrs['scale']; v = f['verdicts']; "
                           "alarms = v['time_ns'][v['state'] >= 2] * 1e-9; m = f['markers'][-1]; "
                           "print('taken', x.dtype.kind, alarms.dtype.kind, m['label'], m['begin_ns'], m['note'])\"");
  ASSERT_EQ(lines.status, 0) << lines.out;
  EXPECT_THAT(lines.out, HasSubstr("taken f f b'chatter' 1500000000 b'loud'"));
}

// Without any program of ours: a recorder was killed, h5clear takes the dead writer's mark away, and h5py reads.
TEST_F(H5py, H5clearIsEnoughAfterAKill) {
  if (std::system("command -v h5clear >/dev/null") != 0) GTEST_SKIP() << "hdf5-tools is not installed";
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  const int added = recordUntilKilled(path, 900);
  ASSERT_GT(added, 900);
  ASSERT_NE(python("-c \"import h5py; h5py.File('" + path + "', 'r')\"").status, 0) << "it needs clearing";
  ASSERT_EQ(std::system(("h5clear -s " + path).c_str()), 0);
  const Ran ran = python("-c \"import h5py; f = h5py.File('" + path +
                         "', 'r'); print('steps', len(f['steps/blocks']), f['samples/01'][1])\"");
  ASSERT_EQ(ran.status, 0) << ran.out;
  constexpr int kStepsPerSecond = 400;  // of exampleStep()
  EXPECT_GE(std::atoi(ran.out.c_str() + std::string("steps ").size()), added - kStepsPerSecond) << ran.out;
}

TEST_F(H5py, ReadsASessionWhileItIsWritten) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  auto writer = SessionWriter::create(path, exampleHeader());
  ASSERT_TRUE(writer.ok());
  for (int i = 0; i < 100; ++i) {
    const StepRecord step = exampleStep(i);
    ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  ASSERT_TRUE((*writer)->flush().ok());
  const Ran ran =
      python("-c \"import h5py; f = h5py.File('" + path +
             "', 'r', swmr=True, libver='latest'); print('steps', len(f['steps/blocks']), f['samples/01'][1])\"");
  ASSERT_EQ(ran.status, 0) << ran.out;
  EXPECT_THAT(ran.out, HasSubstr("steps 100 "));
}

}  // namespace
}  // namespace stillcut::record
