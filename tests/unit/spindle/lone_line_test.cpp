// A tone that is there from the first sample on may be the machine's own or chatter: it is called neither air nor a
// cut, however it beats.
#include "core/spindle/lone_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/support/recording_runner.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kRate = 8192.0;
constexpr double kSpindle = 100.0;
constexpr double kTone = 655.0;
constexpr double kSeconds = 3.0;

// beats: amplitude at a spindle angle, around 1.
Recording tone(double hertz, const std::function<double(double angle)>& beats, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0.0, 0.1);
  Recording r;
  r.rate = kRate;
  r.channels.resize(1);
  for (int k = 0; k < static_cast<int>(kSeconds * kRate); ++k) {
    const double t = k / kRate;
    const double x = beats(kTwoPi * kSpindle * t) * std::cos(kTwoPi * hertz * t);
    r.channels[0].push_back(static_cast<float>(x + noise(engine)));
  }
  return r;
}

double steadily(double) {
  return 1.0;
}
double onceATurn(double angle) {
  return 1.0 + 0.1 * std::cos(angle);
}
// Four teeth with runout.
double asTeethCut(double angle) {
  return 1.0 + 0.1 * std::cos(3.0 * angle + 1.0) + 0.15 * std::cos(4.0 * angle) + 0.05 * std::cos(angle + 2.0);
}

struct Heard {
  double doubted = -1.0;  // s, when it was first called neither air nor cut
  double air = 0.0;       // s, called air after that
  double alarm = -1.0;    // s
};

RunOptions told(double ratio) {
  RunOptions options;
  options.teeth = 4;
  options.rpm = 60.0 * kSpindle * ratio;
  return options;
}

Heard hear(double hertz, const std::function<double(double angle)>& beats, unsigned seed, double ratio) {
  Heard heard;
  RunOptions options = told(ratio);
  options.onBlock = [&](const ConditionedBlock& block, const Verdict& verdict) {
    const double t = sinceEpoch(block.end()).value;
    if (!verdict.valid && heard.doubted < 0.0) {
      heard.doubted = t;
      EXPECT_EQ(verdict.reason.code, ReasonCode::NoAirCutting);
      EXPECT_NEAR(verdict.reason.n[0], hertz, 5.0);
    }
    if (verdict.valid && verdict.state == CutState::AirCutting && heard.doubted > 0.0)
      heard.air += block.frames / kRate;
  };
  heard.alarm = run(tone(hertz, beats, seed), options).firstAlarm;
  return heard;
}

class StartedAmid : public ::testing::TestWithParam<double> {};

TEST_P(StartedAmid, AToneIsNeitherAirNorACut) {
  for (const auto& beats : {steadily, onceATurn, asTeethCut}) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      const Heard heard = hear(kTone, beats, seed, GetParam());
      EXPECT_GT(heard.doubted, 0.0) << seed;
      EXPECT_LT(heard.doubted, 24.0 / kSpindle) << seed;
      EXPECT_EQ(heard.air, 0.0) << seed;
      EXPECT_EQ(heard.alarm, -1.0) << seed;
    }
  }
}

// What a tone above a quarter of the rate leaves in the square is folded back.
TEST_P(StartedAmid, AHighToneIsNeitherAirNorACut) {
  const double high = 0.32 * kRate;
  const Heard heard = hear(high, steadily, 1, GetParam());
  EXPECT_GT(heard.doubted, 0.0);
  EXPECT_LT(heard.doubted, 24.0 / kSpindle);
  EXPECT_EQ(heard.alarm, -1.0);
}

INSTANTIATE_TEST_SUITE_P(ToldSpeed, StartedAmid, ::testing::Values(0.98, 1.0, 1.02));

TEST(LoneLine, IsNoDoubtAnyMoreOnceItIsGone) {
  Recording r = tone(kTone, steadily, 1);
  std::mt19937 engine(2);
  std::normal_distribution<double> noise(0.0, 0.7);  // as loud as the tone: no air was heard
  for (std::size_t k = r.frames() / 2; k < r.frames(); ++k) r.channels[0][k] = static_cast<float>(noise(engine));
  const RunResult result = run(r, told(1.0));
  EXPECT_FALSE(result.at(0.45 * kSeconds).valid);
  EXPECT_TRUE(result.at(0.75 * kSeconds).valid);
  EXPECT_EQ(result.at(0.75 * kSeconds).state, CutState::AirCutting);
}

// What was once heard louder than it is now tells air from a cut: the tone is the machine's.
TEST(LoneLine, IsAirWhereACutWasHeard) {
  Recording r = tone(kTone, steadily, 1);
  std::mt19937 engine(2);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (std::size_t k = r.frames() / 4; k < r.frames() / 2; ++k) {
    const double angle = kTwoPi * kSpindle * static_cast<double>(k) / kRate;
    double x = 0.2 * noise(engine);
    for (int n = 4; n <= 16; n += 4) x += 4.0 * std::cos(n * angle + n * n);
    r.channels[0][k] += static_cast<float>(x);
  }
  const RunResult result = run(r, told(1.0));
  EXPECT_FALSE(result.at(0.2 * kSeconds).valid);
  EXPECT_TRUE(result.at(0.45 * kSeconds).valid);
  EXPECT_EQ(result.at(0.45 * kSeconds).state, CutState::Stable);
  EXPECT_TRUE(result.at(0.9 * kSeconds).valid);
  EXPECT_EQ(result.at(0.9 * kSeconds).state, CutState::AirCutting);
}

}  // namespace
}  // namespace stillcut::detect::testing
