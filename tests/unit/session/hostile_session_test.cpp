// Session files that kill whoever reads them, and names that are no files: an error of one line, never the program's
// end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "core/session/describe_recording.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_reader.h"
#include "core/session/open_recording.h"
#include "core/session/session_folder.h"
#include "core/session/session_glance.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

template <class T>
void expectOneLine(const Result<T>& result, const std::string& what) {
  if (result) return;
  EXPECT_FALSE(result.error().line().empty()) << what;
  EXPECT_EQ(result.error().line().find('\n'), std::string::npos) << what;
}

// To the end, as a summary and a replay do.
void readWhole(const std::string& path) {
  const auto reader = openRecording(path);
  expectOneLine(reader, "open " + path);
  if (!reader) return;
  SampleBlock block;
  const RecordingFormat& format = (*reader)->format();
  block.allocate(static_cast<int>(format.channels.size()), std::max(1, format.blockFrames));
  (void)(*reader)->seek(instantFromNs(0)).ok();
  for (Result<bool> more = true; more && *more; more = (*reader)->read(block)) expectOneLine(more, "read " + path);
}

TEST(HostileSession, NoDamagedFileEndsTheProgramWhateverIsAskedOfIt) {
  const fs::path folder = fs::path(STILLCUT_SHARED_DIR) / "cases_hostile";
  std::error_code none;
  int tried = 0;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() != ".h5") continue;
    const TempFolder copies;
    const std::string path = copies / "copy.h5";
    const auto fresh = [&] { fs::copy_file(entry.path(), path, fs::copy_options::overwrite_existing); };
    fresh();
    ++tried;
    (void)glanceAtSession(path);
    readWhole(path);
    expectOneLine(describeRecording(path), "describe " + path);
    expectOneLine(readMarkers(path), "markers " + path);
    expectOneLine(countSession(path), "count " + path);
    expectOneLine(readTruthSeries(path), "truth " + path);
    expectOneLine(sketchSession(path, 64), "sketch " + path);
    (void)checkReplaceable(path, MayReplace::SimulatedSession).ok();
    expectOneLine(addMarker(path, {0, {}, {}, "note", "Ada", "", 0}), "mark " + path);
    fresh();
    expectOneLine(repairSession(path), "repair " + path);
    RecordPlan plan = recordPlan(config::ParamSet());
    plan.keepBytes = 1;
    (void)applyRetention(copies / "", plan, nowUtc());
  }
  if (tried == 0) GTEST_SKIP() << "no such files here";
}

TEST(HostileSession, PipesAndDevicesAreRefusedAtOnce) {
  const TempFolder folder;
  const std::string pipe = folder / "pipe.h5";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/zero"), folder / ""}) {
    const auto markers = readMarkers(path);
    ASSERT_FALSE(markers.ok());
    EXPECT_THAT(markers.error().line(), HasSubstr("is not a regular file"));
    EXPECT_FALSE(glanceAtSession(path));
    EXPECT_FALSE(openRecording(path).ok());
    EXPECT_FALSE(repairSession(path).ok());
  }
}

// What crosses from one process to the other is what was recorded, in both directions.
TEST(HostileSession, ASoundSessionIsReadSoughtAndMarkedThroughTheOtherProcess) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  SessionHeader header = exampleHeader();
  header.job = "Gehäuse";
  header.operatorName = "M\xFCller";  // bytes that are no UTF-8 come back as they were
  {
    auto writer = SessionWriter::create(path, header);
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 300; ++i) {
      const StepRecord step = exampleStep(i);
      ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
    }
    ASSERT_TRUE((*writer)->close().ok());
  }
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok()) << reader.error().line();
  const RecordingFormat& format = (*reader)->format();
  EXPECT_EQ(format.job, header.job);
  EXPECT_EQ(format.operatorName, header.operatorName);
  EXPECT_EQ(format.configuration, header.configuration);
  EXPECT_EQ(format.blocks, 300);
  ASSERT_TRUE(format.setup.has_value());
  EXPECT_EQ(format.setup->tool, exampleSetup().tool);
  EXPECT_EQ(format.setup->channels.size(), exampleSetup().channels.size());
  SampleBlock block;
  block.allocate(2, format.blockFrames);
  Result<bool> more = true;
  while (more && *more) more = (*reader)->read(block);  // to the end, and back
  for (const int wanted : {200, 10}) {
    const StepRecord expected = exampleStep(wanted);
    ASSERT_TRUE((*reader)->seek(expected.input.block.firstSample).value());
    ASSERT_TRUE((*reader)->read(block).value());
    ASSERT_NE((*reader)->recordedStep(), nullptr);
    EXPECT_EQ(bitsOf((*reader)->recordedStep()->input), bitsOf(expected.input)) << wanted;
    EXPECT_EQ(bitsOf((*reader)->recordedStep()->output), bitsOf(expected.output)) << wanted;
  }
  const auto number = addMarker(path, {0, instantFromNs(5), instantFromNs(9), "note", "Ädä", "laut", 0});
  ASSERT_TRUE(number.ok()) << number.error().line();
  const auto markers = readMarkers(path);
  ASSERT_TRUE(markers.ok());
  const auto mine =
      std::find_if(markers->begin(), markers->end(), [&](const Marker& m) { return m.number == *number; });
  ASSERT_NE(mine, markers->end());
  EXPECT_EQ(mine->author, "Ädä");
  EXPECT_EQ(toNs(mine->end), 9);
}

}  // namespace
}  // namespace stillcut::record
