// What identification is made of: mean forces over whole turns, poles of a response whose modes are known, units.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "core/milling/identify/frf.h"
#include "core/milling/identify/import/unit_label.h"
#include "core/milling/identify/lscf.h"
#include "core/milling/identify/mean_force.h"

namespace stillcut::identify {
namespace {

using Complex = std::complex<double>;

struct KnownMode {
  double frequency, damping, stiffness;
};

ModalLines linesOf(const std::vector<KnownMode>& modes, double from, double to, double noise = 0.0) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  ModalLines lines;
  lines.from = from;
  lines.to = to;
  const auto count = static_cast<Eigen::Index>(to - from) + 1;
  lines.frequency.resize(count);
  lines.value.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double f = from + static_cast<double>(i);
    Complex h = 0.0;
    for (const KnownMode& m : modes) {
      const double r = f / m.frequency;
      h += 1.0 / (m.stiffness * Complex(1.0 - r * r, 2.0 * m.damping * r));
    }
    lines.frequency[i] = f;
    lines.value[i] = h * (1.0 + noise * Complex(normal(random), normal(random)));
  }
  return lines;
}

const StablePole* nearest(const std::vector<StablePole>& poles, double frequency) {
  const auto it = std::min_element(poles.begin(), poles.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.pole.frequency - frequency) < std::abs(b.pole.frequency - frequency);
  });
  return it == poles.end() ? nullptr : &*it;
}

TEST(Lscf, FindsEveryPoleOfAKnownResponse) {
  const std::vector<KnownMode> modes{{950.0, 0.02, 3e6}, {1180.0, 0.008, 2e7}, {1800.0, 0.03, 8e6}};
  const auto poles = stablePoles(lscfPoles(linesOf(modes, 500.0, 2400.0), 20));
  for (const KnownMode& m : modes) {
    const StablePole* pole = nearest(poles, m.frequency);
    ASSERT_NE(pole, nullptr);
    EXPECT_NEAR(pole->pole.frequency / m.frequency, 1.0, 1e-4) << m.frequency;
    EXPECT_NEAR(pole->pole.damping / m.damping, 1.0, 1e-2) << m.frequency;
    EXPECT_GE(pole->seen, 5) << m.frequency;
  }
}

TEST(Lscf, PolesStandThroughNoise) {
  const std::vector<KnownMode> modes{{950.0, 0.02, 3e6}, {1800.0, 0.03, 8e6}};
  const auto poles = stablePoles(lscfPoles(linesOf(modes, 500.0, 2400.0, 0.02), 24));
  ASSERT_GE(poles.size(), 2U);
  for (const KnownMode& m : modes) {
    const StablePole* pole = nearest(poles, m.frequency);
    EXPECT_NEAR(pole->pole.frequency / m.frequency, 1.0, 3e-3) << m.frequency;
    EXPECT_NEAR(pole->pole.damping / m.damping, 1.0, 0.15) << m.frequency;
  }
}

TEST(Lscf, TwoModesCloseTogetherAreTwo) {
  const std::vector<KnownMode> modes{{1000.0, 0.01, 5e6}, {1030.0, 0.012, 6e6}};
  const auto poles = stablePoles(lscfPoles(linesOf(modes, 700.0, 1400.0), 16));
  for (const KnownMode& m : modes) EXPECT_NEAR(nearest(poles, m.frequency)->pole.frequency, m.frequency, 0.5);
}

TEST(Lscf, EveryPoleIsPhysical) {
  for (const auto& order : lscfPoles(linesOf({{950.0, 0.02, 3e6}}, 500.0, 1500.0, 0.1), 30)) {
    for (const ModalPole& pole : order) {
      EXPECT_GT(pole.damping, 0.0);
      EXPECT_LT(pole.damping, 0.3);
    }
  }
}

// Tracks: a pole goes on within 1 % and 10 %, and the most seen comes first.
TEST(StablePoles, ATrackGoesOnWhileItStaysPut) {
  std::vector<std::vector<ModalPole>> byOrder;
  byOrder.reserve(10);
  for (int i = 0; i < 10; ++i) {
    byOrder.push_back({{1000.0 + i, 0.02}, {i % 2 == 0 ? 500.0 : 700.0, 0.05}});
  }
  const auto poles = stablePoles(byOrder);
  ASSERT_FALSE(poles.empty());
  EXPECT_EQ(poles.front().seen, 10);
  EXPECT_NEAR(poles.front().pole.frequency, 1004.5, 1.0);
  for (std::size_t i = 1; i < poles.size(); ++i) EXPECT_LE(poles[i].seen, poles[i - 1].seen);
  EXPECT_TRUE(stablePoles({}).empty());
}

