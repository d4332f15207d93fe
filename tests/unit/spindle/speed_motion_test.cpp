// Whether the spindle's speed changes faster than turns can be compared.
#include "core/spindle/speed_motion.h"

#include <gtest/gtest.h>

namespace stillcut::detect {
namespace {

constexpr double kSpindle = 100.0;  // Hz
constexpr double kStep = 1e-3;      // s
constexpr double kGood = 0.01;      // Hz, of what the machine reads

// So long of a speed that falls by 3 % a second, and both say so.
void ramp(SpeedMotion& motion, double& hertz, double seconds) {
  constexpr double kDrift = -0.03;
  for (int i = 0; i * kStep < seconds; ++i) {
    hertz *= 1.0 + kDrift * kStep;
    motion.followMachine(hertz, kGood, kStep);
    motion.followSignal(hertz, kDrift, kStep);
  }
}

// A lock that settles moves what is heard. The machine's slow change, that turns can be compared in, does not hold it.
TEST(SpeedMotion, WhatWasHeardOfALockIsNotHeldByTheMachine) {
  SpeedMotion motion;
  motion.reset(kSpindle);
  motion.startHearing(0.97 * kSpindle);
  double hertz = kSpindle;
  ramp(motion, hertz, kStep);
  EXPECT_TRUE(motion.moving());
  ramp(motion, hertz, 0.3);
  EXPECT_FALSE(motion.moving());
}

// A step that the machine tells has come to its end where its reading stands, not where it is as slow as none.
TEST(SpeedMotion, AStepThatTheMachineTellsLastsUntilItHasArrived) {
  SpeedMotion motion;
  motion.reset(kSpindle);
  motion.followMachine(1.05 * kSpindle, kGood, kStep);
  EXPECT_TRUE(motion.moving());
  for (int i = 0; i * kStep < 0.1; ++i) motion.followMachine(1.05 * kSpindle, kGood, kStep);
  EXPECT_TRUE(motion.moving());
  for (int i = 0; i * kStep < 0.2; ++i) motion.followMachine(1.05 * kSpindle, kGood, kStep);
  EXPECT_FALSE(motion.moving());
}

// Chatter that grows pulls the phases, not the comb. A comb that itself moves by as much as turns cannot be compared in
// stands nowhere, however near each other two windows of a fast spindle are; nor is it asked while the machine tells.
TEST(SpeedMotion, WhatThePhasesSayIsNoneWhereTheCombStands) {
  SpeedMotion motion;
  motion.reset(kSpindle);
  motion.startHearing(kSpindle);
  motion.noMachine();
  motion.followSignal(1.01 * kSpindle, 0.0, kStep);
  EXPECT_TRUE(motion.moving());
  motion.followCombs(5e-4, 0.05);
  EXPECT_FALSE(motion.moving());
  EXPECT_TRUE(motion.phasesMove());
  motion.followCombs(-5e-4, 0.01);
  EXPECT_TRUE(motion.moving());
  motion.followCombs(0.0, 0.05);
  motion.forgetCombs();
  EXPECT_TRUE(motion.moving());
  motion.followCombs(0.0, 0.05);
  motion.followMachine(1.05 * kSpindle, kGood, kStep);
  EXPECT_TRUE(motion.moving());
}

}  // namespace
}  // namespace stillcut::detect
