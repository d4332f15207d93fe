// The filters do what their name promises: half power exactly at the edges, monotone flanks of the right slope, and
// retuning that keeps the state.
#include "core/dsp/butterworth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/dsp/kernels/choose.h"

namespace stillcut::dsp {
namespace {

constexpr Hertz kRate{25600.0};
const double kHalfPower = std::sqrt(0.5);

class LowHigh : public testing::TestWithParam<int> {};

TEST_P(LowHigh, HalfPowerAtTheEdgeAndOneFarAway) {
  const int order = GetParam();
  for (const double edge : {20.0, 366.7, 5000.0, 11000.0}) {
    Butterworth low;
    low.lowPass(order, Hertz(edge), kRate);
    EXPECT_NEAR(std::abs(low.response(Hertz(edge), kRate)), kHalfPower, 1e-9) << order << " " << edge;
    EXPECT_NEAR(std::abs(low.response(Hertz(edge / 1000), kRate)), 1.0, 1e-3);
    Butterworth high;
    high.highPass(order, Hertz(edge), kRate);
    EXPECT_NEAR(std::abs(high.response(Hertz(edge), kRate)), kHalfPower, 1e-9) << order << " " << edge;
    EXPECT_NEAR(std::abs(high.response(Hertz(0.4999 * kRate.value), kRate)), 1.0, 1e-3);
  }
}

TEST_P(LowHigh, FallsSixDecibelPerOctaveAndOrder) {
  const int order = GetParam();
  Butterworth high;
  high.highPass(order, Hertz(400.0), kRate);
  // Well below the edge and far below Nyquist the analogue slope holds.
  const double ratio = std::abs(high.response(Hertz(20.0), kRate)) / std::abs(high.response(Hertz(10.0), kRate));
  EXPECT_NEAR(std::log2(ratio), order, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Orders, LowHigh, testing::Values(1, 2, 3, 4, 5, 8));

TEST(Retune, TheTimeDomainFollowsTheResponseAndTheStateSurvives) {
  Butterworth filter;
  filter.lowPass(4, Hertz(1100.0), kRate);
  const double f = 900.0;
  double worst = 0.0;
  for (int n = 0; n < 12800; ++n) {
    if (n == 6400) filter.lowPass(4, Hertz(1000.0), kRate);
    const double y = filter.process(std::sin(kTwoPi * f * n / kRate.value));
    EXPECT_LT(std::abs(y), 1.2);  // no click on retuning
    if (n > 12000) worst = std::max(worst, std::abs(y));
  }
  EXPECT_NEAR(worst, std::abs(filter.response(Hertz(f), kRate)), 0.01);
  EXPECT_LT(worst, 0.85);  // of the new edge: 0.91 before
}

TEST(Stretches, SeveralSignalsAtOnceAreEachOfThemSampleBySample) {
  constexpr std::size_t kFrames = 400;
  for (const int order : {1, 2, 5, 10, 16}) {
    for (const std::size_t signals : {1U, 2U, 3U}) {
      Butterworth prototype;
      prototype.lowPass(order, Hertz(3000.0), kRate);
      std::vector<Butterworth> alone(signals, prototype);
      std::vector<double> x;
      for (std::size_t k = 0; k < signals * kFrames; ++k) x.push_back(std::sin(0.01 * static_cast<double>(k * k)));
      for (const kernels::InstructionSet set : kernels::availableSets()) {
        std::vector<Butterworth> together = alone;
        std::vector<double> y = x;
        const auto stride = static_cast<std::ptrdiff_t>(kFrames);
        for (const auto& [from, frames] : {std::pair{0U, 257U}, {257U, 143U}}) {
          Butterworth::process(together, y.data() + from, stride, y.data() + from, stride, frames,
                               kernels::kernelsOf(set));
        }
        std::vector<Butterworth> plain = alone;
        for (std::size_t k = 0; k < x.size(); ++k) ASSERT_EQ(y[k], plain[k / kFrames].process(x[k])) << order;
      }
    }
  }
}

}  // namespace
}  // namespace stillcut::dsp
