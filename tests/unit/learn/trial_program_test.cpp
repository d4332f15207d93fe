// The programs do what they say: speed and feed rise together, the depth rises along the path, and nothing else moves.
#include "core/learn/trial_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <vector>

namespace stillcut::learn {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

// One move with the words in force.
struct Move {
  double x = 0.0, z = 0.0, feed = 0.0, speed = 0.0;
};

std::vector<Move> feedMoves(const std::string& text) {
  std::vector<Move> moves;
  Move now;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("(")) continue;
    std::istringstream words(line);
    bool feeding = false;
    for (std::string word; words >> word;) {
      const double value = std::strtod(word.c_str() + 1, nullptr);
      if (word == "G1") feeding = true;
      if (word[0] == 'X') now.x = value;
      if (word[0] == 'Z') now.z = value;
      if (word[0] == 'F') now.feed = value;
      if (word[0] == 'S') now.speed = value;
    }
    if (feeding) moves.push_back(now);
  }
  return moves;
}

TrialProgram sweep() {
  TrialProgram t;
  t.kind = TrialKind::SpeedSweep;
  t.teeth = 2;
  t.feedPerTooth = Metres(50e-6);
  t.speed = Rpm(8000.0);
  t.lastSpeed = Rpm(10000.0);
  t.depth = Metres(1e-3);
  t.diameter = Metres(0.025);
  t.length = Metres(0.3);
  return t;
}

TEST(TrialProgram, ASweepKeepsFeedPerToothAndRisesThreePercentASecond) {
  for (const Controller controller : {Controller::LinuxCnc, Controller::Grbl}) {
    TrialProgram t = sweep();
    t.controller = controller;
    const auto text = trialGCode(t);
    ASSERT_TRUE(text.ok()) << text.error().line();
    const auto moves = feedMoves(*text);
    double time = 0.0;
    double last = 0.0;
    for (std::size_t i = 2; i + 1 < moves.size(); ++i) {
      EXPECT_NEAR(moves[i].feed / (2.0 * moves[i].speed), 0.05, 1e-4);
      EXPECT_NEAR(moves[i].z, -1.0, 1e-9);
      time += (moves[i].x - last) / moves[i].feed * 60.0;
      last = moves[i].x;
    }
    EXPECT_NEAR(std::log(10000.0 / 8000.0) / time, std::log(1.03), 0.2 * std::log(1.03));
    EXPECT_EQ(moves[moves.size() - 2].speed, 10000.0);
  }
}

TEST(TrialProgram, ASweepDownwardsGoesDown) {
  TrialProgram t = sweep();
  std::swap(t.speed, t.lastSpeed);
  const auto moves = feedMoves(trialGCode(t).value());
  for (std::size_t i = 3; i + 1 < moves.size(); ++i) EXPECT_LT(moves[i].speed, moves[i - 1].speed);
}

TEST(TrialProgram, AnInclineEndsAtItsLastDepth) {
  TrialProgram t = sweep();
  t.kind = TrialKind::Incline;
  t.lastDepth = Metres(3e-3);
  const auto moves = feedMoves(trialGCode(t).value());
  EXPECT_NEAR(moves[1].z, -1.0, 1e-9);
  EXPECT_NEAR(moves[2].x, 300.0, 1e-9);
  EXPECT_NEAR(moves[2].z, -3.0, 1e-9);
}

TEST(TrialProgram, StartsTheSpindleBeforeTheMaterialAndEndsAboveIt) {
  const std::string text = trialGCode(sweep()).value();
  EXPECT_LT(text.find("M3"), text.find("\nG1 "));
  EXPECT_THAT(text, EndsWith("G0 Z5.000\nM5\nM2\n"));
  EXPECT_THAT(text, HasSubstr("G64"));
  TrialProgram grbl = sweep();
  grbl.controller = Controller::Grbl;
  EXPECT_THAT(trialGCode(grbl).value(), Not(HasSubstr("G64")));  // Grbl does not know it
}

// G49 before the first move in Z would send the tool into the stock by its own length, G54 to another origin.
TEST(TrialProgram, KeepsTheOffsetsInForce) {
  for (const Controller controller : {Controller::LinuxCnc, Controller::Grbl}) {
    TrialProgram t = sweep();
    t.controller = controller;
    const std::string text = trialGCode(t).value();
    for (const char* word : {"G43", "G49", "G5", "G10", "G92"}) EXPECT_THAT(text, Not(HasSubstr(word))) << word;
  }
}

// It goes down and up beside the stock, not into it.
TEST(TrialProgram, ComesDownItsRadiusAwayFromTheStock) {
  const std::string text = trialGCode(sweep()).value();
  EXPECT_LT(text.find("G0 X-17.500 Y0.000"), text.find("G1 Z-1.0000"));
  EXPECT_NEAR(feedMoves(text).back().x, 317.5, 1e-9);
}

TEST(TrialProgram, RefusesWhatCannotBeCut) {
  TrialProgram t = sweep();
  t.length = Metres(0.01);
  ASSERT_FALSE(trialGCode(t).ok());
  EXPECT_THAT(trialGCode(t).error().line(), HasSubstr("mm of material"));
  t = sweep();
  t.feedPerTooth = Metres(std::nan(""));
  EXPECT_FALSE(trialGCode(t).ok());
  t = sweep();
  t.kind = TrialKind::Incline;
  EXPECT_FALSE(trialGCode(t).ok());
  t = sweep();
  t.diameter = {};
  EXPECT_FALSE(trialGCode(t).ok());
}

}  // namespace
}  // namespace stillcut::learn
