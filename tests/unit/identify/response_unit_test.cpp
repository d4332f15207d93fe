#include "core/milling/identify/response_unit.h"

#include <gtest/gtest.h>

#include "core/base/units.h"

namespace stillcut::identify {
namespace {

// A mode of `stiffness` N/m in a unit of which there are `perMetre` in a m/N.
Frf frf(double stiffness, double perMetre) {
  Frf out;
  out.source = "bare.txt";
  out.unitKnown = false;
  for (double f = 10.0; f < 1500.0; f += 2.0) {
    const double r = f / 600.0;
    out.frequency.push_back(f);
    out.value.push_back(perMetre / (stiffness * std::complex<double>(1.0 - r * r, 2.0 * 0.03 * r)));
  }
  return out;
}

TEST(ResponseUnit, IsFoundWhereOnlyOneGivesTheStiffnessOfATool) {
  EXPECT_EQ(unitByStiffness(frf(2e7, 1.0), {})->factor, 1.0);
  EXPECT_EQ(unitByStiffness(frf(2e7, 1e6), {})->factor, 1e-6);
  EXPECT_NE(text(unitByStiffness(frf(2e7, 1.0), {})->remark).find("m/N"), std::string::npos);
}

TEST(ResponseUnit, IsAskedForWhereTwoAreAsLikely) {
  const auto soft = unitByStiffness(frf(1e6, 1.0), {});  // in/lbf would give 1.8e8 N/m
  ASSERT_FALSE(soft.ok());
  EXPECT_NE(soft.error().line().find("--unit"), std::string::npos);
  EXPECT_FALSE(unitByStiffness(frf(2e7, 1e3), {}).ok()) << "mm/N, or in/lbf with 1.1e8 N/m";
}

TEST(ResponseUnit, OfAnAcceleranceIsNeverGuessed) {
  Frf g = frf(2e7, 1.0);
  for (std::size_t i = 0; i < g.value.size(); ++i) g.value[i] *= -std::pow(kTwoPi * g.frequency[i], 2) / 9.80665;
  EXPECT_FALSE(unitByStiffness(g, {}).ok());
  g.quantity = FrfQuantity::Accelerance;
  EXPECT_FALSE(unitByStiffness(g, {}).ok());
}

}  // namespace
}  // namespace stillcut::identify
