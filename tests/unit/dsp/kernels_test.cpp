// Every instruction set against the baseline, bit by bit, and the baseline against plain sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tests/unit/dsp/every_set.h"

namespace stillcut::dsp::kernels {
namespace {

struct Harmonics {
  explicit Harmonics(std::size_t lanes) : re(lanes), im(lanes), c(lanes), s(lanes) {}
  Values re, im, c, s;
};

TEST(Kernels, HarmonicsAreTheRecursionWrittenOut) {
  constexpr double kStep = 0.0317;
  constexpr double kGain = 0.004;
  for (const std::size_t count : {1U, 8U, 12U, 32U, 53U}) {
    const Values x = noise(777, 1);
    const std::size_t lanes = wholeLanes(count);
    const Values residual = sameWithEverySet([&](const Kernels& k) {
      Harmonics h(lanes);
      k.powers(std::cos(kStep), std::sin(kStep), count, h.c.data(), h.s.data());
      Values out(x.size());
      k.harmonics({x.data(), out.data(), 500, lanes, h.re.data(), h.im.data(), h.c.data(), h.s.data(), kGain, 0.9});
      k.harmonics(
          {x.data() + 500, out.data() + 500, 277, lanes, h.re.data(), h.im.data(), h.c.data(), h.s.data(), kGain, 0.9});
      out.push_back(k.weightedPower(h.re.data(), h.im.data(), h.c.data(), lanes));
      return out;
    });
    std::vector<std::complex<double>> q(count);
    for (std::size_t k = 0; k < x.size(); ++k) {
      double e = x[k];
      for (const auto& v : q) e -= v.real();
      for (std::size_t n = 0; n < count; ++n) {
        q[n] = (q[n] + kGain * e) * std::polar(1.0, kStep * static_cast<double>(n + 1));
      }
      ASSERT_NEAR(residual[k], 0.9 * e, 1e-11) << k << " of " << count;
    }
    double power = 0.0;
    for (std::size_t n = 0; n < count; ++n) power += std::cos(kStep * static_cast<double>(n + 1)) * std::norm(q[n]);
    EXPECT_NEAR(residual.back(), power, 1e-11);
  }
}

TEST(Kernels, TwoSignalsSideBySideAreEachOfThemAlone) {
  for (const std::size_t count : {5U, 24U, 48U, 53U}) {
    const std::size_t lanes = wholeLanes(count);
    const Values x[2] = {noise(301, 7), noise(301, 8)};
    const auto both = [&](const Kernels& k, bool paired) {
      Harmonics h[2] = {Harmonics(lanes), Harmonics(lanes)};
      k.powers(std::cos(0.03), std::sin(0.03), count, h[0].c.data(), h[0].s.data());
      Values out(2 * x[0].size());
      HarmonicRun runs[2];
      for (std::size_t n = 0; n < 2; ++n) {
        runs[n] = {x[n].data(),    out.data() + n * x[n].size(),
                   x[n].size(),    lanes,
                   h[n].re.data(), h[n].im.data(),
                   h[0].c.data(),  h[0].s.data(),
                   0.004,          0.9};
      }
      if (paired) {
        k.harmonicPair(runs[0], runs[1]);
      } else {
        for (const HarmonicRun& run : runs) k.harmonics(run);
      }
      for (const Harmonics& state : h) out.insert(out.end(), state.im.begin(), state.im.end());
      return out;
    };
    EXPECT_EQ(sameWithEverySet([&](const Kernels& k) { return both(k, true); }),
              sameWithEverySet([&](const Kernels& k) { return both(k, false); }));
  }
}

TEST(Kernels, ARealTransformIsUnfoldedAlikeByEverySet) {
  // That it is the right one: tests/unit/dsp/transform_test.cpp.
  for (const std::size_t n : {1U, 2U, 9U, 15U, 16U, 64U, 105U}) {
    const Values folded = noise(2 * n, 10);
    Values re, im;
    for (std::size_t k = 0; k <= n / 2 + kLanes; ++k) {
      const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      re.push_back(0.5 * std::cos(angle));
      im.push_back(-0.5 * std::sin(angle));
    }
    const Values all = sameWithEverySet([&](const Kernels& k) {
      Values out(2 * n + 2);
      k.unfold({folded.data(), re.data(), im.data(), n, out.data()});
      return out;
    });
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t m = (n - k) % n;
      const std::complex<double> z(folded[2 * k], folded[2 * k + 1]);
      const std::complex<double> mirror(folded[2 * m], -folded[2 * m + 1]);
      const std::complex<double> turn =
          std::polar(1.0, -std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
      const std::complex<double> x = 0.5 * (z + mirror) - std::complex<double>(0.0, 0.5) * turn * (z - mirror);
      EXPECT_NEAR(all[2 * k], x.real(), 1e-12) << n << " " << k;
      EXPECT_NEAR(all[2 * k + 1], x.imag(), 1e-12) << n << " " << k;
    }
  }
}

TEST(Kernels, TheLargestIsFoundWhereverItStands) {
  for (const std::size_t count : {1U, 7U, 8U, 100U}) {
    for (std::size_t place = 0; place < count; ++place) {
      Values x = noise(count, 9);
      x[place] = 100.0;
      EXPECT_EQ(sameWithEverySet([&](const Kernels& k) { return Values{k.largest(x.data(), count)}; })[0], 100.0);
    }
  }
}

TEST(Kernels, ParametricIsTheSameWithEverySet) {
  // Its equations are held to their oracle in tests/unit/detect/parametric_test.cpp.
  const Values x = noise(600, 4);
  const Values all = sameWithEverySet([&](const Kernels& k) {
    Harmonics h(32);
    k.powers(std::cos(0.05), std::sin(0.05), 29, h.c.data(), h.s.data());
    Values out(x.size());
    ArState ar;
    for (std::size_t i = 0; i < 4; ++i) ar.p[5 * i] = 1.0;
    Values sum(4);
    k.parametric({{x.data(), out.data(), x.size(), 32, h.re.data(), h.im.data(), h.c.data(), h.s.data(), 0.004, 1.0},
                  0.7,
                  3e-5,
                  8e-4,
                  &ar,
                  sum.data()});
    out.insert(out.end(), std::begin(ar.p), std::end(ar.p));
    out.insert(out.end(), sum.begin(), sum.end());
    return out;
  });
  for (const double v : all) EXPECT_TRUE(std::isfinite(v));
}

TEST(Kernels, CovarianceIsTheSameWithEverySet) {
  // Its equations are held to their oracle in tests/unit/detect/harmonic_kalman_test.cpp.
  constexpr std::size_t kWide = 16;
  constexpr std::size_t kFrames = 200;
  const Values x = noise(2 * kFrames, 6);
  const Values all = sameWithEverySet([&](const Kernels& k) {
    Values p(4 * kWide * kWide);
    for (std::size_t i = 0; i < 2 * kWide; ++i) p[i * 2 * kWide + i] = 1.0;
    Values ph(2 * kWide);
    Values h(2 * kWide);
    Values c(kWide);
    Values s(kWide);
    const Values drift(2 * kWide, 1e-5);
    Values states(4 * kWide);
    Values scratch(4 * kWide);
    Values residual(2 * kFrames);
    k.powers(std::cos(0.05), std::sin(0.05), kWide, c.data(), s.data());
    k.powers(std::cos(0.4), std::sin(0.4), kWide, h.data(), h.data() + kWide);
    const CovarianceRun run{x.data(), kFrames,  residual.data(), kFrames,       2,
                            kFrames,  kWide,    p.data(),        ph.data(),     h.data(),
                            c.data(), s.data(), drift.data(),    states.data(), scratch.data()};
    k.covarianceTimes(run);
    k.covariance(run);
    residual.insert(residual.end(), p.begin(), p.end());
    return residual;
  });
  for (const double v : all) EXPECT_TRUE(std::isfinite(v));
}

TEST(Kernels, SpectraAreTheSameWithEverySetAndCoherentWhereTheyShould) {
  constexpr std::size_t kBins = 137;
  const std::size_t lanes = wholeLanes(kBins);
  Values x = noise(2 * lanes, 7);
  const Values y = noise(2 * lanes, 8);
  x[2 * 40] = x[2 * 40 + 1] = 0.0;  // nothing there
  const Values all = sameWithEverySet([&](const Kernels& k) {
    Values rows(9 * lanes);
    const auto row = [&](std::size_t i) { return rows.data() + i * lanes; };
    k.squares(x.data(), row(0), kBins);
    k.maskHarmonics({10.0, 0.01, 1.5, 5, kBins - 2, lanes, row(1)});
    LineScan scan{row(0), row(1), y.data(), 5, kBins - 2};
    k.scanLines(scan);
    for (const double part : {1.0, 0.5}) {
      k.coherence({x.data(), y.data(), lanes, part, true, row(2), row(3), row(4), row(5), row(6), row(7)});
    }
    k.sharpen({row(6), y.data(), kBins, 0.5, 0.4, 0.6, 0.7, row(8)});
    CrossScan cross{row(7), row(6), row(1), 5, kBins - 3};
    k.scanCross(cross);
    for (const double v : {scan.sum, scan.freeSum, scan.forcedSum, scan.top, static_cast<double>(scan.place),
                           cross.freeSum, cross.largestRatio, cross.top, static_cast<double>(cross.place)}) {
      rows.push_back(v);
    }
    return rows;
  });
  double sum = 0.0;
  double top = 0.0;
  double place = 0.0;
  CrossScan plain;
  for (std::size_t b = 0; b < kBins; ++b) {
    const double power = x[2 * b] * x[2 * b] + x[2 * b + 1] * x[2 * b + 1];
    EXPECT_NEAR(all[b], power, 1e-12) << b;
    const double order = std::round(static_cast<double>(b) / 10.0);
    const bool beside = std::abs(static_cast<double>(b) - 10.0 * order) >= 1.5 + 0.01 * order;
    const bool free = beside && b >= 5 && b <= kBins - 2;
    EXPECT_EQ(all[lanes + b], free ? 1.0 : 0.0) << b;
    EXPECT_NEAR(all[6 * lanes + b], b == 40 ? 0.0 : 1.0, 1e-12) << b;  // the same segment twice
    if (b >= 5 && b <= kBins - 2) sum += power;
    if (free && all[b] >= all[b - 1] && all[b] >= all[b + 1] && all[b] > top) {
      top = all[b];
      place = static_cast<double>(b);
    }
    if (!free || b > kBins - 3) continue;
    const double ratio = all[6 * lanes + b];
    const double size = all[7 * lanes + b];
    plain.freeSum += size;
    plain.largestRatio = std::max(plain.largestRatio, ratio);
    if (size * ratio <= plain.top) continue;
    plain.top = size * ratio;
    plain.place = b;
  }
  EXPECT_NEAR(all[9 * lanes], sum, 1e-10);
  EXPECT_EQ(all[9 * lanes + 3], top);
  EXPECT_EQ(all[9 * lanes + 4], place);
  EXPECT_NEAR(all[9 * lanes + 5], plain.freeSum, 1e-10);
  EXPECT_EQ(all[9 * lanes + 6], plain.largestRatio);
  EXPECT_EQ(all[9 * lanes + 7], plain.top);
  EXPECT_EQ(all[9 * lanes + 8], static_cast<double>(plain.place));
}

TEST(Kernels, OperatorSumsAreTheOperatorWrittenOut) {
  const Values s = noise(600, 3);
  for (const std::size_t lag : {1U, 3U, 64U}) {
    for (const std::size_t frames : {1U, 7U, 8U, 29U, 256U}) {
      const Values sums = sameWithEverySet([&](const Kernels& k) {
        Values sum(2, 0.5);
        k.operatorSums({s.data() + 300, frames, lag, &sum[0], &sum[1]});
        return sum;
      });
      const auto psi = [lag](const auto& x, std::size_t k) { return x(k) * x(k) - x(k - lag) * x(k + lag); };
      const auto signal = [&](std::size_t k) { return s[k]; };
      const auto difference = [&](std::size_t k) { return s[k] - s[k - lag]; };
      double plain = 0.5;
      double plainDifference = 0.5;
      for (std::size_t k = 300; k < 300 + frames; ++k) {
        plain += psi(signal, k - 2 * lag);
        plainDifference += psi(difference, k - lag) + psi(difference, k - 2 * lag);
      }
      EXPECT_NEAR(sums[0], plain, 1e-10);
      EXPECT_NEAR(sums[1], plainDifference, 1e-10);
    }
  }
}

TEST(Kernels, SeparationGivesAmplitudeAndAngleAndKeepsWhatItCannotTell) {
  constexpr std::size_t kBands = 64;
  // Angles over the whole circle half, then bands that say nothing: no energy, cosine beyond 1, not a number.
  Values angles(kBands);
  for (std::size_t m = 0; m < kBands; ++m) {
    angles[m] = 0.05 + (std::numbers::pi - 0.1) * static_cast<double>(m) / (kBands - 1);
  }
  constexpr double kFrames = 20.0;
  constexpr double kPower = 9.0;
  constexpr std::size_t kSilent = 5;
  constexpr std::size_t kWild = 23;
  constexpr std::size_t kBroken = 40;
  const Values all = sameWithEverySet([&](const Kernels& k) {
    Values signal(kBands);
    Values difference(kBands);
    for (std::size_t m = 0; m < kBands; ++m) {
      signal[m] = kFrames * kPower * std::pow(std::sin(angles[m]), 2);
      difference[m] = 4.0 * signal[m] * (1.0 - std::cos(angles[m]));
    }
    signal[kSilent] = 0.0;
    difference[kWild] *= 10.0;
    signal[kWild] = 1.0;
    signal[kBroken] = std::numeric_limits<double>::quiet_NaN();
    const Values scale(kBands, 2.0);
    Values out(3 * kBands, 77.0);
    k.separate({signal.data(), difference.data(), kBands, kFrames, scale.data(), out.data(), out.data() + kBands,
                out.data() + 2 * kBands});
    for (const Values* v : {&signal, &difference}) EXPECT_EQ(*v, Values(kBands, 0.0));
    return out;
  });
  for (std::size_t m = 0; m < kBands; ++m) {
    const bool told = m != kSilent && m != kWild && m != kBroken;
    EXPECT_EQ(all[2 * kBands + m], told ? 1.0 : 0.0) << m;
    EXPECT_NEAR(all[m], told ? kPower : 77.0, 1e-9) << m;
    // 1 - cos loses digits where the angle is small.
    EXPECT_NEAR(all[kBands + m], told ? 2.0 * angles[m] : 77.0, 1e-12) << m;
  }
}

}  // namespace
}  // namespace stillcut::dsp::kernels
