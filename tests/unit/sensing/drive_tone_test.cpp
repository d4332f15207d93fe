// The tone of an axis drive glides and is then taken out where it stands; what a cut makes does neither.
#include "core/sensing/drive_tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace stillcut::detect {
namespace {

constexpr double kRate = 25600.0;
constexpr int kBlock = 128;
constexpr double kSpindle = 100.0;  // Hz, three teeth

// Harmonics of the spindle, 1 m/s^2 at the tooth passing, and noise.
class Cut {
 public:
  // wander(t): revolutions since the beginning.
  explicit Cut(std::function<double(double)> revolutions = [](double t) { return kSpindle * t; })
      : revolutions_(std::move(revolutions)) {}
  double at(double t) {
    double x = 0.02 * normal_(random_);
    for (int k = 1; k < 20; ++k) {
      x += (k % 3 == 0 ? 1.5 / (1.0 + 0.15 * k) : 0.1) * std::cos(kTwoPi * k * revolutions_(t) + k);
    }
    return x;
  }

 private:
  std::function<double(double)> revolutions_;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
};

// A drive: up to `highest` within `accelerates`, from 1 s on; down again from 3 s on.
class Drive {
 public:
  explicit Drive(double amplitude, double highest = 812.0, double accelerates = 0.3)
      : amplitude_(amplitude), highest_(highest), accelerates_(accelerates) {}
  double frequency(double t) const {
    return highest_ * std::clamp(std::min((t - 1.0) / accelerates_, (3.0 + accelerates_ - t) / accelerates_), 0.0, 1.0);
  }
  double at(double t) {
    phase_ += kTwoPi * frequency(t) / kRate;
    return frequency(t) > 20.0 ? amplitude_ * std::cos(phase_) : 0.0;
  }

 private:
  double amplitude_, highest_, accelerates_;
  double phase_ = 0.0;
};

struct Bench {
  Bench() { tone.prepare(Hertz(kRate)); }
  // each(t) after every block.
  void run(double seconds, const std::function<double(double)>& signal, const std::function<void(double)>& each) {
    for (long b = 0; b < static_cast<long>(seconds * kRate / kBlock); ++b) {
      before.assign(kBlock, 0.0);
      for (int i = 0; i < kBlock; ++i) {
        before[static_cast<std::size_t>(i)] = signal(static_cast<double>(b * kBlock + i) / kRate);
      }
      after = before;
      tone.process(after);
      each(static_cast<double>((b + 1) * kBlock) / kRate);
    }
  }
  DriveTone tone;
  std::vector<double> before, after;
};

TEST(DriveTone, AGlideIsRecognisedBeforeAnAlarmMayBegin) {
  for (const double amplitude : {0.5, 1.0}) {
    Bench bench;
    Cut cut;
    Drive drive(amplitude);
    double recognised = 0.0;
    bench.run(
        1.5, [&](double t) { return cut.at(t) + drive.at(t); },
        [&](double t) {
          if (recognised == 0.0 && bench.tone.unsettled()) recognised = t;
        });
    EXPECT_GT(recognised, 1.0);
    EXPECT_LT(recognised, 1.0 + MovingTone::kRecognised.value) << amplitude;
  }
}

TEST(DriveTone, WhereItStandsItIsTakenOutAndTheCutIsNot) {
  Bench bench;
  Cut cut, alone;
  Drive drive(1.0);
  double in = 0.0, out = 0.0, cutAlone = 0.0;
  bench.run(
      3.0, [&](double t) { return cut.at(t) + drive.at(t); },
      [&](double t) {
        for (int i = 0; i < kBlock; ++i) {
          const double only = alone.at(t - static_cast<double>(kBlock - i) / kRate);
          if (t < 2.0) continue;
          const auto at = static_cast<std::size_t>(i);
          in += std::pow(bench.before[at] - only, 2.0);
          out += std::pow(bench.after[at] - only, 2.0);
          cutAlone += only * only;
        }
      });
  EXPECT_NEAR(bench.tone.frequency().value, 812.0, 2.0);
  EXPECT_FALSE(bench.tone.unsettled());
  EXPECT_LT(out, 0.03 * in);        // 15 dB less of it
  EXPECT_LT(out, 0.03 * cutAlone);  // and the cut is what it was
}

TEST(DriveTone, ItIsGoneWhenTheDriveStops) {
  Bench bench;
  Cut cut;
  Drive drive(0.5);
  double changed = 0.0;
  bench.run(
      5.0, [&](double t) { return cut.at(t) + drive.at(t); },
      [&](double t) {
        if (t < 4.0) return;
        for (std::size_t i = 0; i < kBlock; ++i) changed += std::abs(bench.after[i] - bench.before[i]);
      });
  EXPECT_EQ(changed, 0.0);
  EXPECT_FALSE(bench.tone.unsettled());
  EXPECT_TRUE(bench.tone.expected());  // the next feed move
}

// By 10 % of its speed in a second, as an override does.
TEST(DriveTone, HarmonicsOfASpindleThatChangesItsSpeedDoNotGlide) {
  Bench bench;
  Cut cut([](double t) { return kSpindle * (t - 0.05 * t * t); });
  bench.run(
      2.0, [&](double t) { return cut.at(t); }, [&](double t) { EXPECT_FALSE(bench.tone.unsettled()) << t; });
}

TEST(DriveTone, ChatterThatGrowsDoesNotGlide) {
  for (const double hertz : {340.0, 812.0, 1733.0}) {
    Bench bench;
    Cut cut;
    bench.run(
        2.0,
        [&](double t) {
          return cut.at(t) + 2.0 * std::min(1.0, std::exp((t - 1.2) / 0.02)) * std::cos(kTwoPi * hertz * t);
        },
        [&](double t) { EXPECT_FALSE(bench.tone.unsettled()) << hertz << " Hz, " << t << " s"; });
    EXPECT_EQ(bench.before, bench.after);
  }
}

// What grows where the drive stands to be much louder than it was is the cut's.
TEST(DriveTone, ChatterOnTheDrivesFrequencyIsLeftAlone) {
  Bench bench;
  Cut cut;
  Drive drive(0.2);
  double in = 0.0, out = 0.0;
  const auto chatter = [](double t) {
    return 2.0 * std::min(1.0, std::exp((t - 2.2) / 0.02)) * std::cos(kTwoPi * 815.0 * t);
  };
  bench.run(
      3.0, [&](double t) { return cut.at(t) + drive.at(t) + chatter(t); },
      [&](double t) {
        if (t < 2.5) return;
        for (std::size_t i = 0; i < kBlock; ++i) {
          in += bench.before[i] * bench.before[i];
          out += bench.after[i] * bench.after[i];
        }
      });
  EXPECT_NEAR(out / in, 1.0, 0.01);
}

}  // namespace
}  // namespace stillcut::detect
