// GRBL's lines and bytes: steps against a controller written out, reports whole, cut off and hostile.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/cnc/grbl/grbl_status.h"

namespace stillcut::cnc {
namespace {

// The controller's side of the five bytes, as its manual has it.
int afterByte(int present, unsigned char byte, unsigned char first) {
  constexpr int kSteps[] = {0, 10, -10, 1, -1};
  if (byte == 0) return present;
  const int which = byte - first;
  EXPECT_GE(which, 0);
  EXPECT_LE(which, 4);
  if (which == 0) return 100;
  const int next = present + kSteps[which];
  return next > kGrblHighest ? kGrblHighest : next < kGrblLowest ? kGrblLowest : next;
}

TEST(GrblSteps, LeadFromEveryPercentToEveryOther) {
  for (const unsigned char first : {kGrblFeedBytes, kGrblSpindleBytes}) {
    for (int from = kGrblLowest; from <= kGrblHighest; ++from) {
      for (int to = 0; to <= 210; ++to) {
        int present = from;
        int rounds = 0;
        const int wanted = to > kGrblHighest ? kGrblHighest : to < kGrblLowest ? kGrblLowest : to;
        while (present != wanted && rounds < 60) {
          const GrblSteps steps = stepToward(to, present, first);
          int next = afterByte(present, steps.coarse, first);
          next = afterByte(next, steps.fine, first);
          ASSERT_EQ(next, steps.percent) << from << " to " << to << " at " << present;
          ASSERT_NE(next, present) << from << " to " << to << " stands still at " << present;
          present = next;
          ++rounds;
        }
        ASSERT_EQ(present, wanted) << from;
        ASSERT_LE(rounds, 25) << from << " to " << to;
      }
    }
  }
}

TEST(GrblSteps, NothingToDoIsNoByte) {
  for (int percent = kGrblLowest; percent <= kGrblHighest; ++percent) {
    const GrblSteps steps = stepToward(percent, percent, kGrblFeedBytes);
    EXPECT_EQ(steps.coarse, 0);
    EXPECT_EQ(steps.fine, 0);
    EXPECT_EQ(steps.percent, percent);
  }
}

TEST(GrblLines, AreToldApart) {
  GrblReport report;
  GrblWords words;
  EXPECT_EQ(readGrblLine("Grbl 1.1h ['$' for help]", report, words), GrblLine::Welcome);
  EXPECT_EQ(readGrblLine("GrblHAL 1.1f ['$' or '$HELP' for help]", report, words), GrblLine::Welcome);
  EXPECT_EQ(readGrblLine("ALARM:1", report, words), GrblLine::AlarmNote);
  EXPECT_EQ(readGrblLine("ok", report, words), GrblLine::Other);
  EXPECT_EQ(readGrblLine("error:9", report, words), GrblLine::Other);
  EXPECT_EQ(readGrblLine("", report, words), GrblLine::Other);
  EXPECT_EQ(readGrblLine("<>", report, words), GrblLine::Other);
  EXPECT_EQ(readGrblLine("[GC:G0 G54 G17 G21 G90 G94 M3 M9 T0 F1200 S8000]", report, words), GrblLine::Words);
  EXPECT_EQ(words.feed, 1200.0);
  EXPECT_EQ(words.speed, 8000.0);
  EXPECT_FALSE(words.inches);
  EXPECT_EQ(readGrblLine("[GC:G20 F10. S3000.5]", report, words), GrblLine::Words);
  EXPECT_TRUE(words.inches);
  EXPECT_EQ(words.speed, 3000.5);
}

TEST(GrblLines, ParserStateWithoutBothWordsChangesNothing) {
  GrblReport report;
  GrblWords words{1.0, 2.0, true};
  for (const char* line : {"[GC:G21 S8000]", "[GC:F100]", "[GC:F1e9 S8000]", "[GC:F-1 S8000]", "[GC:Fx S8000]"}) {
    EXPECT_EQ(readGrblLine(line, report, words), GrblLine::Other) << line;
    EXPECT_EQ(words.feed, 1.0);
    EXPECT_EQ(words.speed, 2.0);
    EXPECT_TRUE(words.inches);
  }
}

TEST(GrblReportLine, EveryState) {
  GrblWords words;
  const std::pair<const char*, GrblState> states[] = {
      {"Idle", GrblState::Idle},   {"Run", GrblState::Run},     {"Jog", GrblState::Run},    {"Hold:0", GrblState::Hold},
      {"Hold:1", GrblState::Hold}, {"Door:3", GrblState::Hold}, {"Tool", GrblState::Hold},  {"Alarm", GrblState::Alarm},
      {"Check", GrblState::Other}, {"Home", GrblState::Other},  {"Sleep", GrblState::Other}};
  for (const auto& [text, state] : states) {
    GrblReport report;
    EXPECT_EQ(readGrblLine("<" + std::string(text) + "|MPos:0.000,0.000,0.000|FS:0,0>", report, words),
              GrblLine::Report);
    EXPECT_EQ(report.state, state) << text;
  }
}

TEST(GrblReportLine, FieldsInAnyOrderAndUnknownOnesPassedOver) {
  GrblReport report;
  GrblWords words;
  ASSERT_EQ(readGrblLine("<Run|Bf:15,128|Ov:110,100,90|Ln:7|FS:1200.5,8800,8791|WCO:0,0,0|A:S>", report, words),
            GrblLine::Report);
  EXPECT_EQ(report.feed, 1200.5);
  EXPECT_EQ(report.speed, 8800.0);
  EXPECT_EQ(report.measuredSpeed, 8791.0);
  EXPECT_EQ(report.feedOverride, 110);
  EXPECT_EQ(report.speedOverride, 90);
}

TEST(GrblReportLine, OverridesThatCannotBeAreNotTaken) {
  GrblWords words;
  for (const char* field : {"Ov:300,100,100", "Ov:100,100,201", "Ov:100,100", "Ov:", "Ov:a,b,c", "Ov:-5,100,100"}) {
    GrblReport report;
    EXPECT_EQ(readGrblLine("<Run|" + std::string(field) + ">", report, words), GrblLine::Report);
    EXPECT_FALSE(report.feedOverride.has_value()) << field;
    EXPECT_FALSE(report.speedOverride.has_value()) << field;
  }
}

// Whatever arrives: no crash, and no number outside what a machine can have.
TEST(GrblReportLine, BitsTurnedAndTailsLostStaySane) {
  const std::string whole = "<Run|MPos:0.000,0.000,0.000|FS:1200,8800,8791|Ov:110,100,90|A:S>";
  std::mt19937 random(5);
  for (int trial = 0; trial < 20000; ++trial) {
    std::string line = whole.substr(0, random() % (whole.size() + 1));
    for (auto flips = random() % 4; flips > 0 && !line.empty(); --flips) {
      line[random() % line.size()] = static_cast<char>(random() % 256);
    }
    GrblReport report;
    GrblWords words;
    readGrblLine(line, report, words);
    for (const auto& value : {report.feed, report.speed, report.measuredSpeed}) {
      EXPECT_TRUE(!value || (*value >= 0.0 && *value <= 1e6)) << line;
    }
    for (const auto& percent : {report.feedOverride, report.speedOverride}) {
      EXPECT_TRUE(!percent || (*percent >= 0 && *percent <= kGrblHighest)) << line;
    }
  }
}

}  // namespace
}  // namespace stillcut::cnc
