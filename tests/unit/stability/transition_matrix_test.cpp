#include "core/milling/stability/transition_matrix.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/stability/characteristic.h"
#include "core/milling/stability/crossing_finder.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

std::vector<Complex> psi(const TransitionMatrix& t, Complex s) {
  std::vector<Complex> matrix(static_cast<std::size_t>(t.states() * t.states()));
  WorkMeter meter;
  EXPECT_TRUE(t.evaluate(std::span(&s, 1), matrix, meter));
  return matrix;
}

double distance(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  double d = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

TEST(TransitionMatrix, WithoutForceItIsTheFreeDecay) {
  const auto system = makeRegenerativeSystem(textbookSlot(), "slot").value();
  WorkMeter meter;
  const TransitionMatrix t(system, Rpm(5000), 2e-3, 1.0, meter);
  const auto m = psi(t, 0.0);
  const double omega = kTwoPi * 922.0;
  const double tau = 0.006;
  const double ratio = std::sqrt(1.0 - 0.011 * 0.011);
  const double decay = std::exp(-0.011 * omega * tau);
  EXPECT_NEAR((m[0] + m[3]).real(), 2.0 * decay * std::cos(omega * ratio * tau), 1e-12);
  EXPECT_NEAR(m[1].real(), -decay * std::sin(omega * ratio * tau) / ratio, 1e-12);
}

TEST(TransitionMatrix, TheStepIsOfSixthOrder) {
  for (const CutModel& model : {textbookSlot(), textbookHalf()}) {
    const auto system = makeRegenerativeSystem(model, "cut").value();
    WorkMeter meter;
    const Complex s(1e-3, 0.7e-3);
    const auto reference = psi(TransitionMatrix(system, Rpm(5000), 2e-3, 0.15, meter), s);
    const double coarse = distance(psi(TransitionMatrix(system, Rpm(5000), 2e-3, 1.6, meter), s), reference);
    const double fine = distance(psi(TransitionMatrix(system, Rpm(5000), 2e-3, 0.8, meter), s), reference);
    EXPECT_LT(fine, coarse / 40.0);  // 64 in the limit
  }
}

// Liouville: the force does not change the volume, the damping shrinks it.
TEST(TransitionMatrix, DeterminantDependsOnDampingAlone) {
  const auto system = makeRegenerativeSystem(textbookSlot(), "slot").value();
  WorkMeter meter;
  const TransitionMatrix t(system, Rpm(7000), 4e-3, 1.0, meter);
  for (Complex s : {Complex(0.0), Complex(2e-3, 1e-3), Complex(3e-3, -2e-3)}) {
    const auto m = psi(t, s);
    EXPECT_NEAR(std::abs(m[0] * m[3] - m[1] * m[2] - t.determinant()), 0.0, 1e-10);
  }
}

TEST(Characteristic, ExpansionAgreesWithTheMatrixAndItsDerivativesWithDifferences) {
  const auto system = makeRegenerativeSystem(textbookHalf(), "half").value();
  WorkMeter meter;
  const TransitionMatrix t(system, Rpm(6000), 2e-3, 1.0, meter);
  const auto f = Characteristic::build(t, 1e-3, 1e-3, meter);
  ASSERT_TRUE(f.has_value());
  for (double angle : {0.3, 1.4, 2.9}) {
    const Complex mu = std::polar(1.0, angle);
    const Complex s = 0.9e-3 * (1.0 - 1.0 / mu);
    std::vector<Complex> c(4);
    characteristicCoefficients(psi(t, s), 4, t.determinant(), c);
    const Complex direct = (((mu + c[3]) * mu + c[2]) * mu + c[1]) * mu + c[0];
    const CharacteristicValue v = f->at(mu, s);
    EXPECT_LT(std::abs(v.f - direct), 1e-6);
    EXPECT_LT(std::abs(v.f - f->valueAt(mu, s)), 1e-12);
    const double h = 1e-8;
    const Complex slope = (f->valueAt(mu, s + h) - f->valueAt(mu, s - h)) / (2.0 * h);
    EXPECT_LT(std::abs(v.fs - slope), 1e-4 * std::abs(slope));
    const CharacteristicValue up = f->at(mu + 1e-5, s);
    const CharacteristicValue down = f->at(mu - 1e-5, s);
    EXPECT_LT(std::abs((up.f - down.f) / 2e-5 - v.fm), 1e-6 * (1.0 + std::abs(v.fm)));
    EXPECT_LT(std::abs((up.fs - down.fs) / 2e-5 - v.fsm), 1e-6 * std::abs(v.fsm) + 1e-3);
  }
}

TEST(CrossingFinder, FirstAndSecondDerivativesOnTheCircle) {
  const auto system = makeRegenerativeSystem(textbookSlot(), "slot").value();
  WorkMeter meter;
  const TransitionMatrix t(system, Rpm(6000), 2e-3, 1.0, meter);
  const auto f = Characteristic::build(t, 2e-3, 2e-3, meter);
  ASSERT_TRUE(f.has_value());
  const double a = 1.1;
  const double w = 1.3e-3;
  const CircleValue v = onCircle(*f, a, w);
  const double ha = 1e-5;
  const double hw = 1e-8;
  const CircleValue ap = onCircle(*f, a + ha, w);
  const CircleValue am = onCircle(*f, a - ha, w);
  const CircleValue wp = onCircle(*f, a, w + hw);
  const CircleValue wm = onCircle(*f, a, w - hw);
  const auto near = [](Complex x, Complex y) { return std::abs(x - y) < 1e-5 * (std::abs(x) + std::abs(y)); };
  EXPECT_TRUE(near(v.fa, (ap.f - am.f) / (2 * ha)));
  EXPECT_TRUE(near(v.fw, (wp.f - wm.f) / (2 * hw)));
  EXPECT_TRUE(near(v.faa, (ap.fa - am.fa) / (2 * ha)));
  EXPECT_TRUE(near(v.faw, (wp.fa - wm.fa) / (2 * hw)));
  EXPECT_TRUE(near(v.fww, (wp.fw - wm.fw) / (2 * hw)));
}

}  // namespace
}  // namespace stillcut::milling
