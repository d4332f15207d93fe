// An arc that moves pulls the tracked speed, and orders turn by that.
#include "core/detect/growth/arc_pull.h"

#include <gtest/gtest.h>

namespace stillcut::detect {
namespace {

constexpr double kHertz = 100.0;

// A hundred turns of a cut that stands, then so many of an arc that pulls the speed by that part.
ArcPull pulled(double part, int turns) {
  ArcPull out;
  for (int k = 0; k < 100; ++k) out.endTurn(Hertz(kHertz), false);
  for (int k = 0; k < turns; ++k) out.endTurn(Hertz(kHertz * (1.0 + part)), true);
  return out;
}

TEST(ArcPull, WhatIsForcedTurnsByThePullOfItsOrder) {
  for (const double part : {-3e-3, 2e-3}) {
    const ArcPull pull = pulled(part, 10);
    for (const int order : {1, 5, 9})
      EXPECT_NEAR(pull.beyond(order, -0.9 * part * order), 0.0, 1e-12) << part << ' ' << order;
    EXPECT_DOUBLE_EQ(pull.beyond(5, 0.0), 0.0) << "nor does the pull turn what stands";
  }
}

TEST(ArcPull, ALineTurnsByMoreOrTheOtherWay) {
  const ArcPull pull = pulled(-2e-3, 10);
  EXPECT_NEAR(pull.beyond(5, 0.04), 0.03, 1e-3);
  EXPECT_DOUBLE_EQ(pull.beyond(5, -0.04), -0.04);
}

TEST(ArcPull, IsOverSomeTurnsAfterTheArcStands) {
  ArcPull pull = pulled(-2e-3, 10);
  pull.endTurn(Hertz(kHertz), false);
  EXPECT_LT(pull.beyond(5, 0.01), 0.003) << "what the orders turned by is remembered";
  for (int k = 0; k < 30; ++k) pull.endTurn(Hertz(kHertz), false);
  EXPECT_GT(pull.beyond(5, 0.01), 0.0099);
}

// A pattern of tooth passings that never comes to rest, and a spindle that has slowed under the load.
TEST(ArcPull, ASpeedThatStaysIsTheSpindles) {
  EXPECT_GT(pulled(-4e-3, 600).beyond(5, 0.01), 0.0095);
}

TEST(ArcPull, AnEngagementThatStandsPullsNothing) {
  ArcPull pull = pulled(-2e-3, 0);
  for (int k = 0; k < 10; ++k) pull.endTurn(Hertz(kHertz * 0.998), false);
  EXPECT_DOUBLE_EQ(pull.beyond(5, 0.01), 0.01);
  ArcPull first;
  first.endTurn(Hertz(kHertz), true);
  EXPECT_DOUBLE_EQ(first.beyond(5, 0.01), 0.01);
}

// A cut at the same arc, or a speed that has changed by more than any arc pulls it.
TEST(ArcPull, NothingElseIsPulled) {
  EXPECT_DOUBLE_EQ(pulled(-2e-3, 0).beyond(5, 0.01), 0.01);
  EXPECT_DOUBLE_EQ(pulled(-8e-3, 10).beyond(5, 0.01), 0.01);
}

}  // namespace
}  // namespace stillcut::detect
