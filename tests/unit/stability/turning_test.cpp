// Edges that stand: one delay, constant directions, so that every crossing has a closed form (Tlusty 1965; Altintas,
// Manufacturing Automation, chapter 4). With g = (n . d)(f . d) G of one mode, f = K_r n - K_t z over sin(kappa), a
// depth is on the border at omega where w = -1/(2 Re g) and exp(-i omega tau) = 1 + 1/(w g).
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/milling/stability/advice.h"
#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/lobe_case.h"
#include "core/milling/stability/lobe_sweep.h"
#include "core/milling/stability/semi_discretization.h"
#include "core/milling/stability/zeroth_order.h"

namespace stillcut::milling {
namespace {

using Complex = std::complex<double>;

constexpr double kDegree = kTwoPi / 360.0;

CutModel boringBar(double edgeAngleDegrees) {
  CutModel model;
  Mode bar;
  bar.frequency = Hertz(250.0);
  bar.damping = 0.02;
  bar.stiffness = 5e6;
  bar.direction = {0.3, 1.0};
  bar.directionZ = 0.5;
  model.modes = {bar};
  model.tool.teeth = 1;
  model.tool.diameter = Metres(0.060);
  model.material.tangential = 2.0e9;
  model.material.radial = 1.6e9;
  model.turning = Turning{edgeAngleDegrees * kDegree};
  return model;
}

// Force towards the chip and back, over the depth of cut.
double oriented(const CutModel& model) {
  const double kappa = model.turning->edgeAngle;
  const Mode& m = model.modes.front();
  const double across = std::sin(kappa) * m.direction[0] + std::cos(kappa) * m.direction[1];
  const double force = model.material.radial * across - model.material.tangential * m.directionZ;
  return across * force / std::sin(kappa);
}

Complex receptance(const Mode& m, double omega) {
  const double own = kTwoPi * m.frequency.value;
  return 1.0 / (m.mass() * Complex(own * own - omega * omega, 2.0 * m.damping * own * omega));
}

struct Border {
  double depth, rpm;
};

// With `waves` whole waves between two revolutions.
Border borderAt(const CutModel& model, double hz, int waves) {
  const double omega = kTwoPi * hz;
  const Complex g = oriented(model) * receptance(model.modes.front(), omega);
  const double depth = -1.0 / (2.0 * g.real());
  double turn = -std::arg(1.0 + 1.0 / (depth * g));
  if (turn < 0.0) turn += kTwoPi;
  return {depth, 60.0 * omega / (turn + kTwoPi * waves)};
}

LimitOptions all(double deepest) {
  LimitOptions options;
  options.maxAxialDepth = Metres(deepest);
  return options;
}

TEST(Turning, EveryCrossingIsWhereTheClosedFormHasIt) {
  int seen = 0;
  for (double kappa : {45.0, 75.0, 95.0}) {
    const CutModel model = boringBar(kappa);
    const auto lobes = ExactLobes::make(model, "bar");
    ASSERT_TRUE(lobes.ok()) << lobes.error().line();
    // A force that turns from pushing the edge out to pulling it in has its border below the mode.
    const double side = oriented(model) > 0.0 ? 1.0 : -1.0;
    for (double off : {0.01, 0.02, 0.04}) {
      for (int waves : {2, 9, 40}) {
        const double hz = 250.0 * (1.0 + side * off);
        const Border border = borderAt(model, hz, waves);
        ASSERT_GT(border.depth, 0.0);
        const auto limits = lobes->limits(Rpm(border.rpm), all(1.3 * border.depth));
        ASSERT_TRUE(limits.ok()) << limits.error().line();
        EXPECT_TRUE(limits->verified);
        double nearest = 1e9, found = 0.0;
        for (const StabilityLimit& l : limits->crossings) {
          if (std::abs(l.depth.value / border.depth - 1.0) > nearest) continue;
          nearest = std::abs(l.depth.value / border.depth - 1.0);
          found = l.frequency.value;
        }
        EXPECT_LT(nearest, 1e-7) << kappa << " degrees, " << hz << " Hz, " << waves << " waves";
        EXPECT_NEAR(found, hz, 0.5) << kappa << " degrees, " << waves << " waves";
        ++seen;
      }
    }
  }
  EXPECT_EQ(seen, 27);
}

// 2 k zeta (1 + zeta)/K is the depth no lobe goes below (Tlusty), 2 k zeta (1 - zeta)/|K| where the force pulls.
TEST(Turning, NoLobeGoesBelowTheLeastDepth) {
  for (double kappa : {45.0, 95.0}) {
    const CutModel model = boringBar(kappa);
    const Mode& m = model.modes.front();
    const double k = oriented(model);
    const double least = 2.0 * m.stiffness * m.damping * (1.0 + (k > 0.0 ? 1.0 : -1.0) * m.damping) / std::abs(k);
    std::vector<Rpm> speeds;
    for (double rpm = 300.0; rpm < 3000.0; rpm *= 1.002) speeds.emplace_back(rpm);
    SweepOptions options;
    options.limits.maxAxialDepth = Metres(20.0 * least);
    options.limits.firstOnly = true;
    const auto sweep = sweepLobes(model, speeds, options, "bar");
    ASSERT_TRUE(sweep.ok());
    double lowest = 1.0;
    for (const SpeedLimits& l : sweep->speeds) {
      ASSERT_TRUE(l.hasLimit() || sweep->complete(l)) << l.speed.value;
      if (l.hasLimit()) lowest = std::min(lowest, l.crossings.front().depth.value);
    }
    EXPECT_GE(lowest, least * (1.0 - 1e-9)) << kappa;
    EXPECT_LT(lowest, least * 1.001) << kappa;
  }
}

TEST(Turning, TheThreeMethodsAgree) {
  CutModel model = boringBar(75.0);
  Mode part = model.modes.front();  // its own direction, and slower: two axes
  part.frequency = Hertz(140.0);
  part.direction = {0.0, 1.0};
  part.directionZ = -0.2;
  part.ofPart = true;
  model.modes.push_back(part);
  const auto exact = ExactLobes::make(model, "bar");
  const auto zeroth = ZerothOrder::make(model, "bar");
  const auto cells = SemiDiscretization::make(model, {400, 1}, "bar");
  ASSERT_TRUE(exact.ok() && zeroth.ok() && cells.ok());
  EXPECT_TRUE(zeroth->warning().empty()) << "nothing is averaged";
  for (double rpm : {600.0, 850.0, 1400.0, 2600.0}) {
    const auto limits = exact->limits(Rpm(rpm), all(0.01));
    ASSERT_TRUE(limits.ok() && limits->hasLimit()) << rpm;
    const double depth = limits->crossings.front().depth.value;
    const auto mean = zeroth->limit(Rpm(rpm), Metres(0.01));
    ASSERT_TRUE(mean.ok() && mean->hasLimit()) << rpm;
    EXPECT_NEAR(mean->crossings.front().depth.value, depth, 1e-6 * depth) << rpm;
    EXPECT_NEAR(mean->crossings.front().frequency.value, limits->crossings.front().frequency.value, 0.5) << rpm;
    EXPECT_EQ(cells->outside(Rpm(rpm), Metres(0.97 * depth)), 0) << rpm;
    EXPECT_EQ(cells->outside(Rpm(rpm), Metres(1.03 * depth)), 2) << rpm;
  }
}

// What one edge feels, N edges feel N times as often and as strongly: the same lobes at an N-th of the speed and depth.
TEST(Turning, EdgesOfADrillShareTheRevolution) {
  CutModel one = boringBar(60.0);
  one.modes.front().direction = {1.0, 0.0};
  one.modes.front().directionZ = 0.2;
  CutModel three = one;
  three.tool.teeth = 3;
  const auto first = ExactLobes::make(one, "drill"), second = ExactLobes::make(three, "drill");
  ASSERT_TRUE(first.ok() && second.ok());
  const auto a = first->limits(Rpm(1800.0), all(0.02)), b = second->limits(Rpm(600.0), all(0.02 / 3.0));
  ASSERT_TRUE(a.ok() && b.ok() && a->hasLimit() && b->hasLimit());
  EXPECT_NEAR(a->crossings.front().depth.value, 3.0 * b->crossings.front().depth.value, 1e-9);
  three.modes.front().direction = {1.0, 0.1};
  EXPECT_FALSE(ExactLobes::make(three, "drill").ok()) << "across, opposite edges cancel";
}

// The flank damps by c n n^T over the cutting speed: w (1 - exp(-i omega tau)) g + i omega w (c/v) (n . d)^2 G/sin =
// -1.
TEST(Turning, AWornFlankDampsAsTheClosedFormSays) {
  CutModel model = boringBar(75.0);
  model.material.processDamping = 4e5;
  model.modes.front().directionZ = -0.3;
  const double rpm = 300.0;
  const auto lobes = ExactLobes::make(model, "bar");
  ASSERT_TRUE(lobes.ok());
  const auto limits = lobes->limits(Rpm(rpm), all(0.02));
  ASSERT_TRUE(limits.ok() && limits->hasLimit());
  const StabilityLimit& l = limits->crossings.front();
  const double spindle = kTwoPi * rpm / 60.0, tau = kTwoPi / spindle, kappa = model.turning->edgeAngle;
  const double across = std::sin(kappa) * 0.3 + std::cos(kappa) * 1.0;
  const double drag = 4e5 / (0.030 * spindle) * across * across / std::sin(kappa);
  double least = 1e9;
  for (int k = 0; k < 100; ++k) {  // the multiplier's angle fixes omega up to whole turns
    for (double sign : {1.0, -1.0}) {
      const double omega = (sign * l.angle.value + kTwoPi * k) / tau;
      if (omega <= 0.0) continue;
      const Complex g = receptance(model.modes.front(), omega), i(0.0, 1.0);
      const Complex f =
          1.0 + l.depth.value * g * (oriented(model) * (1.0 - std::exp(-i * omega * tau)) + i * omega * drag);
      least = std::min(least, std::abs(f));
    }
  }
  EXPECT_LT(least, 1e-6);
  model.material.processDamping = 0.0;
  const auto sharp = ExactLobes::make(model, "bar")->limits(Rpm(rpm), all(0.02));
  ASSERT_TRUE(sharp.ok() && sharp->hasLimit());
  EXPECT_LT(sharp->crossings.front().depth.value, l.depth.value);
}

constexpr const char* kCase = R"(name = "bar"
[[mode]]
frequency_hz = 250.0
damping = 0.02
stiffness_n_per_m = 5.0e6
direction = [0.3, 1.0, 0.5]
of = "part"
[turning]
diameter_mm = 60.0
edge_angle_deg = 75.0
[material]
tangential_n_per_m2 = 2.0e9
radial_n_per_m2 = 1.6e9
)";

Result<CutModel> read(const std::string& text) {
  config::TomlReader reader = config::TomlReader::text(text, "bar.toml");
  CutModel model = readModel(reader.root());
  reader.root().textOr("name", "");
  if (Status ok = reader.finish(); !ok) return ok.error();
  if (Status ok = check(model, "bar.toml"); !ok) return ok.error();
  return model;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(Turning, ACaseReadsBackAsItWasWritten) {
  const auto model = read(kCase);
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_TRUE(model->turning.has_value());
  EXPECT_NEAR(model->turning->edgeAngle, 75.0 * kDegree, 1e-12);
  const auto back = read(modelText(*model));
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(back->turning->edgeAngle, model->turning->edgeAngle);
  EXPECT_EQ(back->modes.front().directionZ, 0.5);
  EXPECT_TRUE(back->modes.front().ofPart);
  EXPECT_EQ(back->tool.diameter.value, 0.060);
}

TEST(Turning, BadCasesAreRefusedInOneLine) {
  const auto refused = [](const std::string& text, const std::string& word) {
    const auto model = read(text);
    ASSERT_FALSE(model.ok()) << word;
    EXPECT_NE(model.error().line().find(word), std::string::npos) << model.error().line();
  };
  refused(replaced(kCase, "diameter_mm = 60.0", ""), "diameter_mm");
  refused(replaced(kCase, "75.0", "2.0"), "edge_angle_deg");
  refused(replaced(kCase, "[material]", "[tool]\nteeth = 2\n[material]"), "a turning cut has no tool that turns");
  refused(replaced(replaced(kCase, "75.0", "90.0"), "[0.3, 1.0, 0.5]", "[0.0, 1.0, 0.0]"), "no mode moves the edge");
  refused(replaced(kCase, "[0.3, 1.0, 0.5]", "[0.3]"), "two or three numbers");
}

TEST(Turning, AdviceGivesTheChipsVolume) {
  AdviceRequest request;
  request.depth = Metres(0.0005);
  request.lowest = Rpm(800.0);
  request.highest = Rpm(2500.0);
  request.feedPerTooth = Metres(2e-4);
  const auto advice = adviseSpeeds(boringBar(75.0), request, "bar");
  ASSERT_TRUE(advice.ok()) << advice.error().line();
  ASSERT_FALSE(advice->pockets.empty());
  const SpeedPocket& p = advice->pockets.front();
  EXPECT_NEAR(p.removal, 0.0005 * 2e-4 * std::numbers::pi * 0.060 * p.best.value / 60.0, 1e-15);
}

}  // namespace
}  // namespace stillcut::milling
