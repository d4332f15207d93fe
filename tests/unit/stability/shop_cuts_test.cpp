// Cuts as shops make them: any engagement, helix, uneven pitch, process damping, many teeth; against the shared cases
// and against each other, for the two ways to get f share nothing but the force law.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "core/milling/stability/advice.h"
#include "core/milling/stability/any_tool/alike_teeth.h"
#include "core/milling/stability/any_tool/depth_search.h"
#include "core/milling/stability/any_tool/unlike_teeth.h"
#include "core/milling/stability/lobe_case.h"
#include "core/milling/stability/semi_discretization.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

std::filesystem::path sharedCase(const std::string& name) {
  return std::filesystem::path(STILLCUT_SHARED_DIR) / "cases_lobes" / name;
}

double limitMm(const CutModel& model, double rpm, double deepestMm) {
  const auto lobes = ExactLobes::make(model, "case");
  if (!lobes) return -1.0;
  LimitOptions options;
  options.maxAxialDepth = Metres(1e-3 * deepestMm);
  options.firstOnly = true;
  options.frequencies = false;
  const auto limits = lobes->limits(Rpm(rpm), options);
  return limits.ok() && limits->hasLimit() ? 1e3 * limits->crossings.front().depth.value : -1.0;
}

void expectLimits(const std::string& file, const std::vector<std::pair<double, double>>& limits) {
  if (!std::filesystem::exists(sharedCase(file))) GTEST_SKIP() << "the shared cases are not here";
  const auto cut = loadLobeCase(sharedCase(file).string());
  ASSERT_TRUE(cut.ok()) << cut.error().line();
  for (const auto& [rpm, mm] : limits) {
    EXPECT_NEAR(limitMm(cut->model, rpm, 1e3 * cut->maxAxialDepth.value), mm, 0.01 * mm) << file << " at " << rpm;
  }
}

TEST(ShopCuts, ACentredFaceMill) {
  expectLimits("centred_face_mill.toml", {{400, 2.43}, {700, 2.95}, {1000, 6.67}, {1300, 3.07}});
}

TEST(ShopCuts, AVariablePitch) {
  expectLimits("variable_pitch_aeb99.toml", {{3000, 3.91}, {4000, 1.79}, {5000, 6.21}, {6000, 3.17}, {8000, 4.87}});
}

TEST(ShopCuts, ASteepHelixAtLowImmersion) {
  expectLimits("hem_helix45_lobes.toml", {{18000, 2.39}});
}

TEST(ShopCuts, TitaniumAtLowSpeed) {
  expectLimits("sdm_lowspeed_ti.toml", {{300, 0.970}, {400, 0.797}});
}

TEST(ShopCuts, SixteenTeethAreAsSixteenTeethOfOnePitch) {
  if (!std::filesystem::exists(sharedCase("sixteen_teeth.toml"))) GTEST_SKIP() << "the shared cases are not here";
  const auto cut = loadLobeCase(sharedCase("sixteen_teeth.toml").string());
  ASSERT_TRUE(cut.ok());
  const auto sdm = SemiDiscretization::make(cut->model, {200, 1}, "16");
  for (double rpm : {150.0, 250.0}) {
    const double exact = limitMm(cut->model, rpm, 6.0);
    ASSERT_GT(exact, 0.0);
    EXPECT_EQ(sdm->outside(Rpm(rpm), Metres(0.98e-3 * exact)), 0) << rpm;
    EXPECT_GT(sdm->outside(Rpm(rpm), Metres(1.02e-3 * exact)).value_or(0), 0) << rpm;
  }
}

TEST(ShopCuts, ThePocketAtTwoMillimetres) {
  if (!std::filesystem::exists(sharedCase("pocket_edges_cut.toml"))) GTEST_SKIP() << "the shared cases are not here";
  const auto cut = loadLobeCase(sharedCase("pocket_edges_cut.toml").string());
  ASSERT_TRUE(cut.ok());
  AdviceRequest request;
  request.depth = Metres(2e-3);
  request.lowest = Rpm(5000);
  request.highest = Rpm(7000);
  request.steps = 8;  // few: the lobes themselves say how many it takes
  const auto advice = adviseSpeeds(cut->model, request, "pocket");
  ASSERT_TRUE(advice.ok());
  ASSERT_EQ(advice->pockets.size(), 1u);
  EXPECT_NEAR(advice->pockets[0].from.speed.value, 5821.0, 1.0);
  EXPECT_NEAR(advice->pockets[0].to.speed.value, 6150.0, 1.0);
  // Two lobes meet at 5975 rev/min and 2.954 mm, a little above what a coarser grid finds (5980, 2.914).
  EXPECT_NEAR(advice->pockets[0].best.value, 5975.0, 1.0);
  EXPECT_NEAR(limitMm(cut->model, 5980.0, 8.0), 2.914, 0.001);
  EXPECT_NEAR(1e3 * advice->pockets[0].limit.value, 2.954, 0.002);
}

