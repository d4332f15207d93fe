// The kernels of taps and lines: every instruction set against the baseline, bit by bit, and the baseline against plain
// sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tests/unit/dsp/every_set.h"

namespace stillcut::dsp::kernels {
namespace {

TEST(Kernels, SumsAndStepsOfAdaptiveFiltersAreThoseWrittenOut) {
  for (const std::size_t taps : {1U, 8U, 16U, 35U, 40U, 512U}) {
    const std::size_t n = wholeLanes(taps);
    const Values a = noise(n, 1);
    const Values b = noise(n, 2);
    const Values all = sameWithEverySet([&](const Kernels& k) {
      Values out = a;
      k.tapSteer(out.data(), 0.99, -0.3, b.data(), taps);
      out.push_back(k.tapSum(a.data(), b.data(), n));
      return out;
    });
    const Values split = sameWithEverySet([&](const Kernels& k) {
      Values older = b;
      older[0] = 1e300;  // the newest is given apart
      Values out = a;
      k.newTapSteer(out.data(), 0.99, -0.3, b[0], &older[1], taps);
      out.push_back(k.newTapSum(a.data(), b[0], &older[1], n));
      return out;
    });
    for (std::size_t k = 0; k <= n; ++k) EXPECT_NEAR(split[k], all[k], 1e-12) << k;
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(all[k], k < taps ? 0.99 * a[k] - 0.3 * b[k] : 0.0, 1e-15) << k;
      sum += a[k] * b[k];
    }
    EXPECT_NEAR(all[n], sum, 1e-12) << n;
  }
}

TEST(Kernels, APairOfSignalsGoesThroughOneRecursiveFilter) {
  constexpr std::size_t kSamples = 100;
  for (const std::size_t taps : {8U, 40U, 512U}) {
    Values a = noise(taps, 1), b = noise(taps, 2);
    for (double& v : b) v /= static_cast<double>(8 * taps);  // stable
    const std::array<Values, 2> in{noise(kSamples, 3), noise(kSamples, 4)};
    const Values all = sameWithEverySet([&](const Kernels& k) {
      std::array<Values, 2> states;
      PairRun run{.forward = a.data(), .backward = b.data(), .taps = taps};
      for (std::size_t i = 0; i < 2; ++i) {
        states[i].assign(taps + kLanes, 0.0);
        run.state[i] = states[i].data();
      }
      Values out;
      for (std::size_t n = 0; n < kSamples; ++n) {
        run.in[0] = in[0][n], run.in[1] = in[1][n];
        k.filterPair(run);
        out.insert(out.end(), {run.out[0], run.out[1]});
      }
      return out;
    });
    // The equation written out: r(n + 1) = sum a_k x(n - k) + sum b_k r(n - k).
    for (std::size_t i = 0; i < 2; ++i) {
      Values r;
      for (std::size_t n = 0; n < kSamples; ++n) {
        double sum = 0.0;
        for (std::size_t t = 0; t < std::min(taps, n + 1); ++t) sum += a[t] * in[i][n - t];
        for (std::size_t t = 0; t < std::min(taps, n); ++t) sum += b[t] * r[n - 1 - t];
        r.push_back(sum);
        ASSERT_NEAR(all[2 * n + i], sum, 1e-10) << taps << " " << n;
      }
    }
  }
}

TEST(Kernels, LinesAreHeardAsTheirFourierSums) {
  constexpr std::size_t kFrames = 100, kLines = 16;
  const Values x = noise(kFrames, 1), y = noise(kFrames, 2);
  const Values all = sameWithEverySet([&](const Kernels& k) {
    Values re(kLines, 1.0), im(kLines, 0.0), rotationRe, rotationIm;
    for (std::size_t l = 0; l < kLines; ++l) {
      rotationRe.push_back(std::cos(0.1 * static_cast<double>(l)));
      rotationIm.push_back(std::sin(0.1 * static_cast<double>(l)));
    }
    Values sums(4 * kLines, 0.0);
    k.lineSums({x.data(), y.data(), kFrames, kLines, re.data(), im.data(), rotationRe.data(), rotationIm.data(),
                sums.data(), &sums[kLines], &sums[2 * kLines], &sums[3 * kLines]});
    return sums;
  });
  for (std::size_t l = 0; l < kLines; ++l) {
    double re = 0.0, im = 0.0;
    for (std::size_t n = 0; n < kFrames; ++n) {
      re += x[n] * std::cos(0.1 * static_cast<double>(l * n));
      im += y[n] * std::sin(0.1 * static_cast<double>(l * n));
    }
    EXPECT_NEAR(all[l], re, 1e-10);
    EXPECT_NEAR(all[3 * kLines + l], im, 1e-10);
  }
}

TEST(Kernels, ALineUnderAWindowIsHeardAsItsFourierSum) {
  constexpr double kLine = 0.37;
  for (const std::size_t frames : {1UL, 7UL, 8UL, 181UL}) {
    const Values x = noise(frames, 3);
    const double slow = 2.0 * std::numbers::pi / static_cast<double>(frames);
    const Values found = sameWithEverySet([&](const Kernels& k) {
      HannRun run{x.data(), frames, std::cos(kLine), -std::sin(kLine), std::cos(slow), std::sin(slow)};
      k.demodulate(run);
      return Values{run.re, run.im};
    });
    double re = 0.0, im = 0.0;
    for (std::size_t n = 0; n < frames; ++n) {
      const double y = x[n] * (0.5 - 0.5 * std::cos(slow * static_cast<double>(n)));
      re += y * std::cos(kLine * static_cast<double>(n));
      im -= y * std::sin(kLine * static_cast<double>(n));
    }
    EXPECT_NEAR(found[0], re, 1e-10) << frames;
    EXPECT_NEAR(found[1], im, 1e-10) << frames;
  }
}

TEST(Kernels, WhatDoesNotRepeatIsThePlainSumHoweverTheFramesAreCut) {
  constexpr std::size_t kFrames = 61, kOne = 40, kTwo = 80, kPast = kTwo + kDelayTaps;
  const Values x = noise(kPast + kFrames, 11), one = noise(kDelayTaps, 12), two = noise(kDelayTaps, 13);
  const auto made = [&](const Kernels& k, std::size_t piece) {
    Values out(2 * kFrames);
    for (std::size_t f = 0; f < kFrames; f += piece) {
      const double* now = x.data() + kPast + f;
      k.turns({now, now - kOne, now - kTwo, one.data(), two.data(), std::min(piece, kFrames - f), &out[f],
               &out[kFrames + f]});
    }
    return out;
  };
  const Values whole = sameWithEverySet([&](const Kernels& k) { return made(k, kFrames); });
  for (const std::size_t piece : {1UL, 7UL, 8UL, 22UL}) {
    EXPECT_EQ(sameWithEverySet([&](const Kernels& k) { return made(k, piece); }), whole) << piece;
  }
  for (std::size_t f = 0; f < kFrames; ++f) {
    double first = 0.0, second = 0.0;
    for (std::size_t t = 0; t < kDelayTaps; ++t) {
      first += one[t] * x[kPast + f - kOne - t];
      second += two[t] * x[kPast + f - kTwo - t];
    }
    EXPECT_NEAR(whole[f], (x[kPast + f] - 2.0 * first + second) / std::sqrt(6.0), 1e-12);
    EXPECT_NEAR(whole[kFrames + f], (x[kPast + f] - 0.5 * (first + second)) / std::sqrt(1.5), 1e-12);
  }
}

}  // namespace
}  // namespace stillcut::dsp::kernels
