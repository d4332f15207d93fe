// The disk can die without the cut noticing: the same verdicts and commands, and one event that says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <vector>

#include "core/session/open_recording.h"
#include "tests/component/demo_rig.h"
#include "tests/component/same_bits.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

// Gives up at the given write.
class DyingDisk final : public record::Disk {
 public:
  explicit DyingDisk(int writes) : left_(writes) {}
  bool write(int file, std::uint64_t offset, std::span<const std::byte> bytes) override {
    if (left_-- > 0) return Disk::write(file, offset, bytes);
    errno = EIO;
    return false;
  }

 private:
  int left_;
};

struct Ran {
  std::vector<StepOutput> outputs;
  int stopEvents = 0;
  std::string recording;  // what it said about itself at the end
};

Ran run(const std::string& path, record::Disk* disk) {
  RigSpec spec = test::demoRig();
  spec.autoAllowed = true;
  spec.watched = true;
  auto rig = Rig::build(std::move(spec));
  Ran ran;
  EXPECT_TRUE(rig.ok());
  if (!rig) return ran;
  record::RecorderOptions options;
  options.disk = disk;
  if (!path.empty()) {
    EXPECT_EQ((*rig)->recordTo(path, "", options).ok(), path.find("/proc/") != 0);
  }
  (*rig)->send({OperatorAction::SetAuthority, Authority::Auto});
  std::uint64_t seen = 0;
  (*rig)->runToEnd([&](const StepInput&, const StepOutput& output) {
    ran.outputs.push_back(output);
    const Snapshot* picture = (*rig)->read();
    for (; seen < picture->eventCount; ++seen) {
      const Event& event = picture->events[seen % kEventsShown];
      ran.stopEvents += event.reason.code == ReasonCode::RecorderStopped && event.level == EventLevel::Fault ? 1 : 0;
    }
  });
  if (!path.empty()) {
    const Status finished = (*rig)->recorder()->finish();
    if (!finished) ran.recording = finished.error().line();
  }
  return ran;
}

TEST(RecordingFails, ControlGoesOnAndSaysOnceThatNothingIsRecorded) {
  const record::TempFolder folder;
  const Ran undisturbed = run("", nullptr);
  ASSERT_GT(undisturbed.outputs.size(), 400U);
  EXPECT_EQ(undisturbed.stopEvents, 0);
  for (const int writes : {200, 300}) {
    DyingDisk disk(writes);
    const std::string path = folder / "cut.h5";
    const Ran ran = run(path, &disk);
    EXPECT_EQ(ran.stopEvents, 1) << writes;
    EXPECT_THAT(ran.recording, testing::HasSubstr("Input/output error"));
    EXPECT_EQ(ran.recording.find('\n'), std::string::npos);
    ASSERT_EQ(ran.outputs.size(), undisturbed.outputs.size());
    for (std::size_t i = 0; i < ran.outputs.size(); ++i) {
      ASSERT_EQ(test::difference(ran.outputs[i], undisturbed.outputs[i]), "") << "step " << i;
    }
    const auto reader = record::openRecording(path);
    ASSERT_TRUE(reader.ok()) << reader.error().line();
    EXPECT_GT((*reader)->format().blocks, 0);
    EXPECT_LT((*reader)->format().blocks, static_cast<std::int64_t>(ran.outputs.size()));
  }
}

TEST(RecordingFails, WhereNothingCanBeRecordedTheCutIsWatchedAllTheSame) {
  const Ran undisturbed = run("", nullptr);
  const Ran ran = run("/proc/cut.h5", nullptr);
  EXPECT_EQ(ran.stopEvents, 1);
  EXPECT_THAT(ran.recording, testing::HasSubstr("/proc/cut.h5: the session file cannot be created"));
  ASSERT_EQ(ran.outputs.size(), undisturbed.outputs.size());
  EXPECT_EQ(test::difference(ran.outputs.back(), undisturbed.outputs.back()), "");
}

}  // namespace
}  // namespace stillcut::app
