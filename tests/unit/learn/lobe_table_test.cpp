// The table over all speeds against the zeroth order solved at each speed.
#include "core/learn/lobe_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/stability/zeroth_order.h"
#include "tests/support/hidden_machines/hidden_machine.h"

namespace stillcut::learn {
namespace {

TEST(LobeTable, IsTheZerothOrderAtEverySpeed) {
  int looked = 0;
  int near = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const test::HiddenMachine machine = test::hiddenMachine(seed);
    const milling::CutModel& model = machine.model;
    const SpeedGrid grid{machine.lowest.value, machine.highest.value, 256};
    Dynamics dynamics{model.modes, model.material.tangential, model.material.radial / model.material.tangential};
    std::vector<LimitPoint> table;
    fillLimits(dynamics, meanForce(model.engagement, model.tool.teeth), model.tool.teeth, grid, machine.deepest.value,
               table);
    const auto solved = milling::ZerothOrder::make(model, "test");
    ASSERT_TRUE(solved.ok());
    for (int i = 3; i < grid.points; i += 17) {
      const auto limit = solved->limit(Rpm(grid.at(i)), machine.deepest);
      ASSERT_TRUE(limit.ok());
      const double depth = limit->hasLimit() ? limit->crossings.front().depth.value : machine.deepest.value;
      const LimitPoint& point = table[static_cast<std::size_t>(i)];
      ++looked;
      near += std::abs(point.logDepth - std::log(depth)) < 0.03 ? 1 : 0;
      if (point.frequency > 0.0F && limit->hasLimit() && std::abs(point.logDepth - std::log(depth)) < 0.03) {
        EXPECT_NEAR(point.frequency, limit->crossings.front().frequency.value, 0.05 * point.frequency);
      }
    }
  }
  // Next to a cusp the two neighbours of the grid stand on different lobes.
  EXPECT_GE(near, looked * 95 / 100) << near << " of " << looked;
}

TEST(LobeTable, LooksUpBetweenItsSpeedsAndHoldsItsEnds) {
  const SpeedGrid grid{1000.0, 4000.0, 3};  // 1000, 2000, 4000
  const std::vector<LimitPoint> table{{-7.0F, 500.0F}, {-6.0F, 600.0F}, {-5.0F, 700.0F}};
  EXPECT_NEAR(limitAt(table, grid, 2000.0).logDepth, -6.0, 1e-5);
  EXPECT_NEAR(limitAt(table, grid, std::sqrt(2000.0 * 4000.0)).logDepth, -5.5, 1e-5);
  EXPECT_NEAR(limitAt(table, grid, 100.0).logDepth, -7.0, 1e-5);
  EXPECT_NEAR(limitAt(table, grid, 9000.0).logDepth, -5.0, 1e-5);
}

}  // namespace
}  // namespace stillcut::learn
