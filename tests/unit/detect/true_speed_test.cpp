// The true speed: found without being told, followed when it changes without a word from the machine, given up where
// the signal does not allow it; and chatter that fills the cut before any speed can be found.
#include <random>

#include "tests/support/signals.h"

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
  int loudest = 1;                                    // of the tooth passings
  double rampFrom = 0.0, rampTo = 0.0, rampBy = 0.0;  // relative change of the speed
  double lineHertz = 0.0, lineAmplitude = 0.0;
  double cutTo = 1e9, fadeSeconds = 0.1;         // the forced part leaves, what else there is stays
  bool lineStays = false;                        // when the tool leaves
  double dipFrom = 1e9, dipTo = 0.0, dip = 1.0;  // a time in which the forced part is so much less
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
      const double load = in * e.forced * (t > e.dipFrom && t < e.dipTo ? e.dip : 1.0);
      for (int h = 1; h <= 5; ++h) x += load / (1 + std::abs(h - e.loudest)) * std::cos(h * e.teeth * angle + h);
      for (int h = 1; h <= 3; ++h) x += 0.05 * load * std::cos(h * angle + 2.0 * h);
      x += (e.lineStays ? 1.0 : in) * e.lineAmplitude * std::sin(kTwoPi * e.lineHertz * t);
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

// A chatter line alone makes a comb of anything; what is heard of it must not pass for a stable cut at another speed.
TEST(TrueSpeed, IsNotMadeOfOneLine) {
  Entry e;
  e.rate = 24000.0;
  e.spindle = 27.6;
  e.teeth = 6;
  e.forced = 0.1;
  e.lineHertz = 32.6 * e.spindle;
  e.lineAmplitude = 1.0;
  e.seconds = 6.0;
  RunOptions o = told(e, 0.0);
  double wrong = 0.0;
  o.onBlock = [&](const ConditionedBlock& b, const Verdict& v) {
    const bool calm = b.phase == CutPhase::Steady && v.valid && !v.alarming();
    if (calm && std::abs(v.spindle.value / e.spindle - 1.0) > 0.01) wrong += b.frames / e.rate;
  };
  run(make(e), o);
  EXPECT_LT(wrong, 0.1);
}

// The tool comes back to the material: until a comb is found again, what was told is the speed.
TEST(TrueSpeed, IsWhatWasToldUntilTheNextCutIsHeard) {
  Entry e;
  e.seconds = 3.0;
  Recording twice = make(e);
  const Recording once = twice;
  for (std::size_t c = 0; c < once.channels.size(); ++c) {
    twice.channels[c].insert(twice.channels[c].end(), once.channels[c].begin(), once.channels[c].end());
  }
  RunOptions o = told(e, 60.0 * e.spindle * 1.01);
  int heard = 0;
  o.onBlock = [&](const ConditionedBlock& b, const Verdict& v) {
    if (b.phase == CutPhase::AirCutting) return;
    ++heard;
    EXPECT_TRUE(v.valid) << sinceEpoch(v.time).value;
    EXPECT_NEAR(b.spindle / Hertz(e.spindle), 1.0, 0.02) << sinceEpoch(v.time).value;
  };
  run(twice, o);
  EXPECT_GT(heard, 0);
}

// The load changes while chatter fills the cut, and a comb that the chatter lies on (order 7 of 133.8 Hz) is within
// what was told: the forced vibration that is left says where the spindle is.
TEST(TrueSpeed, IsHeldThroughFullChatter) {
  CutSignal s;
  s.spindle = 137.3;
  s.chatterHertz = 936.6;
  s.growthStart = 2.0;
  s.growthConstant = 0.02;
  s.newLoad = 2.3;
  s.seconds = 4.0;
  RunOptions o;
  o.teeth = s.teeth;
  o.rpm = 60.0 * s.spindle;
  double most = 0.0;
  o.onBlock = [&](const ConditionedBlock& b, const Verdict& v) {
    if (sinceEpoch(v.time).value > 1.0) most = std::max(most, std::abs(b.spindle.value / s.spindle - 1.0));
  };
  const RunResult r = run(makeCut(s), o);
  EXPECT_LT(most, 0.01);
  EXPECT_GT(r.alarmTimeIn(2.2, 4.0), 0.95 * 1.8);
}