CutModel randomTool(std::mt19937& random) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  CutModel model;
  const int modes = between(0.0, 1.0) < 0.3 ? 1 : 2;
  for (int i = 0; i < modes; ++i) {
    const double angle = between(0.0, kTwoPi);
    model.modes.push_back(
        {Hertz(between(300.0, 1200.0)), between(0.01, 0.05), between(5e6, 3e7), {std::cos(angle), std::sin(angle)}});
  }
  model.tool.teeth = static_cast<int>(between(1.0, 5.99));
  model.tool.diameter = Metres(between(8e-3, 20e-3));
  model.material.tangential = between(5e8, 2e9);
  model.material.radial = between(0.1, 0.7) * model.material.tangential;
  const double immersion = between(0.05, 0.9);
  model.engagement = {immersion, MillingDirection::Up, between(immersion - 1.0, 1.0 - immersion)};
  return model;
}

SpeedLimits search(const CircleFunction& f, Rpm speed, double deepest) {
  WorkMeter meter;
  LimitOptions options;
  options.maxAxialDepth = Metres(deepest);
  options.frequencies = false;
  return DepthSearch(f, speed, options, meter).run();
}

void expectSame(const SpeedLimits& a, const SpeedLimits& b, double tolerance, const std::string& what) {
  ASSERT_TRUE(a.verified && b.verified) << what;
  ASSERT_EQ(a.crossings.size(), b.crossings.size()) << what;
  for (std::size_t i = 0; i < a.crossings.size(); ++i) {
    const double depth = a.crossings[i].depth.value;
    EXPECT_NEAR(b.crossings[i].depth.value, depth, tolerance * depth) << what;
    EXPECT_EQ(b.crossings[i].after, a.crossings[i].after) << what;
    EXPECT_EQ(b.crossings[i].kind, a.crossings[i].kind) << what;
  }
}

// One tooth period for all, so that all three must say the same.
TEST(ShopCuts, TheMonodromyOfAnEvenPitchGivesTheExactLimits) {
  std::mt19937 random(5);
  for (int n = 0; n < 8; ++n) {
    const CutModel model = randomTool(random);
    const Rpm speed(std::uniform_real_distribution<double>(5000.0, 20000.0)(random));
    const auto lobes = ExactLobes::make(model, "even");
    const auto exact = lobes->limits(speed, {Metres(8e-3), false, false, {}});
    const std::string what = "cut " + std::to_string(n);
    expectSame(*exact, search(UnlikeTeeth(model, lobes->pattern(), speed), speed, 8e-3), 1e-6, what + " monodromy");
    expectSame(*exact, search(AlikeTeeth(model, speed), speed, 8e-3), 1e-6, what + " transition");
  }
}

// f of unlike teeth by their lines, which straight ones do not need.
class ByLines final : public CircleFunction {
 public:
  explicit ByLines(const UnlikeTeeth& teeth) : teeth_(teeth) {}
  int states() const override { return teeth_.states(); }
  bool sample(double depth, std::span<const double> angles, Fineness fineness, std::span<std::complex<double>> out,
              WorkMeter& meter) const override {
    return teeth_.sampleLines(depth, angles, fineness, out, meter);
  }
  Hertz chatterFrequency(double angle, double depth, WorkMeter& meter) const override {
    return teeth_.chatterFrequency(angle, depth, meter);
  }
  double growthAt(double depth) const override { return teeth_.growthAt(depth); }

 private:
  const UnlikeTeeth& teeth_;
};

CutModel unevenPitch(CutModel model, int teeth, std::mt19937& random) {
  model.tool.teeth = teeth;
  model.tool.pitch.clear();
  double whole = 0.0;
  for (int j = 0; j < teeth; ++j) {
    model.tool.pitch.push_back(std::uniform_real_distribution<double>(0.8, 1.2)(random));
    whole += model.tool.pitch.back();
  }
  for (double& pitch : model.tool.pitch) pitch *= kTwoPi / whole;
  return model;
}