TEST(Compliance, IsTheResponseDividedByIOmega) {
  Frf frf;
  frf.frequency = {0.0, 10.0, 100.0};
  frf.value = {{1.0, 0.0}, {2.0, -1.0}, {0.5, 3.0}};
  frf.quantity = FrfQuantity::Accelerance;
  const Frf compliance = toCompliance(frf);
  EXPECT_EQ(compliance.quantity, FrfQuantity::Compliance);
  ASSERT_EQ(compliance.frequency.size(), 2U);  // 0 Hz is gone
  for (std::size_t i = 0; i < 2; ++i) {
    const Complex omega(0.0, 2.0 * M_PI * compliance.frequency[i]);
    EXPECT_LT(std::abs(compliance.value[i] * omega * omega - frf.value[i + 1]), 1e-12);
  }
  frf.quantity = FrfQuantity::Mobility;
  EXPECT_LT(std::abs(toCompliance(frf).value[1] * Complex(0.0, 2.0 * M_PI * 100.0) - frf.value[2]), 1e-12);
}

// Forces that repeat every turn, with a drift and noise if wanted.
class MeanForces : public testing::Test {
 protected:
  void make(double turns, double noise, double drift = 0.0) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0.0, noise > 0.0 ? noise : 1.0);
    const auto n = static_cast<std::size_t>(turns * kRate / 100.0);
    for (std::size_t c = 0; c < 3; ++c) {
      force_[c].resize(n);
      for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * M_PI * 100.0 * static_cast<double>(i) / kRate;
        force_[c][i] = 50.0 * static_cast<double>(c + 1) + 200.0 * std::sin(angle) + 80.0 * std::cos(3.0 * angle) +
                       drift * static_cast<double>(i) / static_cast<double>(n) + (noise > 0.0 ? normal(random) : 0.0);
      }
    }
  }
  Result<MeanForce> mean(double rate = kRate, Rpm speed = Rpm(6000.0)) const {
    return meanOverRevolutions({force_[0], force_[1], force_[2]}, rate, speed, 1e-4, "f.csv");
  }
  static constexpr double kRate = 10000.0;
  std::array<std::vector<double>, 3> force_;
};

TEST_F(MeanForces, AreThoseOfWholeTurnsHoweverTheRecordEnds) {
  for (double turns : {2.0, 2.5, 7.3, 50.99}) {
    make(turns, 0.0);
    const auto got = mean();
    ASSERT_TRUE(got.ok()) << got.error().line();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got->mean[c], 50.0 * static_cast<double>(c + 1), 1e-6) << turns;
    EXPECT_EQ(got->feedPerTooth, 1e-4);
  }
}

TEST_F(MeanForces, KnowHowWellTheyAreKnown) {
  make(400.0, 30.0);
  const auto noisy = mean();
  ASSERT_TRUE(noisy.ok());
  // 100 samples a turn, 400 turns: 30 / sqrt(40000).
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(noisy->standardError[c], 0.15, 0.05);
    EXPECT_LT(std::abs(noisy->mean[c] - 50.0 * static_cast<double>(c + 1)), 5.0 * noisy->standardError[c]);
  }
  make(400.0, 30.0, 60.0);
  EXPECT_GT(mean()->standardError[0], 2.0 * noisy->standardError[0]);  // a drift is no scatter
}

TEST_F(MeanForces, RefuseWhatCannotBe) {
  make(1.5, 0.0);
  EXPECT_FALSE(mean().ok());
  make(10.0, 0.0);
  EXPECT_FALSE(mean(0.0).ok());
  EXPECT_FALSE(mean(kRate, Rpm(0.0)).ok());
  EXPECT_FALSE(mean(kRate, Rpm(std::nan(""))).ok());
  force_[1].pop_back();
  EXPECT_FALSE(mean().ok());
  make(10.0, 0.0);
  force_[2][37] = std::nan("");
  const auto got = mean();
  ASSERT_FALSE(got.ok());
  EXPECT_EQ(got.error().line().rfind("f.csv", 0), 0U) << got.error().line();
}

TEST(UnitLabels, OfResponsesForcesAndTheirRatios) {
  EXPECT_EQ(responseUnit("mm")->factor, 1e-3);
  EXPECT_EQ(responseUnit("m/s")->quantity, FrfQuantity::Mobility);
  EXPECT_NEAR(responseUnit("g")->factor, 9.80665, 1e-12);
  EXPECT_EQ(responseUnit("(m/s^2)")->quantity, FrfQuantity::Accelerance);
  EXPECT_EQ(forceUnit("kN"), 1e3);
  EXPECT_NEAR(forceUnit("lbf").value(), 0.45359237 * 9.80665, 1e-9);
  const auto frf = frfUnit("g/lbf");
  ASSERT_TRUE(frf.has_value());
  EXPECT_EQ(frf->quantity, FrfQuantity::Accelerance);
  EXPECT_NEAR(frf->factor, 9.80665 / 4.4482216152605, 1e-9);
  EXPECT_EQ(frfUnit("m/N")->factor, 1.0);
  EXPECT_EQ(frfUnit("(m/s^2)/N")->quantity, FrfQuantity::Accelerance);
  for (const char* bad : {"", "furlong", "N", "m/m", "/N"}) EXPECT_FALSE(frfUnit(bad).has_value()) << bad;
}

}  // namespace
}  // namespace stillcut::identify
