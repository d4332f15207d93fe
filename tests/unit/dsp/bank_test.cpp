// The bank of band-passes with every instruction set: its design in closed form, and its run sample by sample.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/units.h"
#include "tests/support/plain_band_pass.h"
#include "tests/unit/dsp/every_set.h"

namespace stillcut::dsp::kernels {
namespace {

TEST(Bank, IsButterworthSampleBySample) {
  constexpr Hertz kRate(25600.0);
  constexpr std::size_t kLanesUsed = 24;
  constexpr std::size_t kFrames = 1003;           // not whole lanes
  constexpr std::size_t kRow = kFrames + kLanes;  // a run may write beyond its end
  const Values x = noise(kFrames, 2);
  const auto edge = [&](std::size_t m) { return Hertz(m == 0 ? 60.0 : 440.0 * static_cast<double>(m)); };
  const Values out = sameWithEverySet([&](const Kernels& k) {
    Values low(kLanesUsed);
    Values high(kLanesUsed);
    for (std::size_t m = 0; m < kLanesUsed; ++m) {
      low[m] = std::tan(std::numbers::pi * (edge(m) / kRate));
      high[m] = std::tan(std::numbers::pi * (edge(m + 1) / kRate));
    }
    Values coefficients(5 * kLanesUsed);
    Values state(4 * kLanesUsed);
    k.designBank({low.data(), high.data(), kLanesUsed, kLanesUsed, coefficients.data()});
    Values rows(kLanesUsed * kRow);
    std::vector<double*> to(kLanesUsed);
    for (std::size_t from = 0; from < kFrames; from += 37) {
      const std::size_t frames = std::min<std::size_t>(37, kFrames - from);
      for (std::size_t m = 0; m < kLanesUsed; ++m) to[m] = rows.data() + m * kRow + from;
      k.bank({x.data() + from, frames, kLanesUsed, kLanesUsed, coefficients.data(), state.data(), to.data()});
    }
    return rows;
  });
  for (std::size_t m = 0; m < kLanesUsed; ++m) {
    test::PlainBandPass filter;
    filter.tune(edge(m), edge(m + 1), kRate);
    for (std::size_t k = 0; k < kFrames; ++k) {
      ASSERT_NEAR(out[m * kRow + k], filter.process(x[k]), 1e-11) << "band " << m << " frame " << k;
    }
  }
}

// The response at every frequency in closed form, |H|^2 = 1/(1 + u^4) with u = (w^2 - w1 w2)/(w (w2 - w1)) and
// w = tan(pi f/rate): half power exactly at both edges, and one in the middle.
TEST(Bank, ItsDesignHasButterworthsResponse) {
  constexpr double kRate = 25600.0;
  const std::vector<std::pair<double, double>> bands{{60.0, 440.0},      {440.0, 880.0},    {733.0, 1100.0},
                                                     {1000.0, 1001.0},   {10.0, 8000.0},    {5000.0, 5367.0},
                                                     {11000.0, 12000.0}, {12000.0, 12700.0}};
  const std::size_t lanes = wholeLanes(bands.size());
  Values low(lanes, 0.1);
  Values high(lanes, 0.2);
  for (std::size_t m = 0; m < bands.size(); ++m) {
    low[m] = std::tan(std::numbers::pi * bands[m].first / kRate);
    high[m] = std::tan(std::numbers::pi * bands[m].second / kRate);
  }
  const Values c = sameWithEverySet([&](const Kernels& k) {
    Values coefficients(5 * lanes);
    k.designBank({low.data(), high.data(), lanes, lanes, coefficients.data()});
    return coefficients;
  });
  for (std::size_t m = 0; m < bands.size(); ++m) {
    EXPECT_LT(std::max(c[2 * lanes + m], c[4 * lanes + m]), 1.0) << m;  // squared sizes of the poles
    for (int i = 0; i < 785; ++i) {                                     // up to 12.2 kHz
      const double f = 5.0 * std::pow(1.01, i);
      const std::complex<double> d = std::polar(1.0, -2.0 * std::numbers::pi * f / kRate);
      const std::complex<double> h = c[m] * (1.0 - d * d) * (1.0 - d * d) /
                                     ((1.0 + c[lanes + m] * d + c[2 * lanes + m] * d * d) *
                                      (1.0 + c[3 * lanes + m] * d + c[4 * lanes + m] * d * d));
      const double w = std::tan(std::numbers::pi * f / kRate);
      const double u = (w * w - low[m] * high[m]) / (w * (high[m] - low[m]));
      EXPECT_NEAR(std::norm(h), 1.0 / (1.0 + std::pow(u, 4)), 1e-8) << "band " << m << " at " << f;
    }
  }
}

}  // namespace
}  // namespace stillcut::dsp::kernels
