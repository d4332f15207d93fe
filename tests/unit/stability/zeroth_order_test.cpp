#include "core/milling/stability/zeroth_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/milling/stability/exact_lobes.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

// One degree of freedom: w_min = 2 k zeta (1 + zeta) / |H0|, H0 = mean of the projected coefficient (Tlusty); at the
// best phase it is reached at omega = omega_n sqrt(1 + 2 zeta) for H0 > 0.
TEST(ZerothOrder, LowestPointOfTheLobesIsTlustysFormula) {
  CutModel model = textbookSlot();
  const double meanCoefficient = 2e8 * 0.5 * 2 / 2;  // slot, two teeth: N/(2 pi) * integral (Kn sin^2) = Kn/2
  const double zeta = model.modes[0].damping;
  const double lowest = 2.0 * model.modes[0].stiffness * zeta * (1.0 + zeta) / meanCoefficient;
  const auto zoa = ZerothOrder::make(model, "slot");
  double found = 1.0;
  for (double rpm = 5000.0; rpm < 7000.0; rpm += 2.0) {
    const auto limit = zoa->limit(Rpm(rpm), Metres(20e-3));
    if (limit->hasLimit()) found = std::min(found, limit->crossings[0].depth.value);
  }
  EXPECT_NEAR(found / lowest, 1.0, 1e-4);
  EXPECT_GE(found, lowest * (1.0 - 1e-9));
}

// Along one lobe: 1/(2 |H0| |Re G|) and the phase of the wave left between two teeth.
TEST(ZerothOrder, EveryPointLiesOnItsLobe) {
  const CutModel model = textbookSlot();
  const auto zoa = ZerothOrder::make(model, "slot");
  const double omegaN = kTwoPi * 922.0;
  for (double rpm : {5100.0, 8000.0, 14000.0}) {
    const auto limit = zoa->limit(Rpm(rpm), Metres(20e-3));
    ASSERT_TRUE(limit->hasLimit());
    const double omega = kTwoPi * limit->crossings[0].frequency.value;
    const std::complex<double> g =
        1.0 / (0.03993 * std::complex<double>(omegaN * omegaN - omega * omega, 2 * 0.011 * omegaN * omega));
    EXPECT_NEAR(limit->crossings[0].depth.value, -1.0 / (2.0 * 1e8 * g.real()), 1e-9);
    const std::complex<double> one =
        1.0 + limit->crossings[0].depth.value * 1e8 * g * (1.0 - std::polar(1.0, -omega * 30.0 / rpm));
    EXPECT_NEAR(std::abs(one), 0.0, 1e-7) << rpm;
  }
}

TEST(ZerothOrder, ReproducesTheSharedColumn) {
  STILLCUT_NEEDS_REFERENCE();
  for (const char* name : kReferenceNames) {
    const ReferenceCase reference = loadReference(name);
    const auto zoa = ZerothOrder::make(reference.model, name);
    std::vector<double> errors;
    for (const auto& [rpm, depth] : reference.zoa) {
      const auto limit = zoa->limit(Rpm(rpm), Metres(1.0));
      ASSERT_TRUE(limit->hasLimit()) << name << rpm;
      errors.push_back(std::abs(limit->crossings[0].depth.value / depth - 1.0));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 1e-3) << name;
    EXPECT_LT(errors[errors.size() * 9 / 10], 2e-2) << name;
  }
}

TEST(ZerothOrder, SaysWhereItCannotBeTrusted) {
  CutModel model = textbookSlot();
  const std::string mild = text(ZerothOrder::make(model, "slot")->warning());
  model.engagement = {0.05, MillingDirection::Down};
  const auto low = ZerothOrder::make(model, "low");
  EXPECT_NE(text(low->warning()).find("far too high"), std::string::npos);
  EXPECT_EQ(mild.find("far too high"), std::string::npos);
  EXPECT_FALSE(mild.empty());
  // And the warning is deserved: somewhere it allows over half as much again.
  const auto exact = ExactLobes::make(model, "low");
  double worst = 0.0;
  for (double rpm = 8000.0; rpm <= 20000.0; rpm += 250.0) {
    const auto a = low->limit(Rpm(rpm), Metres(20e-3));
    const auto b = exact->limits(Rpm(rpm), {Metres(20e-3), true, false, {}});
    if (a->hasLimit() && b->hasLimit()) {
      worst = std::max(worst, a->crossings[0].depth / b->crossings[0].depth);
    }
  }
  EXPECT_GT(worst, 1.5);
}

}  // namespace
}  // namespace stillcut::milling
