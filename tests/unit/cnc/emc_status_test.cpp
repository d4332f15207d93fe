// LinuxCNC's replies as values: each reply sets what it says and when, nonsense sets nothing.
#include "core/cnc/linuxcnc/emc_status.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace stillcut::cnc {
namespace {

Instant at(double seconds) {
  return Instant{} + toDuration(Seconds(seconds));
}

TEST(EmcStatus, OverridesAreStampedWithTheirTime) {
  EmcStatus s;
  EXPECT_FALSE(s.feedOverride.ever);
  EXPECT_TRUE(s.take("FEED_OVERRIDE 95", at(1.0)));
  EXPECT_TRUE(s.take("SPINDLE_OVERRIDE 0 110.4", at(2.0)));
  EXPECT_EQ(s.feedOverride.value, 95);
  EXPECT_EQ(s.spindleOverride.value, 110);
  EXPECT_EQ(s.feedOverride.when, at(1.0));
  EXPECT_EQ(s.spindleOverride.when, at(2.0));
}

TEST(EmcStatus, OnlyTheFirstSpindleCounts) {
  EmcStatus s;
  EXPECT_FALSE(s.take("SPINDLE_OVERRIDE 1 80", at(1.0)));
  EXPECT_FALSE(s.spindleOverride.ever);
}

TEST(EmcStatus, ProgramStates) {
  EmcStatus s;
  EXPECT_TRUE(s.take("PROGRAM_STATUS RUNNING", at(1.0)));
  EXPECT_EQ(s.program.value, EmcProgram::Running);
  EXPECT_TRUE(s.take("PROGRAM_STATUS PAUSED", at(2.0)));
  EXPECT_EQ(s.program.value, EmcProgram::Paused);
  EXPECT_TRUE(s.take("PROGRAM_STATUS IDLE", at(3.0)));
  EXPECT_EQ(s.program.value, EmcProgram::Idle);
  EXPECT_FALSE(s.take("PROGRAM_STATUS LOST", at(4.0)));
  EXPECT_EQ(s.program.when, at(3.0));
}

TEST(EmcStatus, FeedWordsAreInTheProgramsUnits) {
  EmcStatus s;
  EXPECT_TRUE(s.take("PROGRAM_CODES G80 G17 G40 G21 G90 F600 S5000", at(1.0)));
  EXPECT_NEAR(s.feedWord.value.value, 0.01, 1e-15);
  EXPECT_EQ(s.speedWord.value.value, 5000.0);
  EXPECT_TRUE(s.take("PROGRAM_CODES G20 F60 S-3000", at(2.0)));
  EXPECT_NEAR(s.feedWord.value.value, 0.0254, 1e-15);
  EXPECT_EQ(s.speedWord.value.value, 3000.0);  // backwards is a speed too
}

TEST(EmcStatus, CodesWithoutBothWordsSetNothing) {
  EmcStatus s;
  for (const char* line : {"PROGRAM_CODES G21 F600", "PROGRAM_CODES S5000", "PROGRAM_CODES F-1 S5000",
                           "PROGRAM_CODES F1e99 S1", "PROGRAM_CODES F1 S2e6", "PROGRAM_CODES Fx Sy", "PROGRAM_CODES"}) {
    EXPECT_FALSE(s.take(line, at(1.0))) << line;
  }
  EXPECT_FALSE(s.feedWord.ever);
  EXPECT_FALSE(s.speedWord.ever);
}

TEST(EmcStatus, PinsInTheirUnits) {
  EmcStatus s;
  EXPECT_TRUE(s.take("PINVAL spindle.0.speed-in 141.5", at(1.0)));  // rev/s
  EXPECT_NEAR(s.actualSpeed.value.value, 8490.0, 1e-9);
  EXPECT_TRUE(s.take("PINVAL spindle.0.speed-out -8500", at(1.0)));  // rev/min
  EXPECT_EQ(s.commandedSpeed.value.value, 8500.0);
  EXPECT_TRUE(s.take("PINVAL motion.current-vel 45.3", at(1.0)));  // mm/s
  EXPECT_NEAR(s.currentFeed.value.value, 0.0453, 1e-15);
  EmcStatus inches;
  inches.machineUnit = 0.0254;
  EXPECT_TRUE(inches.take("PINVAL motion.current-vel 2", at(1.0)));  // in/s
  EXPECT_NEAR(inches.currentFeed.value.value, 0.0508, 1e-15);
  EXPECT_TRUE(s.take("PINVAL motion.adaptive-feed 0.7", at(1.0)));
  EXPECT_EQ(s.adaptiveFeed.value, 0.7);
  EXPECT_TRUE(s.take("PINVAL spindle.0.at-speed TRUE", at(1.0)));
  EXPECT_TRUE(s.atSpeed.value);
  EXPECT_TRUE(s.take("PINVAL motion.feed-hold FALSE", at(1.0)));
  EXPECT_FALSE(s.feedHold.value);
  EXPECT_TRUE(s.feedHold.ever);
}

TEST(EmcStatus, PinsThatMakeNoSenseSetNothing) {
  EmcStatus s;
  for (const char* line :
       {"PINVAL spindle.0.speed-in nan", "PINVAL spindle.0.speed-in 1e9", "PINVAL spindle.0.at-speed 1",
        "PINVAL motion.adaptive-feed 2", "PINVAL motion.current-vel inf", "PINVAL unknown.pin 3", "PINVAL",
        "PINVAL motion.feed-hold true", "MACHINE on", "ENABLE", "FEED_OVERRIDE", "FEED_OVERRIDE -1",
        "FEED_OVERRIDE 1001", "FEED_OVERRIDE ON", "HELLO EMC", ""}) {
    EXPECT_FALSE(s.take(line, at(1.0))) << line;
  }
  EXPECT_FALSE(s.actualSpeed.ever || s.atSpeed.ever || s.adaptiveFeed.ever || s.currentFeed.ever || s.feedHold.ever ||
               s.machineOn.ever || s.inControl.ever || s.feedOverride.ever);
}

TEST(EmcStatus, MachineAndControl) {
  EmcStatus s;
  EXPECT_TRUE(s.take("MACHINE ON", at(1.0)));
  EXPECT_TRUE(s.take("ENABLE OFF", at(1.0)));
  EXPECT_TRUE(s.machineOn.value);
  EXPECT_FALSE(s.inControl.value);
}

// Replies run into each other and bits turn: values stay within what a machine can have.
TEST(EmcStatus, HostileRepliesStaySane) {
  const std::string replies[] = {"FEED_OVERRIDE 95", "SPINDLE_OVERRIDE 0 110", "PROGRAM_CODES G21 F600 S5000",
                                 "PINVAL spindle.0.speed-in 141.5", "PINVAL motion.current-vel 45"};
  std::mt19937 random(8);
  EmcStatus s;
  for (int trial = 0; trial < 30000; ++trial) {
    std::string line = replies[random() % 5].substr(0, 1 + random() % 30) + replies[random() % 5].substr(random() % 9);
    line[random() % line.size()] = static_cast<char>(32 + random() % 95);
    s.take(line, at(1e-3 * trial));
    EXPECT_GE(s.feedOverride.value, 0);
    EXPECT_LE(s.feedOverride.value, 1000);
    EXPECT_GE(s.spindleOverride.value, 0);
    EXPECT_LE(s.spindleOverride.value, 1000);
    EXPECT_LE(s.actualSpeed.value.value, 1e6);
    EXPECT_TRUE(isFinite(s.feedWord.value) && s.feedWord.value.value >= 0.0);
    EXPECT_TRUE(isFinite(s.currentFeed.value) && s.currentFeed.value.value >= 0.0);
  }
}

}  // namespace
}  // namespace stillcut::cnc
