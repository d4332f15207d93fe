// Full chatter that becomes less: for how long it is called chatter, and by which line.
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kRate = 12800.0;
constexpr double kSpindle = 105.0;
constexpr int kTeeth = 3;
constexpr double kOrder = 7.4;
constexpr double kCut = 0.5, kGrows = 1.5, kFalls = 2.5, kFallen = 2.7, kSeconds = 4.5;  // s
constexpr double kDips = 3.2, kDipped = 3.3;                                             // s
constexpr double kFull = 1.5;  // amplitude, over that of the first tooth passing

// What is left of it: the line that grew, and another one.
struct Rest {
  double amplitude = 0.0;
  double otherOrder = 0.0, otherAmplitude = 0.0;
  double inDip = 1.0;  // part of all that from kDips to kDipped
};

// Air; a cut with five tooth passings and runout; from kGrows on chatter, full within 0.15 s; from kFalls to kFallen it
// becomes what is left.
Recording make(const Rest& rest) {
  std::mt19937 engine(17);
  std::normal_distribution<double> normal;
  Recording r;
  r.rate = kRate;
  r.channels.assign(1, std::vector<float>(static_cast<std::size_t>(kSeconds * kRate)));
  for (std::size_t i = 0; i < r.frames(); ++i) {
    const double t = static_cast<double>(i) / kRate;
    const double turn = kTwoPi * kSpindle * t;
    const double in = std::clamp((t - kCut) / 0.03, 0.0, 1.0);
    const double fallen = std::clamp((t - kFalls) / (kFallen - kFalls), 0.0, 1.0);
    const double grown = t < kGrows ? 0.0 : std::min(kFull, 0.02 * std::exp((t - kGrows) / 0.03));
    double x = steadyCutAt(turn, kTeeth);
    const double left = fallen * (t > kDips && t < kDipped ? rest.inDip : 1.0);
    x += ((1.0 - fallen) * grown + left * rest.amplitude) * std::sin(kOrder * turn);
    x += left * rest.otherAmplitude * std::sin(rest.otherOrder * turn);
    r.channels[0][i] = static_cast<float>(in * x + 0.01 * normal(engine));
  }
  return r;
}

RunResult runOn(const Rest& rest) {
  RunOptions o;
  o.teeth = kTeeth;
  o.rpm = 60.0 * kSpindle;
  o.quantity = SensorQuantity::Sound;
  return run(make(rest), o);
}

// Twenty times a second.
std::vector<double> looks(double begin, double end) {
  std::vector<double> out(static_cast<size_t>(std::ceil((end - begin) * 20.0)));
  for (size_t i = 0; i < out.size(); ++i) out[i] = begin + 0.05 * static_cast<double>(i);
  return out;
}

void expectChatterTo(const RunResult& r, double end) {
  EXPECT_GT(r.firstAlarm, kGrows);
  EXPECT_LT(r.firstAlarm, kGrows + 0.15);
  for (const double t : looks(kGrows + 0.3, end)) {
    const Verdict& v = r.at(t);
    EXPECT_EQ(v.state, CutState::Chatter) << t;
    ASSERT_EQ(v.reason.code, ReasonCode::EnergyRatioHigh) << t;
    EXPECT_GE(v.reason.n[0], v.reason.n[1]) << t << " says what it is over";
  }
}

// Two fifths of the first tooth passing's amplitude: below half of the ratio at which full chatter begins.
TEST(LastingChatter, LastsWhileAFifthOfTheAmplitudeIsItsLine) {
  const RunResult r = runOn({0.4, 0.0, 0.0});
  EXPECT_LT(r.at(kSeconds - 0.1).severity.value, 0.1);
  expectChatterTo(r, kSeconds - 0.05);
}

// The teeth make of it another line, a tooth passing above, which is the stronger one now.
TEST(LastingChatter, LastsInItsSideLine) {
  const RunResult r = runOn({0.1, kOrder + kTeeth, 0.4});
  EXPECT_LT(r.at(kSeconds - 0.1).severity.value, 0.1);
  expectChatterTo(r, kSeconds - 0.05);
}

// For ten turns it is less than chatter has to be, and then as much as before.
TEST(LastingChatter, ComesBackAsWhatItWas) {
  const RunResult r = runOn({0.4, 0.0, 0.0, 0.2});
  expectChatterTo(r, kDips);
  EXPECT_LT(r.at(kSeconds - 0.1).severity.value, 0.1);
  EXPECT_EQ(r.at(kDipped - 0.02).state, CutState::Onset);
  EXPECT_EQ(r.at(kDipped + 0.2).state, CutState::Chatter);
  EXPECT_EQ(r.verdicts.back().state, CutState::Chatter);
}

// Less, or as much of something else, still is more than the calm cut had, and no full chatter.
void expectNoneFrom(const RunResult& r, double begin) {
  expectChatterTo(r, kFalls);
  for (const double t : looks(begin, kSeconds - 0.05)) EXPECT_NE(r.at(t).state, CutState::Chatter) << t;
}

TEST(LastingChatter, IsNoneWhereLessIsLeft) {
  expectNoneFrom(runOn({0.1, 0.0, 0.0}), kFallen + 0.25);
}

TEST(LastingChatter, IsNoneWhereAnotherLineIsLeft) {
  expectNoneFrom(runOn({0.0, 5.62, 0.4}), kFallen + 0.35);
}

}  // namespace
}  // namespace stillcut::detect::testing
