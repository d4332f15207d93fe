// An order that folds back is found by where it goes when the speed changes; lines that are there are not.
#include "core/sensing/alias_watch.h"

#include <gtest/gtest.h>

#include <random>

#include "core/detect/registry.h"
#include "core/sensing/conditioner.h"
#include "tests/support/path_counter.h"
#include "tests/support/recording_runner.h"

namespace stillcut::detect::testing {
namespace {

constexpr double kRate = 4000.0;
constexpr double kSpindle = 60.0;
constexpr double kAir = 1.0;  // s
constexpr double kStep = 1.5;

// The speed stands for a while, then leaps by a percent or so: an override that somebody turns.
double spindleAt(double t) {
  constexpr double kSpeeds[] = {1.0, 1.012, 1.03, 1.01, 0.985, 1.0};
  return kSpindle * kSpeeds[std::min<std::size_t>(5, static_cast<std::size_t>(std::max(0.0, t - kAir) / kStep))];
}

// A cut of 12 harmonics, with a line beside them: amplitude cos of what `phase` makes of spindle angle and time.
Recording cut(const std::function<double(double angle, double t)>& phase, double amplitude) {
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0.0, 0.02);
  Recording r;
  r.rate = kRate;
  r.channels.resize(1);
  double angle = 0.0;
  for (int k = 0; k < static_cast<int>((kAir + 6 * kStep) * kRate); ++k) {
    const double t = k / kRate;
    angle += kTwoPi * spindleAt(t) / kRate;
    double x = 0.0;
    if (t > kAir) {
      for (int n = 1; n <= 12; ++n) x += (n % 4 == 0 ? 1.0 : 0.1) * std::cos(n * angle + n * n);
      x += amplitude * std::cos(phase(angle, t));
    }
    r.channels[0].push_back(static_cast<float>(x + noise(engine)));
  }
  return r;
}

struct Heard {
  double first = -1.0;  // s, first verdict that says so
  Reason reason;
  int validAfter = 0;
};

Heard hear(const Recording& recording) {
  RunOptions options;
  options.teeth = 4;
  options.rpm = 60.0 * kSpindle;
  options.blockFrames = 40;
  options.machine = [](double t) {
    MachineState m;
    m.valid = m.linkUp = true;
    m.actualSpeed = toRpm(Hertz(spindleAt(t)));
    return m;
  };
  Heard heard;
  for (const Verdict& v : run(recording, options).verdicts) {
    if (v.reason.code == ReasonCode::InputAliased && !v.valid) {
      if (heard.first < 0.0) heard.first = sinceEpoch(v.time).value;
      heard.reason = v.reason;
    } else if (heard.first >= 0.0 && v.valid) {
      ++heard.validAfter;
    }
  }
  return heard;
}

// Order 40 lies at 2400 Hz, above half the rate, and order 70 at 4200 Hz: folded to 1600 and to 200 Hz.
TEST(AliasWatch, AnOrderThatFoldsIsFoundOnceTheSpeedHasMoved) {
  for (const int order : {40, 70}) {
    const Heard heard = hear(cut([order](double angle, double) { return order * angle; }, 0.5));
    EXPECT_GT(heard.first, kAir + 3 * kStep) << order;  // after three moves
    EXPECT_LT(heard.first, kAir + 6 * kStep) << order;
    EXPECT_EQ(heard.reason.n[2], order);
    const double folded = std::abs(kRate * std::round(order * kSpindle / kRate) - order * kSpindle);
    EXPECT_NEAR(heard.reason.n[1], folded, 0.02 * order * kSpindle) << order;  // as far as the speed has moved
    EXPECT_EQ(heard.validAfter, 0) << order;
    EXPECT_NE(sentence(heard.reason).find("anti-alias"), std::string::npos);
  }
}

// Chatter stands, or its side lines go with the teeth; a belt goes with the spindle at no whole order.
TEST(AliasWatch, LinesThatAreThereAreNone) {
  EXPECT_EQ(hear(cut([](double, double t) { return kTwoPi * 1600.0 * t; }, 0.5)).first, -1.0);
  EXPECT_EQ(hear(cut([](double angle, double t) { return 8.0 * angle - kTwoPi * 200.0 * t; }, 0.5)).first, -1.0);
  EXPECT_EQ(hear(cut([](double angle, double) { return 9.37 * angle; }, 0.5)).first, -1.0);
  EXPECT_EQ(hear(cut([](double, double) { return 0.0; }, 0.0)).first, -1.0);
}

}  // namespace
}  // namespace stillcut::detect::testing
