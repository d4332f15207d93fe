#include "core/milling/identify/coefficients.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/milling/identify/import/file_bytes.h"
#include "core/milling/identify/import/number_table.h"

namespace stillcut::identify {
namespace {

using milling::Engagement;
using milling::MillingDirection;

CuttingCoefficients truth() {
  CuttingCoefficients k;
  k.tangential.value = 700e6;
  k.radial.value = 250e6;
  k.axial.value = 150e6;
  k.tangentialEdge.value = 14e3;
  k.radialEdge.value = 11e3;
  k.axialEdge.value = 3e3;
  return k;
}

// Force on the tool at one instant, straight teeth: the physics of cut_model.h, without any formula for means.
std::array<double, 3> instantForce(const CuttingCoefficients& k, int teeth, double depth, const Engagement& e,
                                   double feed, double spindle, double runout) {
  std::array<double, 3> sum{};
  for (int j = 0; j < teeth; ++j) {
    const double phi = std::fmod(spindle + j * kTwoPi / teeth, kTwoPi);
    if (phi < e.startAngle() || phi > e.exitAngle()) continue;
    // Runout takes from one tooth what it gives to the next; small enough that all teeth cut.
    const double h = feed * std::sin(phi) + (j % 2 == 0 ? runout : -runout);
    const double ft = depth * (k.tangential.value * h + k.tangentialEdge.value);
    const double fr = depth * (k.radial.value * h + k.radialEdge.value);
    sum[0] += -ft * std::cos(phi) - fr * std::sin(phi);
    sum[1] += ft * std::sin(phi) - fr * std::cos(phi);
    sum[2] += depth * (k.axial.value * h + k.axialEdge.value);
  }
  return sum;
}

ForceTest testOf(const Engagement& engagement, const std::vector<double>& feeds, double runout = 0.0) {
  ForceTest test;
  test.source = "synthetic";
  test.teeth = 2;
  test.depth = 3e-3;
  test.engagement = engagement;
  for (const double feed : feeds) {
    MeanForce m;
    m.feedPerTooth = feed;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
      const auto f = instantForce(truth(), 2, 3e-3, engagement, feed, kTwoPi * (i + 0.5) / kSteps, runout);
      for (std::size_t a = 0; a < 3; ++a) m.mean[a] += f[a] / kSteps;
    }
    test.means.push_back(m);
  }
  return test;
}

void expectTruth(const Result<CuttingCoefficients>& got, double relative) {
  ASSERT_TRUE(got.ok()) << got.error().line();
  const CuttingCoefficients k = truth();
  EXPECT_NEAR(got->tangential.value, k.tangential.value, relative * k.tangential.value);
  EXPECT_NEAR(got->radial.value, k.radial.value, relative * k.tangential.value);
  EXPECT_NEAR(got->axial.value, k.axial.value, relative * k.tangential.value);
  EXPECT_NEAR(got->tangentialEdge.value, k.tangentialEdge.value, relative * k.tangentialEdge.value);
  EXPECT_NEAR(got->radialEdge.value, k.radialEdge.value, relative * k.tangentialEdge.value);
  EXPECT_NEAR(got->axialEdge.value, k.axialEdge.value, relative * k.tangentialEdge.value);
}

TEST(Coefficients, IntegratedForcesGiveThemBackForEveryImmersion) {
  for (const double immersion : {1.0, 0.7, 0.5, 0.2, 0.05}) {
    for (const MillingDirection side : {MillingDirection::Up, MillingDirection::Down}) {
      ForceTest test = testOf({immersion, side}, {0.03e-3, 0.09e-3, 0.15e-3}, 1e-6);
      test.axes.signs = {1, 1, 1};
      // Midpoint sums over an entry and exit that fall between steps: parts in 1e4 at the smallest immersion.
      expectTruth(identifyCoefficients(test), 1e-3);
    }
  }
}

TEST(Coefficients, SignsAreFoundInASlotHoweverTheSensorLies) {
  const ForceTest onTool = testOf({1.0, MillingDirection::Up}, {0.05e-3, 0.1e-3});
  for (int bits = 0; bits < 8; ++bits) {
    const std::array<int, 3> signs{bits & 1 ? -1 : 1, bits & 2 ? -1 : 1, bits & 4 ? -1 : 1};
    ForceTest test = onTool;
    for (MeanForce& m : test.means) {
      for (std::size_t a = 0; a < 3; ++a) m.mean[a] *= signs[a];
    }
    const auto got = identifyCoefficients(test);
    expectTruth(got, 1e-4);
    EXPECT_EQ(got->signs, signs);
    for (MeanForce& m : test.means) std::swap(m.mean[0], m.mean[1]);
    test.axes.feed = FeedAxis::Y;
    expectTruth(identifyCoefficients(test), 1e-4);
  }
}

TEST(Coefficients, WrongSignsAreNotSilentlyUsed) {
  ForceTest test = testOf({1.0, MillingDirection::Up}, {0.05e-3, 0.1e-3});
  test.axes.signs = {1, -1, 1};
  const auto got = identifyCoefficients(test);
  ASSERT_FALSE(got.ok());
  EXPECT_NE(got.error().line().find("signs"), std::string::npos);
}

TEST(Coefficients, DeviationsMatchTheScatterOfRepeatedTests) {
  const ForceTest clean = testOf({1.0, MillingDirection::Up}, {0.03e-3, 0.06e-3, 0.09e-3, 0.12e-3});
  std::mt19937 random(11);
  std::normal_distribution<double> gauss(0.0, 2.0);
  double sum = 0.0, square = 0.0, stated = 0.0;
  constexpr int kTrials = 400;
  for (int t = 0; t < kTrials; ++t) {
    ForceTest test = clean;
    test.axes.signs = {1, 1, 1};
    for (MeanForce& m : test.means) {
      m.standardError = {2.0, 2.0, 2.0};
      for (double& f : m.mean) f += gauss(random);
    }
    const auto got = identifyCoefficients(test);
    ASSERT_TRUE(got.ok());
    sum += got->tangential.value;
    square += got->tangential.value * got->tangential.value;
    stated += got->tangential.deviation / kTrials;
  }
  const double mean = sum / kTrials;
  const double seen = std::sqrt(square / kTrials - mean * mean);
  EXPECT_NEAR(mean, 700e6, 4.0 * seen / std::sqrt(kTrials));
  EXPECT_GT(stated, 0.95 * seen);  // widened by poor lines, never narrowed
  EXPECT_LT(stated, 1.5 * seen);
}

TEST(Coefficients, TwoFeedsAreTheLeast) {
  ForceTest test = testOf({1.0, MillingDirection::Up}, {0.05e-3, 0.1e-3});
  const auto two = identifyCoefficients(test);
  ASSERT_TRUE(two.ok());
  EXPECT_EQ(two->feeds, 2);
  EXPECT_EQ(two->tangential.deviation, 0.0);  // no errors given, no third feed: nothing to tell it from
  test.means[1].feedPerTooth = test.means[0].feedPerTooth;
  EXPECT_FALSE(identifyCoefficients(test).ok());
  test.means.pop_back();
  EXPECT_FALSE(identifyCoefficients(test).ok());
  test.means.clear();
  EXPECT_FALSE(identifyCoefficients(test).ok());
}

TEST(Coefficients, NonsenseIsRefused) {
  const ForceTest good = testOf({1.0, MillingDirection::Up}, {0.05e-3, 0.1e-3});
  ForceTest bad = good;
  bad.teeth = 0;
  EXPECT_FALSE(identifyCoefficients(bad).ok());
  bad = good;
  bad.depth = 0.0;
  EXPECT_FALSE(identifyCoefficients(bad).ok());
  bad = good;
  bad.engagement.radialImmersion = 1.5;
  EXPECT_FALSE(identifyCoefficients(bad).ok());
  bad = good;
  bad.means[0].mean[1] = NAN;
  EXPECT_FALSE(identifyCoefficients(bad).ok());
  bad = good;
  bad.means[0].feedPerTooth = -1e-4;
  EXPECT_FALSE(identifyCoefficients(bad).ok());
  bad = good;
  bad.axes.signs = {0, 1, 1};
  EXPECT_FALSE(identifyCoefficients(bad).ok());
}

std::array<std::span<const double>, 3> thrice(const std::vector<double>& v) {
  return {v, v, v};
}

TEST(MeanForce, WholeRevolutionsOnly) {
  // 10.5 turns of a wave: its mean over 10 is its offset.
  std::vector<double> v;
  v.reserve(1050);
  for (int i = 0; i < 1050; ++i) v.push_back(5.0 + 100.0 * std::sin(kTwoPi * i / 100.0 + 0.3));
  const auto m = meanOverRevolutions(thrice(v), 10000.0, Rpm(6000.0), 1e-4, "t");
  ASSERT_TRUE(m.ok()) << m.error().line();
  EXPECT_NEAR(m->mean[0], 5.0, 1e-9);
  EXPECT_NEAR(m->standardError[0], 0.0, 1e-9);
  EXPECT_EQ(m->feedPerTooth, 1e-4);
}

TEST(MeanForce, StandardErrorOfNoiseAndOfDrift) {
  std::mt19937 random(5);
  std::normal_distribution<double> gauss(0.0, 10.0);
  std::vector<double> v;
  v.reserve(100 * 200);
  for (int i = 0; i < 100 * 200; ++i) v.push_back(gauss(random));
  const auto noise = meanOverRevolutions(thrice(v), 10000.0, Rpm(6000.0), 1e-4, "t");
  ASSERT_TRUE(noise.ok());
  EXPECT_NEAR(noise->standardError[0], 10.0 / std::sqrt(20000.0), 0.02);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += 1e-3 * static_cast<double>(i);
  const auto drift = meanOverRevolutions(thrice(v), 10000.0, Rpm(6000.0), 1e-4, "t");
  EXPECT_GT(drift->standardError[0], 3.0 * 20.0 / std::sqrt(12.0) / std::sqrt(200.0));
}

TEST(MeanForce, NonsenseIsRefused) {
  std::vector<double> v(1000, 1.0);
  EXPECT_FALSE(meanOverRevolutions(thrice(v), 0.0, Rpm(6000), 1e-4, "t").ok());
  EXPECT_FALSE(meanOverRevolutions(thrice(v), 10000.0, Rpm(0), 1e-4, "t").ok());
  EXPECT_FALSE(meanOverRevolutions(thrice(v), 10000.0, Rpm(600), 1e-4, "t").ok());     // one turn
  EXPECT_FALSE(meanOverRevolutions(thrice(v), 10000.0, Rpm(300000), 1e-4, "t").ok());  // 2 samples a turn
  std::vector<double> shorter(999, 1.0);
  EXPECT_FALSE(meanOverRevolutions({v, v, shorter}, 10000.0, Rpm(6000), 1e-4, "t").ok());
  v[500] = INFINITY;
  EXPECT_FALSE(meanOverRevolutions(thrice(v), 10000.0, Rpm(6000), 1e-4, "t").ok());
}

class SlotForce : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << "reference recordings absent: " << folder_;
  }
  // Columns of a DynoWare export: 20 lines of header, then time and three forces.
  MeanForce meanOf(const std::string& name, double feedMmPerMin) const {
    const auto bytes = readFileBytes(folder_ + name);
    EXPECT_TRUE(bytes.ok());
    const auto table = parseNumberTable(*bytes, name, 4);
    EXPECT_TRUE(table.ok()) << table.error().line();
    const auto& c = table->columns;
    const auto m = meanOverRevolutions({c[1].real, c[2].real, c[3].real}, 10000.0, Rpm(6000),
                                       feedMmPerMin / 6000.0 / 2.0 * 1e-3, name);
    EXPECT_TRUE(m.ok()) << m.error().line();
    return *m;
  }
  std::string folder_ = STILLCUT_SHARED_DIR "/recordings/slot_force/";
};

