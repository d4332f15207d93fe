// Growth of a small perturbation against the exact Floquet multiplier and against Liao's figure 4.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/milling/regenerative_cut.h"

namespace stillcut::milling {
namespace {

constexpr AngularWindow kSlot{0.0, std::numbers::pi};

// The standard single mode of the shared lobes (ins1dof).
Mode standardMode() {
  Mode m;
  m.frequency = Hertz(922.0);
  m.damping = 0.011;
  m.stiffness = 0.03993 * std::pow(kTwoPi * 922.0, 2);
  return m;
}

// Mean growth of the logarithm of the motion's size per tooth period, over `periods` after as many for settling.
double logGrowth(RegenerativeCut& cut, int stepsPerTooth, double naturalHz, int periods) {
  cut.disturb(0, 1e-6, 0.0);
  cut.advance(stepsPerTooth * periods);
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (int k = 0; k < periods; ++k) {
    cut.advance(stepsPerTooth);
    const double size = std::log(std::hypot(cut.displacement(0), cut.velocity(0) / (kTwoPi * naturalHz)));
    n += 1.0;
    sx += k;
    sy += size;
    sxx += static_cast<double>(k) * k;
    sxy += k * size;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// |mu| per tooth period of the slot at 5000 rpm; linear (teeth do not leave the cut), no feed: pure perturbation.
double multiplier(double depth, int steps) {
  CutModel model;
  model.modes = {standardMode()};
  CutNumerics n;
  n.stepsPerRevolution = steps;
  n.mayLeaveCut = false;
  RegenerativeCut cut(model, n);
  cut.setSpeed(5000.0 * kTwoPi / 60.0);
  cut.setWindows({&kSlot, 1});
  cut.setAxialDepth(depth);
  return std::exp(logGrowth(cut, steps / 2, 922.0, 400));
}

struct Golden {
  double depth, mu;
};
constexpr std::array<Golden, 4> kGolden{
    {{0.2e-3, 0.81974278}, {0.5e-3, 1.07397559}, {0.7e-3, 1.22155614}, {1.0e-3, 1.40647353}}};

TEST(Growth, EqualsTheExactFloquetMultiplier) {
  for (const Golden& g : kGolden) EXPECT_NEAR(multiplier(g.depth, 2048), g.mu, 5e-4) << g.depth;
}

TEST(Growth, ErrorShrinksWithTheSquareOfTheStep) {
  for (const Golden& g : kGolden) {
    const double coarse = std::abs(multiplier(g.depth, 512) - g.mu), fine = std::abs(multiplier(g.depth, 1024) - g.mu);
    EXPECT_GT(coarse / fine, 3.0) << g.depth;  // first order would give 2, second order gives 4
  }
}

// Liao's loop, 1 + (1 - e^(-Ts)) (b k_c / k_m) G(s) = 0, is a slot with four teeth and one mode along the feed: the two
// teeth in the cut give sin^2 + cos^2, so the radial coefficient acts all the time, the tangential one not at all.
double liaoDecay(double toothHz) {
  CutModel model;
  Mode m;
  m.frequency = Hertz(30.0);
  m.damping = 0.025;  // the printed 0.25 is stable at every speed (methods.md section 3)
  m.stiffness = 1e7;
  model.modes = {m};
  model.tool.teeth = 4;
  model.material.radial = 1e9;
  const double depth = 0.2 * m.stiffness / model.material.radial;
  CutNumerics n;
  n.mayLeaveCut = false;
  RegenerativeCut cut(model, n);
  cut.setSpeed(toothHz / 4.0 * kTwoPi);
  cut.setWindows({&kSlot, 1});
  cut.setAxialDepth(depth);
  return -logGrowth(cut, n.stepsPerRevolution / 4, 30.0, 60) * toothHz;
}

TEST(Growth, LiaosFigureFour) {
  EXPECT_LT(liaoDecay(19.6), 0.0);  // diverges without control
  EXPECT_NEAR(liaoDecay(33.2 / 1.25), 15.4, 1.54);
  EXPECT_NEAR(liaoDecay(33.2 / 1.4), 3.0, 1.0);
  EXPECT_NEAR(liaoDecay(33.2 / 1.1), 3.0, 1.0);
  EXPECT_LT(liaoDecay(33.2 / 1.75), 0.0);
}

}  // namespace
}  // namespace stillcut::milling
