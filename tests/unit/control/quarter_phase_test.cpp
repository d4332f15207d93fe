// quarter-phase against Liao 1996: the golden numbers of its cutting tests (Z = 4).
#include "core/control/quarter_phase.h"

#include <gtest/gtest.h>

namespace stillcut::control {
namespace {

constexpr config::SpeedRange kEverything{Rpm(0.0), Rpm(1e9)};

double rule(double hz, double rpm, SpeedDirection direction, config::SpeedRange reach = kEverything) {
  return quarterPhaseSpeed(Hertz(hz), 4, Rpm(rpm), 0.25, direction, reach).speed.value;
}

TEST(QuarterPhase, GoldenNumbersGoingDown) {
  EXPECT_NEAR(rule(150.0, 950.0, SpeedDirection::Down), 692.3, 0.05);  // paper: 694
  EXPECT_NEAR(rule(115.2, 694.0, SpeedDirection::Down), 531.7, 0.05);  // paper: 531
  EXPECT_NEAR(rule(125.0, 1000.0, SpeedDirection::Down), 833.3, 0.05);
}

TEST(QuarterPhase, NearestAndUp) {
  EXPECT_NEAR(rule(150.0, 950.0, SpeedDirection::Nearest), 1000.0, 1e-9);
  EXPECT_NEAR(rule(150.0, 950.0, SpeedDirection::Up), 1000.0, 1e-9);
  EXPECT_NEAR(rule(125.0, 1000.0, SpeedDirection::Nearest), 833.3, 0.05);
  EXPECT_NEAR(rule(125.0, 1000.0, SpeedDirection::Up), 1500.0, 1e-9);
}

TEST(QuarterPhase, TheTargetLeavesAQuarterWave) {
  for (double hz = 40.0; hz < 3000.0; hz *= 1.13) {
    for (const SpeedDirection d : {SpeedDirection::Nearest, SpeedDirection::Down}) {
      const double waves = hz / toothPassing(Rpm(rule(hz, 1000.0, d)), 4).value;
      EXPECT_NEAR(waves - std::floor(waves), 0.25, 1e-9);
    }
    EXPECT_LE(rule(hz, 1000.0, SpeedDirection::Down), 1020.0);
  }
}

TEST(QuarterPhase, OnceThereNoiseDoesNotJumpAPocket) {
  const double there = rule(150.0, 950.0, SpeedDirection::Down);
  EXPECT_NEAR(rule(150.5, there, SpeedDirection::Down), there * 150.5 / 150.0, 1e-6);
  EXPECT_NEAR(rule(149.5, there, SpeedDirection::Down), there * 149.5 / 150.0, 1e-6);
}

TEST(QuarterPhase, OnlyWhatTheOverrideReaches) {
  EXPECT_NEAR(rule(150.0, 950.0, SpeedDirection::Nearest, {Rpm(475.0), Rpm(990.0)}), 692.3, 0.05);
  EXPECT_EQ(rule(150.0, 950.0, SpeedDirection::Nearest, {Rpm(760.0), Rpm(990.0)}), 0.0);
}

TEST(QuarterPhase, AtLowFrequencyTheFirstPocketIsTheLast) {
  // Less than a quarter wave at the present speed: only slower speeds have one.
  EXPECT_NEAR(rule(10.0, 1000.0, SpeedDirection::Nearest), 600.0, 1e-9);
  EXPECT_EQ(rule(10.0, 1000.0, SpeedDirection::Up), 0.0);
}

TEST(QuarterPhase, AsksAndExplains) {
  QuarterPhase strategy;
  CutSetup setup;
  setup.teeth = 4;
  config::ParamCatalog catalog;
  catalog.add(quarterPhaseParams());
  config::ParamSet params;
  ASSERT_TRUE(params.set(catalog, "quarter-phase.direction", "down", "test"));
  strategy.prepare(setup, params);
  StrategyInput in;
  in.dt = Seconds(0.1);
  in.machine.valid = true;
  in.machine.programmedSpeed = in.machine.actualSpeed = Rpm(950.0);
  in.machine.programmedFeed = fromMmPerMin(380.0);
  in.verdict.valid = true;
  in.verdict.state = CutState::Chatter;
  in.verdict.frequency = Hertz(150.0);
  const OverrideRequest r = strategy.decide(in);
  EXPECT_EQ(r.kind, RequestKind::Set);
  EXPECT_NEAR(r.speed.value, 692.3, 0.05);
  EXPECT_NEAR(toMmPerMin(r.feed) / r.speed.value, 380.0 / 950.0, 1e-12);
  EXPECT_EQ(sentence(r.reason), "692 rpm puts 3.25 chatter waves of 150 Hz between two teeth, from 950 rpm");

  ASSERT_TRUE(params.set(config::kLowestSpeedOverride, 90.0, "test"));
  strategy.prepare(setup, params);
  const OverrideRequest out = strategy.decide(in);
  EXPECT_EQ(out.kind, RequestKind::None);
  EXPECT_EQ(out.reason.code, ReasonCode::TargetOutOfRange);
  EXPECT_NEAR(out.reason.n[0], 692.3, 0.05);
}

}  // namespace
}  // namespace stillcut::control
