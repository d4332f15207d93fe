// What voltage stands for what value: straight lines between the points, nothing beyond the ends, and back again.
#include "core/cnc/analog/calibration_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace stillcut::cnc {
namespace {

using Points = std::vector<CalibrationTable::Point>;

// The value that a voltage stands for, read off the drawing.
double valueAt(const Points& points, double volts) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (volts > points[i].volts && i + 1 < points.size()) continue;
    const double share = (volts - points[i - 1].volts) / (points[i].volts - points[i - 1].volts);
    return points[i - 1].value + share * (points[i].value - points[i - 1].value);
  }
  return points.back().value;
}

Points randomTable(std::mt19937& random, bool rises) {
  std::uniform_real_distribution<double> step(0.01, 3.0);
  Points points;
  double volts = -5.0, value = rises ? -20.0 : 400.0;
  for (auto n = 2 + random() % 9; n > 0; --n) {
    points.push_back({volts += step(random), value += (rises ? 10.0 : -10.0) * step(random)});
  }
  return points;
}

TEST(CalibrationTable, VoltageIsTheInverseOfTheDrawing) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 400; ++trial) {
    const Points points = randomTable(random, trial % 2 == 0);
    const auto table = CalibrationTable::make(points, "test");
    ASSERT_TRUE(table.ok()) << table.error().line();
    EXPECT_EQ(table->lowest(), std::min(points.front().value, points.back().value));
    EXPECT_EQ(table->highest(), std::max(points.front().value, points.back().value));
    for (int k = 0; k <= 50; ++k) {
      const double wanted = table->lowest() + (table->highest() - table->lowest()) * k / 50.0;
      EXPECT_NEAR(valueAt(points, table->voltage(wanted)), wanted, 1e-9);
    }
    for (const auto& point : points) EXPECT_NEAR(table->voltage(point.value), point.volts, 1e-12);
  }
}

TEST(CalibrationTable, NeverLeavesItsEnds) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const Points points = randomTable(random, trial % 2 == 0);
    const auto table = CalibrationTable::make(points, "test");
    ASSERT_TRUE(table.ok());
    for (double wild : {-1e300, -1e6, 1e6, 1e300}) {
      const double volts = table->voltage(wild);
      EXPECT_GE(volts, points.front().volts - 1e-12);
      EXPECT_LE(volts, points.back().volts + 1e-12);
    }
  }
}

TEST(CalibrationTable, MoreIsMoreEverywhere) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 100; ++trial) {
    const bool rises = trial % 2 == 0;
    const auto table = CalibrationTable::make(randomTable(random, rises), "test");
    ASSERT_TRUE(table.ok());
    double before = table->voltage(table->lowest());
    for (int k = 1; k <= 200; ++k) {
      const double volts = table->voltage(table->lowest() + (table->highest() - table->lowest()) * k / 200.0);
      if (rises) {
        EXPECT_GT(volts, before);
      } else {
        EXPECT_LT(volts, before);
      }
      before = volts;
    }
  }
}

TEST(CalibrationTable, RefusesWhatIsNoTableAndNamesThePoint) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<Points, const char*> bad[] = {{{}, "fewer than two"},
                                                {{{1.0, 0.0}}, "fewer than two"},
                                                {{{1.0, 0.0}, {1.0, 5.0}}, "point 2"},
                                                {{{1.0, 0.0}, {0.5, 5.0}}, "point 2"},
                                                {{{1.0, 0.0}, {2.0, 5.0}, {3.0, 5.0}}, "point 3"},
                                                {{{1.0, 0.0}, {2.0, 5.0}, {3.0, 4.0}}, "point 3"},
                                                {{{1.0, 5.0}, {2.0, 4.0}, {3.0, 4.5}}, "point 3"},
                                                {{{nan, 0.0}, {2.0, 5.0}}, "point 1"},
                                                {{{1.0, 0.0}, {2.0, nan}}, "point 2"}};
  for (const auto& [points, what] : bad) {
    const auto table = CalibrationTable::make(points, "speed.table");
    ASSERT_FALSE(table.ok());
    const std::string line = table.error().line();
    EXPECT_EQ(line.rfind("speed.table: ", 0), 0u) << line;
    EXPECT_NE(line.find(what), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace stillcut::cnc