TEST_F(SlotForce, MeansAndCoefficients) {
  ForceTest test;
  test.source = "slot_force";
  test.teeth = 2;
  test.depth = 3e-3;
  test.means = {meanOf("6-n6000f300ap3ae25.csv", 300), meanOf("6-n6000f900ap3ae25.csv", 900)};
  const std::array<std::array<double, 3>, 2> stated = {{{63.0, -39.8, 55.7}, {137.7, -71.6, 82.6}}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_NEAR(test.means[i].mean[a], stated[i][a], 0.1);
      EXPECT_GT(test.means[i].standardError[a], 0.0);
    }
  }
  const auto k = identifyCoefficients(test);
  ASSERT_TRUE(k.ok()) << k.error().line();
  // By hand from the stated means, 0.025 and 0.075 mm per tooth, Z a_p = 6 mm: slope 4/(Z a_p), edge pi/(Z a_p).
  EXPECT_NEAR(k->tangential.value, 4.0 / 6e-3 * 31.8 / 0.05e-3, 3e6);
  EXPECT_NEAR(k->radial.value, 4.0 / 6e-3 * 74.7 / 0.05e-3, 3e6);
  EXPECT_NEAR(k->axial.value, M_PI / 6e-3 * 26.9 / 0.05e-3, 3e6);
  EXPECT_NEAR(k->tangentialEdge.value, M_PI / 6e-3 * (39.8 - 15.9), 100.0);
  EXPECT_NEAR(k->radialEdge.value, M_PI / 6e-3 * (63.0 - 37.35), 100.0);
  EXPECT_NEAR(k->axialEdge.value, 2.0 / 6e-3 * (55.7 - 13.45), 100.0);
  EXPECT_GT(k->tangential.deviation, 0.0);
  EXPECT_LT(k->tangential.deviation, 0.2 * k->tangential.value);
  EXPECT_EQ(k->signs, (std::array<int, 3>{-1, -1, 1}));  // the force on the workpiece, as a dynamometer gives it
}

}  // namespace
}  // namespace stillcut::identify
