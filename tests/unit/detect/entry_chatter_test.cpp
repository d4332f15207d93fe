// Chatter that is there from the entry, and too small for the fixed ratio: by its side lines.
#include "core/detect/caliskan/entry_chatter.h"

#include <cmath>
#include <random>

#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kRate = 12800.0;
constexpr double kSpindle = 105.0;
constexpr int kTeeth = 3;
constexpr double kCut = 0.5;  // s, from there on
constexpr double kSeconds = 2.0;

struct Chatter {
  double order = 0.0, amplitude = 0.0;
  double beside = 0.0;  // of its side lines, over its own
};

// Air, then a cut with five tooth passings and runout, and chatter that never was smaller.
Recording make(std::initializer_list<Chatter> all) {
  std::mt19937 engine(11);
  std::normal_distribution<double> normal;
  Recording r;
  r.rate = kRate;
  r.channels.assign(1, std::vector<float>(static_cast<std::size_t>(kSeconds * kRate)));
  for (std::size_t i = 0; i < r.frames(); ++i) {
    const double t = static_cast<double>(i) / kRate;
    const double turn = kTwoPi * kSpindle * t;
    const double in = std::clamp((t - kCut) / 0.03, 0.0, 1.0);
    double x = steadyCutAt(turn, kTeeth);
    for (const Chatter& c : all) {
      for (int k = -2; k <= 2; ++k) {
        x += c.amplitude * (k == 0 ? 1.0 : c.beside / std::abs(k)) * std::sin((c.order + k * kTeeth) * turn + k);
      }
    }
    r.channels[0][i] = static_cast<float>(in * x + 0.01 * normal(engine));
  }
  return r;
}

RunResult runAt(const Recording& r, double error) {
  RunOptions o;
  o.teeth = kTeeth;
  o.rpm = 60.0 * kSpindle * (1.0 + error);
  return run(r, o);
}

// Half the amplitude of all else, and as an energy of displacements a third of what the paper calls chatter.
TEST(EntryChatter, IsAlarmedByItsSideLines) {
  for (const double order : {7.4, 8.72}) {
    for (const double error : {-0.02, 0.0, 0.02}) {
      const RunResult r = runAt(make({{order, 0.7, 0.15}}), error);
      EXPECT_GT(r.firstAlarm, kCut) << order << ' ' << error;
      EXPECT_LT(r.firstAlarm, kCut + 0.45) << order << ' ' << error;
      EXPECT_GT(r.alarmTimeIn(1.0, kSeconds), 0.98) << order << ' ' << error;
      EXPECT_NEAR(r.at(1.5).frequency.value, order * kSpindle, 0.5) << order << ' ' << error;
      EXPECT_EQ(r.at(1.5).state, CutState::Onset) << "the ratio is below that of full chatter";
    }
  }
}

// The same line without them may be anything's, as a pump's.
TEST(EntryChatter, ALineWithNothingBesideItIsNone) {
  for (const double error : {-0.02, 0.0, 0.02}) EXPECT_LT(runAt(make({{7.4, 0.7, 0.0}}), error).firstAlarm, 0.0);
}

// Two modes that chatter at once: what is heard beats, and now the one is the stronger, now the other.
TEST(EntryChatter, OfTwoLinesIsAlarmedToo) {
  const RunResult r = runAt(make({{7.4, 0.3, 0.2}, {7.62, 0.3, 0.2}}), 0.0);
  EXPECT_GT(r.firstAlarm, kCut);
  EXPECT_LT(r.firstAlarm, kCut + 0.45);
}

// A spindle at 24 000 rev/min makes eight turns in 20 ms: a cut that was calm for so long may just have begun. From a
// tenth of a second on growth decides.
TEST(EntryChatter, ACutIsCalmAfterAsLongAsItsChatterHasToLast) {
  constexpr double kFast = 400.0;
  constexpr double kFastRate = 51200.0;
  LineFinder lines;
  lines.prepare(1, static_cast<int>(kLineTurns * kFastRate / kFast), Hertz(kFastRate));
  std::vector<double> rest(static_cast<std::size_t>(kFastRate));
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const double turn = kTwoPi * kFast * static_cast<double>(i) / kFastRate;
    for (const int k : {-1, 0, 1}) rest[i] += (k == 0 ? 1.0 : 0.2) * std::sin((7.4 + k * kTeeth) * turn + k);
  }
  lines.push(rest.data(), 0, rest.size());
  RatioHop hop;
  hop.phase = CutPhase::Steady;
  hop.spindle = Hertz(kFast);
  hop.length = Seconds(1.0 / (kHopsPerTurn * kFast));
  hop.rate = Hertz(kFastRate);
  hop.teeth = kTeeth;
  hop.highest = Hertz(40.5 * kFast);
  hop.steadyTurns = 100.0;
  const auto beginsAfter = [&](double calmSeconds, double steadyTurns, std::span<const RatioChannel> channels = {}) {
    EntryChatter chatter;
    chatter.prepare(0.2);
    RatioHop calm = hop;
    calm.steadyTurns = steadyTurns;
    const auto hops = [&](double seconds) { return static_cast<int>(std::ceil(seconds / hop.length.value)); };
    for (int i = 0; i < hops(calmSeconds); ++i) chatter.learnCalm(channels, 0.01, calm);
    bool begins = false;
    for (int i = 0; i < hops(0.2); ++i) begins |= chatter.begins({}, {0.05, 0.05}, lines, hop);
    return begins;
  };
  EXPECT_TRUE(beginsAfter(0.0, 100.0));
  EXPECT_TRUE(beginsAfter(0.05, 100.0));
  EXPECT_FALSE(beginsAfter(0.15, 100.0));
  EXPECT_TRUE(beginsAfter(0.15, 1.0)) << "the filters had not settled";
  const std::vector<RatioChannel> unlearned(1);
  EXPECT_TRUE(beginsAfter(0.15, 100.0, unlearned)) << "no growth can be told yet";
}

}  // namespace
}  // namespace stillcut::detect::testing
