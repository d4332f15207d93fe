// The exact beam against closed forms and against finite elements that share nothing with it.
#include "core/milling/coupling/beam.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/coupling/beam_elements.h"

namespace stillcut::coupling {
namespace {

using Complex = std::complex<double>;

constexpr double kLength = 0.08;
constexpr double kDiameter = 0.012;

test::Round round(const BeamMaterial& m) {
  return {kLength, kDiameter, m.young, m.density, m.poisson};
}
const std::vector<BeamSection> kTool{{Metres(kLength), Metres(kDiameter)}};

// Bishop and Johnson 1960, table 7.1(c): free-free beam, direct and cross receptances of the ends by forces.
Complex closedForm(bool direct, double frequency, const BeamMaterial& m) {
  const double area = 0.125 * kTwoPi * kDiameter * kDiameter;
  const double inertia = kTwoPi * std::pow(kDiameter, 4) / 128.0;
  const double w = kTwoPi * frequency;
  const Complex rigidity = m.young * Complex(1.0, m.lossFactor) * inertia;
  const Complex lambda = std::pow(w * w * m.density * area / rigidity, 0.25);
  const Complex x = lambda * kLength;
  const Complex f3 = std::cos(x) * std::cosh(x) - 1.0;
  const Complex f5 = std::cos(x) * std::sinh(x) - std::sin(x) * std::cosh(x);
  const Complex f8 = std::sin(x) - std::sinh(x);
  return (direct ? -f5 : f8) / (rigidity * lambda * lambda * lambda * f3);
}

double worst(const Block& a, const Block& b) {
  double off = 0.0;
  for (int r = 0; r < 2; ++r) {
    for (int c = 0; c < 2; ++c) off = std::max(off, std::abs(a(r, c) - b(r, c)) / std::abs(b(r, c)));
  }
  return off;
}

TEST(Beam, EulerAndBernoullisIsThatOfTheClosedForm) {
  const BeamMaterial m = carbide();
  for (const double f : {50.0, 400.0, 2000.0, 6000.0, 12000.0, 20000.0}) {
    const BeamReceptance got = freeBeam(kTool, m, BeamTheory::EulerBernoulli, Hertz(f));
    EXPECT_LT(std::abs(got.tip(0, 0) / closedForm(true, f, m) - 1.0), 1e-8) << f;
    EXPECT_LT(std::abs(got.held(0, 0) / closedForm(true, f, m) - 1.0), 1e-8) << f;
    EXPECT_LT(std::abs(got.tipByHeld(0, 0) / closedForm(false, f, m) - 1.0), 1e-8) << f;
  }
}

TEST(Beam, EveryReceptanceIsThatOfFiniteElements) {
  BeamMaterial m = highSpeedSteel();
  m.lossFactor = 0.01;
  for (const bool timoshenko : {false, true}) {
    const test::Elements elements = test::assemble(round(m), 60, timoshenko);
    const Eigen::Index last = elements.mass.rows() - 2;
    for (const double f : {100.0, 1500.0, 5000.0, 9000.0}) {
      const Eigen::MatrixXcd truth = test::receptance(elements, f, m.lossFactor);
      const auto got = freeBeam(kTool, m, timoshenko ? BeamTheory::Timoshenko : BeamTheory::EulerBernoulli, Hertz(f));
      EXPECT_LT(worst(got.tip, truth.topLeftCorner<2, 2>()), 1e-3) << f;
      EXPECT_LT(worst(got.tipByHeld, truth.block<2, 2>(0, last)), 1e-3) << f;
      EXPECT_LT(worst(got.heldByTip, truth.block<2, 2>(last, 0)), 1e-3) << f;
      EXPECT_LT(worst(got.held, truth.block<2, 2>(last, last)), 1e-3) << f;
    }
  }
}

TEST(Beam, SeveralSectionsOfOneDiameterAreOneBeam) {
  const std::vector<BeamSection> parts{{Metres(0.02), Metres(kDiameter)}, {Metres(0.06), Metres(kDiameter)}};
  const auto whole = freeBeam(kTool, carbide(), BeamTheory::Timoshenko, Hertz(3000));
  const auto joined = freeBeam(parts, carbide(), BeamTheory::Timoshenko, Hertz(3000));
  EXPECT_LT(worst(joined.tip, whole.tip), 1e-8);
  EXPECT_LT(worst(joined.held, whole.held), 1e-8);
}

TEST(Beam, NonsenseIsRefused) {
  EXPECT_FALSE(check({}, carbide(), "tool").ok());
  EXPECT_FALSE(check({{Metres(0.0), Metres(0.01)}}, carbide(), "tool").ok());
  EXPECT_FALSE(check({{Metres(0.05), Metres(NAN)}}, carbide(), "tool").ok());
  BeamMaterial nothing = carbide();
  nothing.young = 0.0;
  EXPECT_FALSE(check(kTool, nothing, "tool").ok());
  EXPECT_TRUE(check(kTool, carbide(), "tool").ok());
}

}  // namespace
}  // namespace stillcut::coupling
