// The spindle runs to another speed within a fraction of a second, as a strategy asks it to; the machine tells its
// speed.
#include <algorithm>

#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kRampStart = 2.0;
constexpr double kRampSeconds = 0.3;
constexpr double kFrom = 141.7;
constexpr double kTo = 0.82 * kFrom;
constexpr double kChatterHertz = 937.0;

double speedAt(double t) {
  const double share = std::clamp((t - kRampStart) / kRampSeconds, 0.0, 1.0);
  return kFrom + share * (kTo - kFrom);
}

// Forced vibration whose tooth harmonics follow the speed, and their amplitudes with it; with `chatter`, chatter of the
// forced amplitude from 1.5 s on that dies away (time constant 20 ms) once the speed is half way.
Recording rampedCut(bool chatter, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  Recording r;
  r.rate = 25600.0;
  r.channels.assign(1, {});
  double angle = 0.0;
  double size = 0.0;
  for (int k = 0; k < static_cast<int>(4.0 * r.rate); ++k) {
    const double t = k / r.rate;
    const double speed = speedAt(t);
    angle += kTwoPi * speed / r.rate;
    double x = 0.02 * normal(engine);
    for (int h = 1; h <= 24; ++h) {
      const double amplitude = h % 4 == 0 ? 4.0 / h : 0.05;
      x += amplitude * std::pow(speed / kFrom, 2) * std::cos(h * angle + 0.7 * h * h);
    }
    if (chatter && t > 1.5) {
      const bool dying = t > kRampStart + 0.5 * kRampSeconds;
      size = dying ? size * std::exp(-1.0 / (0.02 * r.rate)) : std::min(1.0, 0.02 * std::exp((t - 1.5) / 0.03));
      x += size * std::sin(kTwoPi * kChatterHertz * t);
    }
    r.channels[0].push_back(static_cast<float>(x));
  }
  return r;
}

RunOptions withMachine(double error, double age = 0.0) {
  RunOptions o;
  o.teeth = 4;
  o.rpm = 60.0 * kFrom;
  o.machine = [error, age](double t) {
    MachineState m;
    m.valid = m.linkUp = true;
    m.programmedSpeed = Rpm(60.0 * kFrom);
    m.speedOverride = Ratio(t < kRampStart ? 1.0 : kTo / kFrom);
    m.actualSpeed = Rpm(60.0 * speedAt(t - age) * (1.0 + error));
    if (age > 0.0) m.link.speed = Instant(toDuration(Seconds(t - age)));
    return m;
  };
  return o;
}

TEST(SpeedRamp, OfAStableCutIsNoAlarm) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    for (const double error : {0.0, -0.005, 0.005}) {
      const RunResult r = run(rampedCut(false, seed), withMachine(error));
      EXPECT_LT(r.firstAlarm, 0.0) << "seed " << seed << " machine off by " << error;
      EXPECT_NEAR(r.verdicts.back().spindle.value, kTo, 1e-3 * kTo);
      EXPECT_EQ(r.verdicts.back().state, CutState::Stable);
    }
  }
}

// Telemetry tells the speed of a moment ago, and which moment: the spindle has gone on since. Whatever is made of it is
// stated with its doubt; once the readings show the ramp, what has changed since (60 % a second) is made up for.
TEST(SpeedRamp, OfWhichTelemetryTellsLateIsFollowedAndDoubted) {
  for (const double age : {0.05, 0.1}) {
    const double shown = kRampStart + 0.1 + 2.0 * age;
    double most = 0.0;
    double doubts = 0.0;
    RunOptions o = withMachine(0.0, age);
    o.onBlock = [&](const ConditionedBlock& b, const Verdict& v) {
      const double t = sinceEpoch(v.time).value;
      if (t < 1.0) return;
      const double off = std::abs(b.spindle.value / speedAt(t) - 1.0);
      doubts = std::max(doubts, off / (b.spindleSd / b.spindle + 1e-3));
      if (t > shown && t < kRampStart + kRampSeconds) most = std::max(most, off);
    };
    const RunResult r = run(rampedCut(false, 1), o);
    EXPECT_LT(doubts, 3.0) << age;
    EXPECT_LT(most, 0.01) << age;
    EXPECT_LT(r.firstAlarm, 0.0) << age;
    EXPECT_NEAR(r.verdicts.back().spindle.value, kTo, 1e-3 * kTo) << age;
  }
}

TEST(SpeedRamp, ThatStopsTheChatterEndsTheAlarm) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const RunResult r = run(rampedCut(true, seed), withMachine(0.003));
    EXPECT_GT(r.firstAlarm, 1.5);
    EXPECT_LT(r.firstAlarm, 1.6);
    // Chatter of the forced size falls below a fifth within 20 ms * ln 5.
    const double over = kRampStart + 0.5 * kRampSeconds + 0.032;
    EXPECT_EQ(r.at(over - 0.1).state, CutState::Chatter);
    EXPECT_LT(r.firstAlarmAfter(over + 0.25), 0.0) << "seed " << seed;
    // A strategy aims at this frequency: it must not wander with the speed.
    for (int i = 0; i < 25; ++i) {
      const double t = 1.65 + 0.02 * i;
      EXPECT_NEAR(r.at(t).frequency.value, kChatterHertz, 0.005 * kChatterHertz) << t;
    }
  }
}

// From the first moment to the last the speed changes by 5 % a second: by the machine's word and a comb that is found
// on the way, 0.4 % beside it, the cut is judged as if it stood.
TEST(SpeedRamp, ThatNeverStandsStillHasItsSpeedFound) {
  const auto speed = [](double t) { return 130.0 * (1.0 + 0.05 * t); };
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  Recording r;
  r.rate = 25600.0;
  r.channels.assign(1, {});
  double angle = 0.0;
  for (int k = 0; k < static_cast<int>(3.0 * r.rate); ++k) {
    const double t = k / r.rate;
    angle += kTwoPi * speed(t) / r.rate;
    double x = 0.02 * normal(engine);
    for (int h = 1; t > 0.3 && h <= 24; ++h) x += (h % 4 == 0 ? 4.0 / h : 0.05) * std::cos(h * angle + 0.7 * h * h);
    if (t > 2.0) x += std::min(1.0, 0.02 * std::exp((t - 2.0) / 0.03)) * std::sin(kTwoPi * kChatterHertz * t);
    r.channels[0].push_back(static_cast<float>(x));
  }
  RunOptions o;
  o.teeth = 4;
  o.rpm = 60.0 * 130.0;
  o.machine = [&](double t) {
    MachineState m;
    m.valid = m.linkUp = true;
    m.actualSpeed = Rpm(60.0 * speed(t) * 0.996);
    return m;
  };
  const RunResult result = run(r, o);
  EXPECT_NEAR(result.at(1.9).spindle.value, speed(1.9), 1.5e-3 * speed(1.9));
  EXPECT_GT(result.firstAlarm, 2.0);
  EXPECT_LT(result.firstAlarm, 2.0 + 0.03 * std::log(1.0 / 0.02));
}

}  // namespace
}  // namespace stillcut::detect::testing
