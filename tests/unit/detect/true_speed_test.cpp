// The true speed: found without being told, followed when it changes without a word from the machine, given up where
// the signal does not allow it; and chatter that fills the cut before any speed can be found.
#include <random>

#include "tests/unit/detect/signals.h"

namespace stillcut::detect::testing {
namespace {

// Air, then a cut: tooth passings that fall off, a little runout, noise; the speed may ramp and a line may be there
// from the entry on.
struct Entry {
  double rate = 8192.0;
  double seconds = 4.0;
  double cutFrom = 0.6;
  double spindle = 60.0;
  int teeth = 4;
  double forced = 1.0;
  double rampFrom = 0.0, rampTo = 0.0, rampBy = 0.0;  // relative change of the speed
  double lineHertz = 0.0, lineAmplitude = 0.0;
  double cutTo = 1e9, fadeSeconds = 0.1;  // the forced part leaves, what else there is stays
  double noise = 0.02;
  unsigned seed = 5;
};

Recording make(const Entry& e) {
  std::mt19937 engine(e.seed);
  std::normal_distribution<double> normal;
  Recording r;
  r.rate = e.rate;
  const auto n = static_cast<std::size_t>(e.seconds * e.rate);
  r.channels.assign(1, std::vector<float>(n));
  double angle = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double t = static_cast<double>(k) / e.rate;
    const double part = e.rampTo > e.rampFrom ? std::clamp((t - e.rampFrom) / (e.rampTo - e.rampFrom), 0.0, 1.0) : 0.0;
    angle += kTwoPi * e.spindle * (1.0 + e.rampBy * part) / e.rate;
    double x = e.noise * normal(engine);
    if (t > e.cutFrom) {
      const double in =
          std::min(1.0, (t - e.cutFrom) / 0.05) * std::clamp(1.0 - (t - e.cutTo) / e.fadeSeconds, 0.0, 1.0);
      for (int h = 1; h <= 5; ++h) x += in * e.forced / h * std::cos(h * e.teeth * angle + h);
      for (int h = 1; h <= 3; ++h) x += in * 0.05 * e.forced * std::cos(h * angle + 2.0 * h);
      x += in * e.lineAmplitude * std::sin(kTwoPi * e.lineHertz * t);
    } else {
      x *= 0.3;
    }
    r.channels[0][k] = static_cast<float>(x);
  }
  return r;
}

RunOptions told(const Entry& e, double rpm) {
  RunOptions o;
  o.teeth = e.teeth;
  o.rpm = rpm;
  o.blockFrames = 40;
  return o;
}

TEST(TrueSpeed, IsFoundWithoutBeingTold) {
  for (const double spindle : {24.0, 60.0, 133.0}) {
    Entry e;
    e.spindle = spindle;
    const RunResult r = run(make(e), told(e, 0.0));
    EXPECT_LT(r.firstAlarm, 0.0) << spindle;
    const Verdict& last = r.verdicts.back();
    EXPECT_TRUE(last.valid) << spindle;
    EXPECT_EQ(last.state, CutState::Stable);
    EXPECT_NEAR(last.spindle.value, spindle, 1e-3 * spindle);
  }
}

TEST(TrueSpeed, IsNotClaimedWhereNothingTurns) {
  Entry e;
  e.forced = 0.0;
  e.noise = 0.0;
  Recording r = make(e);
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  double x = 0.0;  // rubbing, through a structure: white noise would be no sensor in a cut
  for (std::size_t k = 0; k < r.frames(); ++k) {
    x = 0.8 * x + normal(engine);
    r.channels[0][k] = static_cast<float>((k < r.frames() / 6 ? 0.01 : 1.0) * x);
  }
  for (const char* detector : {"energy-ratio", "parametric", "spectral"}) {
    const RunResult found = run(r, told(e, 0.0), detector);
    EXPECT_LT(found.firstAlarm, 0.0) << detector;
    EXPECT_FALSE(found.verdicts.back().valid) << detector;
    EXPECT_EQ(found.verdicts.back().reason.code, ReasonCode::NoSpeed) << detector;
  }
}

// An operator turns the override down in the cut, and no machine says so.
TEST(TrueSpeed, IsFollowedThroughAChangeThatNobodyTells) {
  for (const double by : {-0.13, 0.08}) {
    for (const double seconds : {0.6, 1.5}) {
      Entry e;
      e.spindle = 110.0;
      e.teeth = 3;
      e.rampFrom = 2.0;
      e.rampTo = 2.0 + seconds;
      e.rampBy = by;
      const RunResult r = run(make(e), told(e, 60.0 * e.spindle * 1.02));
      EXPECT_LT(r.firstAlarm, 0.0) << by << " in " << seconds;
      EXPECT_NEAR(r.verdicts.back().spindle.value, e.spindle * (1.0 + by), 2e-3 * e.spindle) << by << " in " << seconds;
      EXPECT_NEAR(r.at(1.9).spindle.value, e.spindle, 1e-3 * e.spindle);
    }
  }
}

// A face mill that chatters from the first bite: nothing was learned, and the told speed allows two orders to the line.
TEST(ChatterFromTheEntry, AlarmsWithinThreeTenthsOfASecond) {
  for (const double error : {-0.02, 0.0, 0.02}) {
    Entry e;
    e.rate = 24000.0;
    e.spindle = 27.6;
    e.teeth = 6;
    e.cutFrom = 1.0;
    e.seconds = 4.0;
    e.forced = 0.1;
    e.lineHertz = 32.6 * e.spindle;
    e.lineAmplitude = 1.0;
    const RunResult r = run(make(e), told(e, 60.0 * e.spindle * (1.0 + error)));
    // Twelve turns are looked at, and looked at again.
    EXPECT_GT(r.firstAlarm, e.cutFrom) << error;
    EXPECT_LT(r.firstAlarm, e.cutFrom + 0.6) << error;
    EXPECT_GT(r.alarmTimeIn(e.cutFrom + 0.6, e.seconds), 0.9 * (e.seconds - e.cutFrom - 0.6)) << error;
    EXPECT_NEAR(r.at(3.0).frequency.value, e.lineHertz, 5e-3 * e.lineHertz) << error;
  }
}

// Within the doubt of the told speed the line may be a whole order, and twice its frequency always is one then.
TEST(ChatterFromTheEntry, NearAWholeOrderIsSeen) {
  for (const double order : {4.9, 5.11}) {
    Entry e;
    e.rate = 25600.0;
    e.spindle = 180.0;
    e.teeth = 2;
    e.cutFrom = 0.5;
    e.seconds = 1.5;
    e.forced = 0.1;
    e.lineHertz = order * e.spindle;
    e.lineAmplitude = 1.0;
    const RunResult r = run(make(e), told(e, 60.0 * e.spindle));
    EXPECT_GT(r.firstAlarm, e.cutFrom) << order;
    EXPECT_LT(r.firstAlarm, e.cutFrom + 0.3) << order;
    EXPECT_NEAR(r.at(1.2).frequency.value, e.lineHertz, 5e-3 * e.lineHertz) << order;
  }
}

// The same line on a tooth passing is a forced resonance.
TEST(ChatterFromTheEntry, ForcedResonanceIsNone) {
  for (const double error : {-0.02, 0.0, 0.02}) {
    Entry e;
    e.rate = 24000.0;
    e.spindle = 27.6;
    e.teeth = 6;
    e.forced = 0.3;
    e.noise = 0.003;
    Recording r = make(e);
    double angle = 0.0;
    for (std::size_t k = 0; k < r.frames(); ++k) {
      angle += kTwoPi * e.spindle / e.rate;
      if (static_cast<double>(k) > e.cutFrom * e.rate) r.channels[0][k] += static_cast<float>(std::sin(30.0 * angle));
    }
    EXPECT_LT(run(r, told(e, 60.0 * e.spindle * (1.0 + error))).firstAlarm, 0.0) << error;
  }
}

// The tool leaves, slowly and fast; what does not repeat stays, and its part of the vibration rises.
TEST(Exit, DoesNotAlarm) {
  for (const double fade : {0.05, 0.4, 1.0}) {
    Entry e;
    e.cutTo = 3.0;
    e.fadeSeconds = fade;
    e.seconds = 3.0 + fade;
    e.noise = 0.05;
    const RunResult r = run(make(e), told(e, 60.0 * e.spindle));
    EXPECT_LT(r.firstAlarm, 0.0) << fade;
    EXPECT_EQ(r.at(2.9).state, CutState::Stable);
    EXPECT_EQ(r.at(2.9).phase, CutPhase::Steady);
  }
}

}  // namespace
}  // namespace stillcut::detect::testing
