// Frequency responses in place of modes: sampled from modes, the zeroth order says of them what it says of the modes.
#include "core/milling/stability/measured_receptance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/stability/lobe_sweep.h"
#include "core/milling/stability/zeroth_order.h"

namespace stillcut::milling {
namespace {

using Complex = std::complex<double>;

CutModel cut() {
  CutModel m;
  m.modes = {{Hertz(780.0), 0.025, 1.4e7, {1.0, 0.0}},
             {Hertz(830.0), 0.02, 1.2e7, {0.0, 1.0}},
             {Hertz(1200.0), 0.03, 4e7, {0.8, 0.6}}};
  m.tool.teeth = 4;
  m.engagement = {0.5, MillingDirection::Down};
  return m;
}

MeasuredReceptance sampled(const CutModel& model, double from, double to, double step) {
  MeasuredReceptance g;
  for (double f = from; f <= to; f += step) {
    Complex xx, xy, yy;
    for (const Mode& m : model.modes) {
      const double r = f / m.frequency.value;
      const Complex h = 1.0 / (m.stiffness * Complex(1.0 - r * r, 2.0 * m.damping * r));
      xx += h * m.direction[0] * m.direction[0];
      xy += h * m.direction[0] * m.direction[1];
      yy += h * m.direction[1] * m.direction[1];
    }
    for (auto& [response, value] : {std::pair{&g.xx, xx}, std::pair{&g.xy, xy}, std::pair{&g.yy, yy}}) {
      response->frequency.push_back(f);
      response->value.push_back(value);
    }
  }
  return g;
}

TEST(MeasuredReceptance, TheZerothOrderSaysOfItWhatItSaysOfTheModes) {
  const CutModel model = cut();
  const auto ofModes = ZerothOrder::make(model, "modes");
  CutModel bare = model;
  bare.modes.clear();
  const auto measured = ZerothOrder::make(bare, sampled(model, 100.0, 4000.0, 1.0), "measured");
  ASSERT_TRUE(ofModes.ok());
  ASSERT_TRUE(measured.ok()) << measured.error().line();
  for (double rpm = 4000.0; rpm < 16000.0; rpm += 500.0) {
    const auto a = ofModes->limit(Rpm(rpm), Metres(0.02)), b = measured->limit(Rpm(rpm), Metres(0.02));
    ASSERT_TRUE(a.ok() && b.ok());
    ASSERT_TRUE(a->hasLimit() && b->hasLimit()) << rpm;
    EXPECT_NEAR(b->crossings.front().depth / a->crossings.front().depth, 1.0, 0.005) << rpm;
    EXPECT_NEAR(b->crossings.front().frequency.value, a->crossings.front().frequency.value, 2.0) << rpm;
  }
}

// A cross term counts: without it the limits of this cut are others.
TEST(MeasuredReceptance, TheCrossResponseCounts) {
  MeasuredReceptance g = sampled(cut(), 100.0, 4000.0, 1.0);
  const auto with = ZerothOrder::make(cut(), g, "with");
  g.xy = {};
  const auto without = ZerothOrder::make(cut(), g, "without");
  double most = 0.0;
  for (double rpm = 6000.0; rpm < 14000.0; rpm += 1000.0) {
    const auto a = with->limit(Rpm(rpm), Metres(0.02)), b = without->limit(Rpm(rpm), Metres(0.02));
    most = std::max(most, std::abs(b->crossings.front().depth / a->crossings.front().depth - 1.0));
  }
  EXPECT_GT(most, 0.02);
}

TEST(MeasuredReceptance, OneAxisAloneIsEnough) {
  CutModel model = cut();
  model.modes.resize(1);
  MeasuredReceptance g = sampled(model, 100.0, 4000.0, 1.0);
  g.xy = g.yy = {};
  const auto measured = ZerothOrder::make(model, g, "x");
  const auto ofModes = ZerothOrder::make(model, "modes");
  ASSERT_TRUE(measured.ok() && ofModes.ok());
  for (double rpm : {7000.0, 9000.0, 11000.0}) {
    const auto a = ofModes->limit(Rpm(rpm), Metres(0.02)), b = measured->limit(Rpm(rpm), Metres(0.02));
    ASSERT_EQ(a->hasLimit(), b->hasLimit()) << rpm;
    if (!a->hasLimit()) continue;
    EXPECT_NEAR(b->crossings.front().depth / a->crossings.front().depth, 1.0, 0.005) << rpm;
  }
}

TEST(MeasuredReceptance, WhatIsNoResponseIsOneLine) {
  MeasuredReceptance g;
  EXPECT_FALSE(ZerothOrder::make(cut(), g, "none").ok());
  g.xx = {{100.0, 200.0, 150.0}, {1e-7, 1e-7, 1e-7}};
  EXPECT_NE(g.check("f.csv").error().line().find("must rise"), std::string::npos);
  g.xx = {{100.0, 200.0}, {1e-7, 1e-7}};
  g.yy = {{300.0, 400.0}, {1e-7, 1e-7}};
  EXPECT_NE(g.check("f.csv").error().line().find("in common"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::milling
