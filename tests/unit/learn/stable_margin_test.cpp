// The decay of the free vibration in a stable cut, and how far it says the limit is.
#include "core/learn/stable_margin.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/milling/regenerative_cut.h"
#include "tests/support/hidden_machines/hidden_machine.h"

namespace stillcut::learn {
namespace {

constexpr double kRate = 25600.0;

// A mode struck by noise, over the harmonics of a spindle.
std::vector<double> struckMode(double frequency, double decay, double seconds, double noise) {
  Random random(11);
  const double step = 1.0 / kRate;
  const double shrink = std::exp(-decay * step);
  const double turn = kTwoPi * frequency * step;
  std::vector<double> x;
  double last = 0.0;
  double before = 0.0;
  for (int i = 0; i < static_cast<int>(seconds * kRate); ++i) {
    const double now = 2.0 * shrink * std::cos(turn) * last - shrink * shrink * before + random.normal();
    before = last;
    last = now;
    double turning = 0.0;
    for (int k = 1; k <= 12; ++k) turning += 40.0 / k * std::sin(kTwoPi * k * 150.0 * i * step + k);
    x.push_back(now + turning + noise * random.normal());
  }
  return x;
}

TEST(FreeDecay, FindsFrequencyAndDecayUnderTheSpindlesHarmonics) {
  for (const double decay : {40.0, 120.0}) {
    const auto answer = freeDecay(struckMode(1012.0, decay, 4.0, 1.0), Hertz(kRate), Rpm(9000.0));
    ASSERT_TRUE(answer.decay) << text(answer.why);
    EXPECT_NEAR(answer.decay->frequency.value, 1012.0, 8.0);
    EXPECT_NEAR(answer.decay->rate, decay, std::max(3.0 * answer.decay->rateSd, 0.15 * decay));
    EXPECT_LT(answer.decay->rateSd, 0.3 * decay);
  }
}

TEST(FreeDecay, SaysNothingWhereItCannotTell) {
  std::vector<double> silence(static_cast<std::size_t>(4.0 * kRate), 0.0);
  EXPECT_FALSE(freeDecay(silence, Hertz(kRate), Rpm(9000.0)).decay);
  Random random(3);
  for (double& x : silence) x = random.normal();
  EXPECT_FALSE(freeDecay(silence, Hertz(kRate), Rpm(9000.0)).decay);
  const auto mode = struckMode(1012.0, 60.0, 4.0, 1.0);
  EXPECT_FALSE(freeDecay(std::span(mode).first(9000), Hertz(kRate), Rpm(9000.0)).decay);
  EXPECT_FALSE(freeDecay(mode, Hertz(kRate), Rpm{}).decay);
  EXPECT_FALSE(freeDecay(mode, Hertz(4000.0), Rpm(9000.0)).decay);
}

milling::CutModel slot() {
  milling::CutModel model;
  model.tool.teeth = 3;
  model.tool.diameter = Metres(0.012);
  model.material.tangential = 7.5e8;
  model.material.radial = 0.3 * 7.5e8;
  model.engagement = {1.0, milling::MillingDirection::Down, {}};
  for (int axis = 0; axis < 2; ++axis) {
    milling::Mode m;
    m.frequency = Hertz(axis == 0 ? 950.0 : 1080.0);
    m.damping = 0.03;
    m.stiffness = 1.5e7;
    m.direction = {axis == 0 ? 1.0 : 0.0, axis == 0 ? 0.0 : 1.0};
    model.modes.push_back(m);
  }
  return model;
}

// Acceleration of the tip along an axis in a cut with rough material, in the time domain.
std::vector<double> heard(const milling::CutModel& model, double rpm, double depth, double seconds, std::size_t axis) {
  milling::CutNumerics numerics;
  numerics.stepsPerRevolution = 512;
  numerics.deepest = Metres(depth);
  milling::RegenerativeCut cut(model, numerics);
  const std::array<milling::AngularWindow, 1> window{
      milling::AngularWindow{model.engagement.startAngle(), model.engagement.exitAngle()}};
  cut.setWindows(window);
  cut.setSpeed(rpm / 60.0 * kTwoPi);
  cut.setFeed(50e-6 * model.tool.teeth * rpm / 60.0);
  cut.setAxialDepth(depth);
  Random random(5);
  std::vector<double> x;
  const auto steps = static_cast<int>(seconds * rpm / 60.0 * 512.0);
  for (int i = 0; i < steps; i += 3) {
    cut.setExternalForce(4.0 * random.normal(), 4.0 * random.normal());
    cut.advance(3);
    if (i > steps / 10) x.push_back(cut.tipAcceleration()[axis]);
  }
  return x;
}

TEST(StableMargin, TellsHowMuchDeeperACutCouldBe) {
  const milling::CutModel model = slot();
  const Rpm speed(9000.0);
  const double limit = test::trueLimit(model, speed, Metres(0.02)).depth;
  std::vector<PriorMode> modes;
  for (const milling::Mode& m : model.modes) modes.push_back({m, {}});
  LearnParams params;
  params.guesses = 400;
  LobePosterior posterior(priorOfTap(modes, model.material), {Rpm(6000.0), Rpm(12000.0), Metres(0.02)}, params);
  const double rate = 512.0 / 3.0 * 150.0;
  double before = 1e9;
  for (const double share : {0.5, 0.7, 0.9}) {
    const double depth = share * limit;
    std::optional<FreeDecay> decay;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto answer = freeDecay(heard(model, speed.value, depth, 5.0, axis), Hertz(rate), speed);
      if (answer.decay && (!decay || answer.decay->rate < decay->rate)) decay = answer.decay;
    }
    ASSERT_TRUE(decay) << share;
    EXPECT_LT(decay->rate, before);
    before = decay->rate;
    const auto answer = stableMargin(posterior, {model.engagement, 3, speed, Metres(depth)}, *decay);
    ASSERT_TRUE(answer.margin) << share << ": " << text(answer.why);
    EXPECT_NEAR(answer.margin->rise.value, limit - depth, 0.25 * limit);
    EXPECT_GE(answer.margin->high.value, 0.8 * (limit - depth));
    EXPECT_LE(answer.margin->low.value, 1.2 * (limit - depth) + 0.05 * limit);
  }
}

TEST(StableMargin, IsSilentWhereTheDecayFitsNothing) {
  const milling::CutModel model = slot();
  std::vector<PriorMode> modes;
  for (const milling::Mode& m : model.modes) modes.push_back({m, {}});
  LearnParams params;
  params.guesses = 200;
  LobePosterior posterior(priorOfTap(modes, model.material), {Rpm(6000.0), Rpm(12000.0), Metres(0.02)}, params);
  FreeDecay other;
  other.frequency = Hertz(2600.0);
  other.frequencySd = Hertz(5.0);
  other.rate = 50.0;
  other.rateSd = 5.0;
  EXPECT_FALSE(stableMargin(posterior, {model.engagement, 3, Rpm(9000.0), Metres(0.3e-3)}, other).margin);
}

}  // namespace
}  // namespace stillcut::learn