// Nothing is shared by the two: one is made of stretches of time, the other of lines of frequency.
TEST(ShopCuts, OfUnevenStraightTeethOneMatrixAndTheLinesGiveTheSameLimits) {
  std::mt19937 random(23);
  for (int n = 0; n < 8; ++n) {
    const CutModel model = unevenPitch(randomTool(random), 2 + n % 4, random);
    const Rpm speed(std::uniform_real_distribution<double>(6000.0, 15000.0)(random));
    const UnlikeTeeth teeth(model, toothPattern(model.tool), speed);
    expectSame(search(teeth, speed, 5e-3), search(ByLines(teeth), speed, 5e-3), 2e-3, "cut " + std::to_string(n));
  }
}

// Where many waves fit into a revolution, and by lines every angle asks for a matrix of 250 rows.
TEST(ShopCuts, UnevenPitchAtLowSpeedIsLittleWork) {
  std::mt19937 random(5);
  const CutModel model = unevenPitch(textbookHalf(), 4, random);
  const auto lobes = ExactLobes::make(model, "uneven");
  ASSERT_TRUE(lobes.ok());
  LimitOptions options;
  options.maxAxialDepth = Metres(4e-3);
  options.firstOnly = true;
  options.frequencies = false;
  WorkMeter meter;
  const auto limits = lobes->limits(Rpm(2200.0), options, meter);
  ASSERT_TRUE(limits.ok());
  EXPECT_TRUE(limits->hasLimit());
  EXPECT_TRUE(limits->verified);
  EXPECT_LT(meter.total(), 4e9);
}

TEST(ShopCuts, HelixAndProcessDampingAgreeBetweenTimeAndHarmonics) {
  std::mt19937 random(17);
  for (int n = 0; n < 8; ++n) {
    CutModel model = randomTool(random);
    model.tool.helix = std::uniform_real_distribution<double>(-0.9, 0.9)(random);
    if (n % 2 == 1) model.material.processDamping = 2e5;
    const Rpm speed(std::uniform_real_distribution<double>(5000.0, 15000.0)(random));
    const auto harmonics = search(UnlikeTeeth(model, toothPattern(model.tool), speed), speed, 6e-3);
    expectSame(search(AlikeTeeth(model, speed), speed, 6e-3), harmonics, 2e-3, "cut " + std::to_string(n));
  }
}

TEST(ShopCuts, SemiDiscretizationWithHelixAndDampingConvergesToTheSame) {
  CutModel model = textbookHalf();
  model.tool.helix = 0.6;
  model.material.processDamping = 1e5;
  const auto sdm = SemiDiscretization::make(model, {200, 1}, "helix");
  for (double rpm : {4000.0, 9000.0}) {
    const double exact = limitMm(model, rpm, 8.0);
    ASSERT_GT(exact, 0.0);
    EXPECT_EQ(sdm->outside(Rpm(rpm), Metres(0.99e-3 * exact)), 0);
    EXPECT_GT(sdm->outside(Rpm(rpm), Metres(1.01e-3 * exact)).value_or(0), 0);
  }
}

TEST(ShopCuts, ProcessDampingRaisesTheLimitTheMoreTheSlowerTheSpeed) {
  CutModel damped = textbookHalf();
  damped.material.processDamping = 3e4;
  const auto gain = [&](double rpm) { return limitMm(damped, rpm, 20.0) / limitMm(textbookHalf(), rpm, 20.0); };
  EXPECT_GT(gain(1500.0), gain(4000.0));
  EXPECT_GT(gain(4000.0), gain(12000.0));
  EXPECT_GT(gain(12000.0), 1.0);
  EXPECT_LT(gain(12000.0), 1.2);
}

TEST(ShopCuts, EdgesThatMeetAreRefused) {
  CutModel model = textbookHalf();
  model.tool.toothHelix = {0.2, 0.7};
  const auto lobes = ExactLobes::make(model, "tool");
  ASSERT_TRUE(lobes.ok());
  EXPECT_FALSE(lobes->limits(Rpm(8000), {Metres(0.1), true, false, {}}).ok());
  EXPECT_TRUE(lobes->limits(Rpm(8000), {Metres(5e-3), true, false, {}}).ok());
}

}  // namespace
}  // namespace stillcut::milling
