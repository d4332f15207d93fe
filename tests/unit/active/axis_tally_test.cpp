// What an axis did over the last second.
#include "core/active/axis_tally.h"

#include <gtest/gtest.h>

namespace stillcut::active {
namespace {

TEST(AxisTally, TellsTheLastSecondAndForgetsWhatWasBefore) {
  AxisTally tally;
  tally.prepare(Hertz(1000.0), 2.0);
  ActiveAxis told;
  tally.tell(told);
  EXPECT_EQ(told.strokePeak, 0.0);
  EXPECT_EQ(told.limitedFraction, 0.0);
  for (int n = 0; n < 1000; ++n) tally.add(2.0, 4.0, n % 2 == 0 ? 1.0 : -1.0, n % 4 == 0);
  tally.tell(told);
  EXPECT_DOUBLE_EQ(told.strokePeak, 0.5);
  EXPECT_DOUBLE_EQ(told.strokeRms, 0.5);
  EXPECT_DOUBLE_EQ(told.errorRms, 2.0);
  EXPECT_DOUBLE_EQ(told.uncontrolledRms, 4.0);
  EXPECT_DOUBLE_EQ(told.limitedFraction, 0.25);
  tally.add(0.0, 0.0, 2.0, true);  // one peak stays for a second, no longer
  for (int n = 0; n < 900; ++n) tally.add(0.0, 0.0, 0.0, false);
  tally.tell(told);
  EXPECT_DOUBLE_EQ(told.strokePeak, 1.0);
  for (int n = 0; n < 300; ++n) tally.add(0.0, 0.0, 0.0, false);
  tally.tell(told);
  EXPECT_EQ(told.strokePeak, 0.0);
  EXPECT_EQ(told.errorRms, 0.0);
}

}  // namespace
}  // namespace stillcut::active
