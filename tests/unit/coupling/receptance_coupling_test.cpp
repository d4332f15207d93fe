// Coupling against structures whose response is known without it.
#include "core/milling/coupling/receptance_coupling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/identify/modal_fit.h"
#include "tests/unit/coupling/beam_elements.h"

namespace stillcut::coupling {
namespace {

using Complex = std::complex<double>;
using identify::Frf;

const std::vector<BeamSection> kTool{{Metres(0.02), Metres(0.0096)}, {Metres(0.03), Metres(0.012)}};

// A steel stub that sticks out of the wall: a holder whose receptances are known exactly.
const std::vector<BeamSection> kHolder{{Metres(0.10), Metres(0.03)}};

Block clamped(const std::vector<BeamSection>& beam, const BeamMaterial& material, double f) {
  return tipOf(freeBeam(beam, material, BeamTheory::Timoshenko, Hertz(f)), Block::Zero());
}

BeamMaterial damped(BeamMaterial m) {
  m.lossFactor = 0.04;
  return m;
}

TEST(Coupling, AToolOnARigidHolderIsACantilever) {
  // Euler and Bernoulli: (1.8751, 4.6941)^2 / (2 pi L^2) sqrt(E I / rho A), and an eighth-power flat stiffness 3 E I /
  // L^3.
  const BeamMaterial m = carbide();
  const double length = 0.06;
  const double d = 0.006;
  const std::vector<BeamSection> tool{{Metres(length), Metres(d)}};
  const auto at = [&](double f) {
    return tipOf(freeBeam(tool, m, BeamTheory::EulerBernoulli, Hertz(f)), Block::Zero())(0, 0);
  };
  const double inertia = kTwoPi * std::pow(d, 4) / 128.0;
  EXPECT_NEAR(std::abs(at(1.0)) * 3.0 * m.young * inertia / std::pow(length, 3), 1.0, 1e-4);
  for (const double root : {1.8751, 4.6941}) {
    const double f = root * root / (kTwoPi * length * length) * std::sqrt(m.young / m.density) * d / 4.0;
    EXPECT_GT(std::abs(at(f)), 5.0 * std::abs(at(0.97 * f)));
    EXPECT_GT(std::abs(at(f)), 5.0 * std::abs(at(1.03 * f)));
  }
}

// Of the largest response at the tip on a clamp that gives way by `softness` [rad/(N m)].
double firstFrequency(const std::vector<BeamSection>& beam, const BeamMaterial& material, BeamTheory theory,
                      double softness) {
  Block clamp = Block::Zero();
  clamp(1, 1) = softness;
  double best = 0.0, most = 0.0;
  for (double f = 200.0; f < 600.0; f += 0.5) {
    const double size = std::abs(tipOf(freeBeam(beam, material, theory, Hertz(f)), clamp)(0, 0));
    if (size > most) best = f;
    most = std::max(most, size);
  }
  return best;
}

// The worked example of Machining Dynamics, chapter 9: a fixed-free steel cylinder of 10 mm, 125 mm long, loss factor
// 0.01, with its response drawn from 300 to 700 Hz, the imaginary part down to some -6.5e-4 m/N.
TEST(Coupling, TheFixedFreeCylinderOfTheTextbook) {
  BeamMaterial steel = highSpeedSteel();
  steel.young = 200e9;
  steel.density = 7800.0;
  steel.lossFactor = 0.01;
  const std::vector<BeamSection> cylinder{{Metres(0.125), Metres(0.010)}};
  const double f = firstFrequency(cylinder, steel, BeamTheory::EulerBernoulli, 0.0);
  EXPECT_NEAR(f, 453.4, 1.0);
  const Complex tip = tipOf(freeBeam(cylinder, steel, BeamTheory::EulerBernoulli, Hertz(453.4)), Block::Zero())(0, 0);
  EXPECT_NEAR(tip.imag(), -6.4e-4, 0.2e-4);
}

// Measured by J. Li (University of British Columbia, 2019; read off the figures to 8 Hz): clamped cylinders of 7075,
// 190 mm of 16 mm ring at 298 Hz; 140 mm of it with 50 mm of 10 mm in front at 400 Hz. A clamp is softer than a rigid
// one: beams on a wall ring up to 6 % higher. A clamp that gives way as the first measurement says predicts the second.
TEST(Coupling, MeasuredBeamsAreMetWithTheClampThatOneOfThemShows) {
  BeamMaterial aluminium = highSpeedSteel();
  aluminium.young = 7.2e10;
  aluminium.density = 2810.0;
  aluminium.poisson = 0.33;
  aluminium.lossFactor = 0.01;
  const std::vector<BeamSection> plain{{Metres(0.190), Metres(0.016)}};
  const std::vector<BeamSection> stepped{{Metres(0.050), Metres(0.010)}, {Metres(0.140), Metres(0.016)}};
  const auto frequency = [&](const std::vector<BeamSection>& beam, double softness) {
    return firstFrequency(beam, aluminium, BeamTheory::Timoshenko, softness);
  };
  EXPECT_GT(frequency(plain, 0.0), 298.0);
  EXPECT_NEAR(frequency(plain, 0.0), 298.0, 0.06 * 298.0);
  double low = 0.0, high = 1e-3;
  for (int k = 0; k < 20; ++k) {
    const double middle = 0.5 * (low + high);
    (frequency(plain, middle) > 298.0 ? low : high) = middle;
  }
  EXPECT_NEAR(frequency(stepped, low), 400.0, 0.05 * 400.0);
}

TEST(Coupling, TwoBeamsCoupledAreTheWholeBeam) {
  // A beam of one material cut in two: the parts, coupled, are the whole at every frequency.
  const BeamMaterial m = damped(highSpeedSteel());
  std::vector<BeamSection> whole = kTool;
  whole.insert(whole.end(), kHolder.begin(), kHolder.end());
  for (double f = 50.0; f < 8000.0; f += 317.0) {
    const Block coupled = tipOf(freeBeam(kTool, m, BeamTheory::Timoshenko, Hertz(f)), clamped(kHolder, m, f));
    const Block truth = clamped(whole, m, f);
    EXPECT_LT((coupled - truth).norm(), 1e-7 * truth.norm()) << f;
  }
}

// The holder measured as a person would: at its face, and `spacing` further up.
HolderResponse measured(double spacing, const BeamMaterial& m) {
  HolderResponse holder;
  holder.direct.source = "face.csv";
  holder.cross.source = "above.csv";
  holder.spacing = Metres(spacing);
  const int elements = 20;
  const test::Elements stub = test::assemble({0.10, 0.03, m.young, m.density, m.poisson}, elements, true);
  const Eigen::Index n = stub.mass.rows() - 2;
  const test::Elements held{stub.stiffness.topLeftCorner(n, n), stub.mass.topLeftCorner(n, n)};
  const auto node = 2 * std::lround(spacing / 0.005);
  for (double f = 400.0; f <= 5000.0; f += 20.0) {
    const Eigen::VectorXcd h = test::responses(held, f, m.lossFactor);
    holder.direct.frequency.push_back(f);
    holder.direct.value.push_back(h(0));
    holder.cross.frequency.push_back(f);
    holder.cross.value.push_back(h(node));
  }
  return holder;
}

double firstMode(const Frf& frf) {
  const auto fit = identify::fitModes(frf, {});
  EXPECT_TRUE(fit.ok()) << fit.error().line();
  return fit ? fit->modes.front().mode.frequency.value : 0.0;
}

TEST(Coupling, TheTipOfAToolOnAMeasuredHolderIsFound) {
  const BeamMaterial m = damped(highSpeedSteel());
  const HolderResponse holder = measured(0.02, m);
  const auto tip = couple(holder, kTool, m, BeamTheory::Timoshenko);
  ASSERT_TRUE(tip.ok()) << tip.error().line();
  EXPECT_TRUE(tip->remarks.empty());
  Frf truth = holder.direct;
  std::vector<BeamSection> whole = kTool;
  whole.insert(whole.end(), kHolder.begin(), kHolder.end());
  for (std::size_t i = 0; i < truth.value.size(); ++i) truth.value[i] = clamped(whole, m, truth.frequency[i])(0, 0);
  // Rotations come from a finite difference over 20 mm: not exact, and far better than none.
  EXPECT_NEAR(firstMode(tip->tip) / firstMode(truth), 1.0, 0.02);
  EXPECT_GT(firstMode(tip->noRotation), firstMode(truth)) << "a holder that cannot rotate is too stiff";
}

TEST(Coupling, WithoutTheRotationTheDoubtIsSaid) {
  const BeamMaterial m = damped(highSpeedSteel());
  HolderResponse holder = measured(0.02, m);
  holder.cross = {};
  const auto tip = couple(holder, kTool, m, BeamTheory::Timoshenko);
  ASSERT_TRUE(tip.ok()) << tip.error().line();
  ASSERT_EQ(tip->remarks.size(), 1u);
  EXPECT_NE(text(tip->remarks[0]).find("--cross"), std::string::npos);
}

TEST(Coupling, GeometryBecomesSectionsTipFirst) {
  ToolGeometry tool;
  tool.diameter = Metres(0.010);
  tool.shank = Metres(0.012);
  tool.stickOut = Metres(0.050);
  tool.fluteLength = Metres(0.022);
  const auto sections = sectionsOf(tool, "tool");
  ASSERT_TRUE(sections.ok());
  ASSERT_EQ(sections->size(), 2u);
  EXPECT_DOUBLE_EQ((*sections)[0].diameter.value, 0.008);
  EXPECT_DOUBLE_EQ((*sections)[1].length.value, 0.028);
  tool.fluteLength = Metres(0.051);
  EXPECT_FALSE(sectionsOf(tool, "tool").ok());
  tool.fluteLength = Metres(0.0);
  tool.stickOut = Metres(0.0);
  EXPECT_FALSE(sectionsOf(tool, "tool").ok());
}

TEST(Coupling, MeasurementsThatDoNotFitAreRefused) {
  const BeamMaterial m = highSpeedSteel();
  HolderResponse holder = measured(0.02, m);
  holder.cross.frequency.pop_back();
  holder.cross.value.pop_back();
  EXPECT_FALSE(couple(holder, kTool, m, BeamTheory::Timoshenko).ok());
  holder = measured(0.02, m);
  holder.spacing = Metres(0.0);
  EXPECT_FALSE(couple(holder, kTool, m, BeamTheory::Timoshenko).ok());
  EXPECT_FALSE(couple({}, kTool, m, BeamTheory::Timoshenko).ok());
}

}  // namespace
}  // namespace stillcut::coupling
