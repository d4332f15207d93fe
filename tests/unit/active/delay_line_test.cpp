#include "core/active/delay_line.h"

#include <gtest/gtest.h>

#include "core/dsp/kernels/choose.h"
#include "tests/unit/active/plain.h"

namespace stillcut::active {
namespace {

TEST(DelayLine, HoldsTheNewestValuesFirstHoweverLongItRuns) {
  for (std::size_t taps : {1U, 7U, 8U, 35U}) {
    DelayLine line;
    line.prepare(taps);
    const auto x = whiteNoise(1000, 1);
    for (std::size_t n = 0; n < x.size(); ++n) {
      line.push(x[n]);
      for (std::size_t k = 0; k < line.size(); ++k) ASSERT_EQ(line.data()[k], past(x, n, k)) << taps << " " << n;
    }
    line.reset();
    for (std::size_t k = 0; k < line.size(); ++k) EXPECT_EQ(line.data()[k], 0.0);
  }
}

// With every instruction set, and with the same bits: a replay on another processor is the same replay.
TEST(DelayLine, SumsAreSumsOnEveryInstructionSet) {
  for (std::size_t n : {dsp::kernels::kLanes, 5 * dsp::kernels::kLanes}) {
    const auto a = whiteNoise(n, 2);
    const auto b = whiteNoise(n, 3);
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) sum += a[k] * b[k];
    const auto baseline = dsp::kernels::kernelsOf(dsp::kernels::InstructionSet::Baseline);
    for (const auto set : dsp::kernels::availableSets()) {
      const auto kernels = dsp::kernels::kernelsOf(set);
      EXPECT_NEAR(kernels.tapSum(a.data(), b.data(), n), sum, 1e-13);
      EXPECT_EQ(kernels.tapSum(a.data(), b.data(), n), baseline.tapSum(a.data(), b.data(), n));
      std::vector<double> c = a;
      kernels.tapSteer(c.data(), 0.9, 0.1, b.data(), n);
      for (std::size_t k = 0; k < n; ++k) EXPECT_DOUBLE_EQ(c[k], 0.9 * a[k] + 0.1 * b[k]);
    }
  }
}

}  // namespace
}  // namespace stillcut::active
