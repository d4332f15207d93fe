// The shared limits: exact to 1e-5, semi-discretization with k = 40 to 1e-6.
#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/semi_discretization.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

class SharedLobes : public testing::TestWithParam<const char*> {};

TEST_P(SharedLobes, EveryExactLimitIsReproducedInOrderWithItsCountsAndKind) {
  STILLCUT_NEEDS_REFERENCE();
  const ReferenceCase reference = loadReference(GetParam());
  const auto lobes = ExactLobes::make(reference.model, GetParam());
  ASSERT_TRUE(lobes.ok());
  ASSERT_GE(reference.rows.size(), 60u);
  for (const auto& [rpm, rows] : reference.rows) {
    LimitOptions options;
    options.maxAxialDepth = Metres(reference.maxAxialDepth);
    options.frequencies = false;
    const auto limits = lobes->limits(Rpm(rpm), options);
    ASSERT_TRUE(limits.ok());
    EXPECT_TRUE(limits->verified) << rpm;
    ASSERT_GE(limits->crossings.size(), rows.size()) << rpm;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const StabilityLimit& found = limits->crossings[i];
      EXPECT_NEAR(found.depth.value / rows[i].depth, 1.0, 1e-6) << rpm << " crossing " << i;
      EXPECT_NEAR(found.angle.value, rows[i].angle, 1e-5) << rpm;
      EXPECT_EQ(found.before, rows[i].before) << rpm;
      EXPECT_EQ(found.after, rows[i].after) << rpm;
      EXPECT_EQ(crossingName(found.kind), rows[i].kind) << rpm;
      EXPECT_EQ(found.crossing, rows[i].crossing) << rpm;
    }
  }
}

TEST_P(SharedLobes, TheFirstLimitAloneIsTheSame) {
  STILLCUT_NEEDS_REFERENCE();
  const ReferenceCase reference = loadReference(GetParam());
  const auto lobes = ExactLobes::make(reference.model, GetParam());
  Metres hint{};
  for (const auto& [rpm, rows] : reference.rows) {
    if (rows.empty()) continue;
    const auto limits = lobes->limits(Rpm(rpm), {Metres(reference.maxAxialDepth), true, false, hint});
    ASSERT_TRUE(limits.ok());
    ASSERT_EQ(limits->crossings.size(), 1u) << rpm;
    hint = limits->crossings.front().depth;
    EXPECT_NEAR(hint.value / rows.front().depth, 1.0, 1e-6) << rpm;
  }
}

TEST_P(SharedLobes, SemiDiscretizationWithFortyCellsIsReproduced) {
  STILLCUT_NEEDS_REFERENCE();
  const ReferenceCase reference = loadReference(GetParam());
  const auto sdm = SemiDiscretization::make(reference.model, {40, 1}, GetParam());
  int compared = 0;
  for (const auto& [rpm, rows] : reference.rows) {
    if (rows.empty() || rows.front().sdmDepth == 0.0 || compared++ > 60) continue;
    const auto limit = sdm->limit(Rpm(rpm), Metres(reference.maxAxialDepth));
    ASSERT_TRUE(limit.ok());
    ASSERT_TRUE(limit->hasLimit()) << rpm;
    EXPECT_NEAR(limit->crossings.front().depth.value / rows.front().sdmDepth, 1.0, 1e-6) << rpm;
  }
  EXPECT_GT(compared, 40);
}

INSTANTIATE_TEST_SUITE_P(Cases, SharedLobes, testing::ValuesIn(kReferenceNames), [](const auto& test) {
  std::string name = test.param;
  for (char& c : name) {
    if (c == '.') c = '_';
  }
  return name;
});

}  // namespace
}  // namespace stillcut::milling
