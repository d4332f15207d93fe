// A change of authority leaves a text file that a person can read.

#include "app/compose/flight_log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/gate_harness.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;

class FlightLogTest : public ::testing::Test {
 protected:
  void SetUp() override { recorder_.prepare(Seconds(0.01)); }
  void TearDown() override { fs::remove_all(folder_); }

  void capture(ReasonCode cause) {
    safety::FlightEntry entry;
    entry.time = Instant(toDuration(Seconds(1.0)));
    entry.machine.actualSpeed = Rpm(7654.0);
    recorder_.push(entry);
    ASSERT_TRUE(recorder_.capture({cause, {}}, entry.time));
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> all;
    for (const auto& e : fs::directory_iterator(folder_)) all.push_back(e.path());
    return all;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("stillcut-flights-" + std::to_string(::getpid()));
  safety::FlightRecorder recorder_;
};

TEST_F(FlightLogTest, WritesWhatWaitsAndNamesTheCause) {
  FlightLog log(recorder_, folder_);
  EXPECT_FALSE(log.poll());
  EXPECT_FALSE(fs::exists(folder_)) << "no folder before there is something to say";
  capture(ReasonCode::GateStaleMachine);
  EXPECT_TRUE(log.poll());
  ASSERT_EQ(files().size(), 1U);
  const std::string name = files().front().filename().string();
  EXPECT_NE(name.find("gate-stale-machine.txt"), std::string::npos) << name;
  std::ifstream in(files().front());
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("7654"), std::string::npos) << text;
}

TEST_F(FlightLogTest, KeepsTheNewest) {
  FlightLog log(recorder_, folder_, 2);
  for (ReasonCode cause : {ReasonCode::AuthorityChanged, ReasonCode::GateStaleMachine, ReasonCode::LinkLost}) {
    capture(cause);
    EXPECT_TRUE(log.poll());
  }
  EXPECT_EQ(files().size(), 2U);
}

TEST_F(FlightLogTest, ADiskThatRefusesIsOneLineUntilItTakesTheRecordingAfterAll) {
  std::ofstream(folder_).put('x');  // a file where the folder should be
  FlightLog log(recorder_, folder_);
  capture(ReasonCode::LinkLost);
  EXPECT_FALSE(log.poll());
  EXPECT_NE(text(log.problem()).find(folder_.string()), std::string::npos) << text(log.problem());
  EXPECT_FALSE(log.poll());
  EXPECT_FALSE(log.problem().empty()) << "nothing has been written since";
  fs::remove(folder_);
  EXPECT_TRUE(log.poll());
  EXPECT_TRUE(log.problem().empty());
  EXPECT_EQ(files().size(), 1U) << "the recording that failed is not lost";
}

TEST_F(FlightLogTest, OnePollIsOneFile) {
  FlightLog log(recorder_, folder_);
  capture(ReasonCode::AuthorityChanged);
  capture(ReasonCode::LinkLost);
  EXPECT_TRUE(log.poll());
  EXPECT_EQ(files().size(), 1U);
}

TEST_F(FlightLogTest, TheThreadLeavesNothingUnwritten) {
  FlightLog log(recorder_, folder_);
  log.start();
  capture(ReasonCode::AuthorityChanged);
  capture(ReasonCode::LinkLost);
  EXPECT_TRUE(log.finish().ok());
  EXPECT_EQ(files().size(), 2U);
}

}  // namespace
}  // namespace stillcut::app