// At full immersion tooth passings nearly cancel, and runout on a mode is all there is. What chatter beside that order
// leaks into the tooth passings must not carry the spindle off until the chatter lies on an order. Near it (0.045
// orders) no share grows and no line stands between the orders: the order is louder and turns.
TEST(TrueSpeed, IsNotCarriedOffByChatterBesideWeakToothPassings) {
  constexpr double kSpindle = 13.33;
  for (const double offset : {0.11, 0.045}) {
    std::mt19937 engine(4);
    std::normal_distribution<double> normal;
    Recording r;
    r.rate = 4096.0;
    r.channels.assign(1, {});
    for (int k = 0; k < 16 * 4096; ++k) {
      const double t = k / r.rate;
      const double angle = kTwoPi * kSpindle * t;
      double x = (t < 1.0 ? 0.1 : 0.3) * normal(engine);
      if (t > 1.0) {
        for (int h = 4; h <= 32; h += 4) x += 0.1 * std::cos(h * angle + h);
        x += std::cos(15.0 * angle);
      }
      const double growing = 0.05 * std::exp((t - 7.0) / 0.4);
      if (t > 7.0) x += std::min(30.0, growing) * std::sin((15.0 + offset) * angle);
      r.channels[0].push_back(static_cast<float>(x));
    }
    RunOptions o;
    o.teeth = 4;
    o.rpm = 60.0 * kSpindle;
    const RunResult result = run(r, o);
    EXPECT_NEAR(result.verdicts.back().spindle.value, kSpindle, 1e-3 * kSpindle) << offset;
    EXPECT_GT(result.alarmTimeIn(12.0, 16.0), 3.9) << offset;
    EXPECT_NEAR(result.verdicts.back().frequency.value, (15.0 + offset) * kSpindle, 5e-3 * 15.0 * kSpindle) << offset;
    EXPECT_LT(result.alarmTimeIn(0.0, 7.0), 0.01) << offset;
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

// The speed drifts from before the first bite on, away from what was told: when the cut begins it is 4.5 % beside it.
TEST(TrueSpeed, IsFoundWhereItHasRunAwayAndFollowed) {
  for (const double by : {-0.1, 0.1}) {
    for (const int loudest : {1, 2}) {
      Entry e;
      e.spindle = 105.0;
      e.teeth = 3;
      e.loudest = loudest;
      e.seconds = 2.0;
      e.rampTo = e.seconds;
      e.rampBy = by;
      e.cutFrom = 0.3;
      const RunResult r = run(make(e), told(e, 60.0 * e.spindle * (by > 0.0 ? 0.97 : 1.03)));
      EXPECT_LT(r.firstAlarm, 0.0) << by << ' ' << loudest;
      for (int i = 4; i < 10; ++i) {
        const double t = 0.2 * i;
        const double truth = e.spindle * (1.0 + by * t / e.seconds);
        EXPECT_NEAR(r.at(t).spindle.value, truth, 2e-3 * truth) << by << ' ' << loudest << ' ' << t;
      }
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

// A line of the machine that was there all along, and is all that is left.
TEST(Exit, ALineThatStaysDoesNotAlarm) {
  for (const double fade : {0.05, 0.4, 1.0}) {
    Entry e;
    e.lineHertz = 13.6 * e.spindle;
    e.lineAmplitude = 0.12;
    e.lineStays = true;
    e.cutTo = 3.0;
    e.fadeSeconds = fade;
    e.seconds = 3.0 + fade;
    const RunResult r = run(make(e), told(e, 60.0 * e.spindle));
    EXPECT_LT(r.firstAlarm, 0.0) << fade;
    EXPECT_EQ(r.at(2.9).state, CutState::Stable);
  }
}

// The alarm of a chattering cut ends with it, although noise that is louder than air stays.
TEST(Exit, EndsAnAlarm) {
  Entry e;
  e.spindle = 80.0;
  e.cutTo = 3.0;
  e.seconds = 4.0;
  e.forced = 0.3;
  e.lineHertz = 13.6 * e.spindle;
  e.lineAmplitude = 1.0;
  const RunResult r = run(make(e), told(e, 60.0 * e.spindle));
  EXPECT_GT(r.alarmTimeIn(2.0, 3.0), 0.99);
  EXPECT_LT(r.firstAlarmAfter(e.cutTo + e.fadeSeconds + 0.25), 0.0);
}

// Times and states are the cut's, not those of the blocks it comes in.
TEST(Blocks, OfAnyLengthGiveTheSameVerdicts) {
  Entry e;
  e.rate = 24000.0;
  e.spindle = 27.6;
  e.teeth = 6;
  e.cutFrom = 1.0;
  e.seconds = 3.0;
  e.forced = 0.1;
  e.lineHertz = 32.6 * e.spindle;
  e.lineAmplitude = 1.0;
  const Recording cut = make(e);
  RunOptions o = told(e, 60.0 * e.spindle);
  o.blockFrames = 24;
  const RunResult fine = run(cut, o);
  ASSERT_GT(fine.firstAlarm, e.cutFrom);
  for (const int frames : {60, 120, 480}) {
    o.blockFrames = frames;
    const RunResult r = run(cut, o);
    const double block = frames / e.rate;
    EXPECT_NEAR(r.firstAlarm, fine.firstAlarm, block + 0.002) << frames;
    EXPECT_NEAR(r.verdicts.back().spindle.value, fine.verdicts.back().spindle.value, 1e-4 * e.spindle) << frames;
    EXPECT_NEAR(r.verdicts.back().frequency.value, fine.verdicts.back().frequency.value, 0.5) << frames;
  }
}

}  // namespace
}  // namespace stillcut::detect::testing
