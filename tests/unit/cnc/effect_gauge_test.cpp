// An order's effect is timed from the order to the read-back that shows it, and nothing else is.
#include "core/cnc/effect_gauge.h"

#include <gtest/gtest.h>

namespace stillcut::cnc {
namespace {

Instant ms(double t) {
  return Instant(toDuration(Seconds(t * 1e-3)));
}
double typicalMs(const EffectGauge& gauge) {
  return gauge.typical().value * 1e3;
}

class EffectGaugeTest : public ::testing::Test {
 protected:
  EffectGaugeTest() { shown(1.0, 1.0, 1.0); }
  void order(double speed, double feed, double at) { gauge_.commanded(Ratio(speed), Ratio(feed), ms(at)); }
  void shown(double speed, double feed, double at) { gauge_.shown(Ratio(speed), Ratio(feed), ms(at)); }
  EffectGauge gauge_;
};

TEST_F(EffectGaugeTest, NothingIsKnownBeforeAnEffectWasSeen) {
  order(0.95, 1.0, 10.0);
  shown(1.0, 1.0, 50.0);
  EXPECT_EQ(typicalMs(gauge_), 0.0);
  EXPECT_EQ(gauge_.newest(), ms(10.0));
}

TEST_F(EffectGaugeTest, TimesAStepAndTheWayBack) {
  order(0.95, 1.0, 10.0);
  order(0.951, 1.0, 20.0);  // the same whole per cent: a renewal, no news
  EXPECT_EQ(gauge_.newest(), ms(10.0));
  shown(0.95, 1.0, 110.0);
  EXPECT_NEAR(typicalMs(gauge_), 100.0, 1e-6);
}

TEST_F(EffectGaugeTest, EveryPerCentOfARampIsAsLateAsTheMachineIs) {
  for (int i = 1; i <= 200; ++i) {
    const double t = 10.0 * i;
    order(1.0 - 0.001 * i, 1.0, t);
    shown(1.0 - 0.001 * std::max(0, i - 7), 1.0, t + 0.5);  // seven orders behind
  }
  EXPECT_NEAR(typicalMs(gauge_), 70.5, 1e-6);
}

// Taken back before it acted: the old value, still standing there, is not the effect of the order that asks for it.
TEST_F(EffectGaugeTest, ValueThatStandsThereAlreadyIsNoEffect) {
  order(0.95, 1.0, 10.0);
  order(1.0, 1.0, 30.0);
  shown(1.0, 1.0, 31.0);
  EXPECT_EQ(typicalMs(gauge_), 0.0);
  shown(0.95, 1.0, 130.0);
  shown(1.0, 1.0, 150.0);
  EXPECT_NEAR(typicalMs(gauge_), 120.0, 1e-6);  // of 120 and 120
}

TEST_F(EffectGaugeTest, OvertakenAndForgottenOrdersCountForNothing) {
  order(0.97, 1.0, 10.0);
  order(0.90, 1.0, 20.0);
  shown(0.90, 1.0, 100.0);  // the machine took the latest
  EXPECT_NEAR(typicalMs(gauge_), 80.0, 1e-6);
  shown(0.97, 1.0, 9000.0);  // the operator's hand, by chance on a value of long ago
  EXPECT_NEAR(typicalMs(gauge_), 80.0, 1e-6);
  order(0.85, 1.0, 9100.0);
  gauge_.forget();  // locked, or the link was lost
  shown(0.85, 1.0, 9900.0);
  EXPECT_NEAR(typicalMs(gauge_), 80.0, 1e-6);
}

TEST_F(EffectGaugeTest, TheFeedIsTimedAsWell) {
  order(1.0, 0.8, 10.0);
  shown(1.0, 0.8, 30.0);
  EXPECT_NEAR(typicalMs(gauge_), 20.0, 1e-6);
}

TEST_F(EffectGaugeTest, WhatAnEarlierRunMeasuredHoldsUntilAnEffectIsSeen) {
  EffectGauge gauge(Seconds(0.096));
  EXPECT_EQ(typicalMs(gauge), 96.0);
  gauge.shown(Ratio(1.0), Ratio(1.0), ms(1.0));
  gauge.commanded(Ratio(0.95), Ratio(1.0), ms(10.0));
  EXPECT_EQ(typicalMs(gauge), 96.0);
  gauge.shown(Ratio(0.95), Ratio(1.0), ms(50.0));
  EXPECT_NEAR(typicalMs(gauge), 40.0, 1e-9);
}

}  // namespace
}  // namespace stillcut::cnc
