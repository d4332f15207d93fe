// What lies outside the band of a fit: two modes stand for it, and with them the modes written make the response that
// was measured.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/milling/identify/modal_fit.h"

namespace stillcut::identify {
namespace {

using Complex = std::complex<double>;

Complex compliance(const std::vector<milling::Mode>& modes, double f) {
  Complex sum = 0.0;
  for (const milling::Mode& m : modes) {
    const double r = f / m.frequency.value;
    sum += 1.0 / (m.stiffness * Complex(1.0 - r * r, 2.0 * m.damping * r));
  }
  return sum;
}

TEST(ResidualModes, StandForWhatLiesOutsideTheBand) {
  const std::vector<milling::Mode> structure{{Hertz(60.0), 0.05, 3e6, {}},
                                             {Hertz(800.0), 0.03, 1.2e7, {}},
                                             {Hertz(1100.0), 0.02, 3e7, {}},
                                             {Hertz(5000.0), 0.02, 1.5e7, {}}};
  Frf frf;
  for (double f = 300.0; f <= 1600.0; f += 1.0) {
    frf.frequency.push_back(f);
    frf.value.push_back(compliance(structure, f));
  }
  ModalOptions options;
  options.from = 300.0;
  options.to = 1600.0;
  const auto fit = fitModes(frf, options);
  ASSERT_TRUE(fit.ok()) << fit.error().line();
  ASSERT_EQ(fit->outside, 2);
  ASSERT_GE(fit->whole.size(), 4U);
  EXPECT_LT(fit->whole[fit->whole.size() - 2].frequency.value, 300.0);
  EXPECT_GT(fit->whole.back().frequency.value, 1600.0);
  std::vector<milling::Mode> inside;
  for (const IdentifiedMode& m : fit->modes) inside.push_back(m.mode);
  double whole = 0.0, without = 0.0, with = 0.0;
  for (std::size_t i = 0; i < frf.value.size(); ++i) {
    whole += std::norm(frf.value[i]);
    without += std::norm(compliance(inside, frf.frequency[i]) - frf.value[i]);
    with += std::norm(compliance(fit->whole, frf.frequency[i]) - frf.value[i]);
  }
  EXPECT_GT(std::sqrt(without / whole), 0.1) << "nothing lies outside: the test is idle";
  EXPECT_LT(std::sqrt(with / whole), 0.05);
}

}  // namespace
}  // namespace stillcut::identify
