// A speed that nobody told, found on the lines of a spectrum: which combs are the spindle's and which only seem to be.
#include "core/spindle/speed_finder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stillcut::detect {
namespace {

constexpr double kBin = 0.5;  // Hz
constexpr int kLobe = 4;

// Lines of one power each, at these frequencies [Hz].
FoundSpeed found(int teeth, const std::vector<double>& lines) {
  constexpr int kBins = 8192;
  std::vector<double> power(kBins, 1e-9);
  for (const double line : lines) {
    const auto middle = static_cast<std::size_t>(std::lround(line / kBin));
    power[middle] += 1.0;
    power[middle - 1] += 0.4;
    power[middle + 1] += 0.4;
  }
  SpeedFinder finder;
  finder.prepare(kBins, Hertz(kBin), kLobe, teeth);
  return finder.find(power, Hertz(8.0), Hertz(500.0));
}

TEST(SpeedFinder, AllMultiplesOfTheToothPassingStandInACut) {
  const FoundSpeed speed = found(4, {60.0, 120.0, 240.0, 480.0, 720.0, 960.0});
  EXPECT_NEAR(speed.spindle.value, 60.0, 0.1);
  EXPECT_GT(speed.everyPassing, 0.3);
}

// Chatter half way between two orders of a spindle at 60 Hz makes a comb of 30 Hz, of whose tooth passings of 120 Hz
// only each second one is there.
TEST(SpeedFinder, ACombOfHalfTheSpeedHasOnlyEachSecondToothPassing) {
  const FoundSpeed speed = found(4, {240.0, 480.0, 720.0, 390.0, 450.0, 510.0});
  EXPECT_NEAR(speed.spindle.value, 30.0, 0.1);
  EXPECT_LT(speed.everyPassing, 1e-6);
}

// A saw's tooth passing lies above the orders that are looked at: nothing is told by what is missing there.
TEST(SpeedFinder, OfMoreTeethThanOrdersNothingIsMissing) {
  EXPECT_DOUBLE_EQ(found(60, {20.0, 40.0, 60.0, 80.0, 100.0}).everyPassing, 1.0);
}

}  // namespace
}  // namespace stillcut::detect
