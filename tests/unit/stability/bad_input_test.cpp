// One clear line for nonsense; never a hang or a NaN.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/milling/stability/lobe_sweep.h"
#include "core/milling/stability/zeroth_order.h"
#include "tests/support/dominant_multiplier.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

std::string refusal(const CutModel& model) {
  const auto lobes = ExactLobes::make(model, "case");
  return lobes.ok() ? "" : lobes.error().line();
}

TEST(StabilityBadInput, ModelsAreRefusedWithOneLine) {
  const auto broken = [](auto&& change) {
    CutModel model = textbookSlot();
    change(model);
    return refusal(model);
  };
  EXPECT_EQ(refusal(textbookSlot()), "");
  const std::string lines[] = {
      broken([](CutModel& m) { m.modes.clear(); }),
      broken([](CutModel& m) { m.modes[0].damping = -0.01; }),
      broken([](CutModel& m) { m.modes[0].damping = std::nan(""); }),
      broken([](CutModel& m) {
        m.modes[0].direction = {0.0, 0.0};
      }),
      broken([](CutModel& m) { m.tool.teeth = 0; }),
      broken([](CutModel& m) { m.engagement.radialImmersion = 0.0; }),
      broken([](CutModel& m) { m.engagement.radialImmersion = 1.2; }),
      broken([](CutModel& m) { m.material.tangential = std::numeric_limits<double>::infinity(); }),
      broken([](CutModel& m) { m.material.exponent = 0.75; }),
      broken([](CutModel& m) {
        m.tool.pitch = {3.0, 3.0};
      }),
  };
  for (const std::string& line : lines) {
    EXPECT_FALSE(line.empty());
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    EXPECT_EQ(line.rfind("case", 0), 0u) << line;
  }
}

TEST(StabilityBadInput, AbsurdSpeedsAndDepthsAreRefusedByEveryMethod) {
  const auto lobes = ExactLobes::make(textbookSlot(), "slot");
  const auto sdm = SemiDiscretization::make(textbookSlot(), {}, "slot");
  const auto zoa = ZerothOrder::make(textbookSlot(), "slot");
  for (double rpm : {0.0, -5000.0, 1e-3, 1e9, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(lobes->limits(Rpm(rpm), {}).ok()) << rpm;
    EXPECT_FALSE(test::dominantMultiplier(*lobes, Rpm(rpm), Metres(1e-3)).ok()) << rpm;
    EXPECT_FALSE(sdm->limit(Rpm(rpm), Metres(1e-3)).ok()) << rpm;
    EXPECT_FALSE(zoa->limit(Rpm(rpm), Metres(1e-3)).ok()) << rpm;
  }
  for (double depth : {0.0, -1.0, 5.0, std::nan("")}) {
    LimitOptions options;
    options.maxAxialDepth = Metres(depth);
    EXPECT_FALSE(lobes->limits(Rpm(5000), options).ok()) << depth;
    EXPECT_FALSE(sdm->limit(Rpm(5000), Metres(depth)).ok()) << depth;
    EXPECT_FALSE(zoa->limit(Rpm(5000), Metres(depth)).ok()) << depth;
  }
}

TEST(StabilityBadInput, DiscretizationsAreRefused) {
  EXPECT_FALSE(SemiDiscretization::make(textbookSlot(), {-1, 1}, "k").ok());
  EXPECT_FALSE(SemiDiscretization::make(textbookSlot(), {40, 2}, "order").ok());
  EXPECT_FALSE(SemiDiscretization::make(textbookSlot(), {1'000'000, 1}, "k").ok());
}

TEST(StabilityBadInput, SpeedRangesAreRefused) {
  EXPECT_FALSE(speedSteps(Rpm(5000), Rpm(4000), Rpm(100), "s").ok());
  EXPECT_FALSE(speedSteps(Rpm(5000), Rpm(6000), Rpm(0), "s").ok());
  EXPECT_FALSE(speedSteps(Rpm(-1), Rpm(6000), Rpm(10), "s").ok());
  EXPECT_FALSE(speedSteps(Rpm(1), Rpm(1e6), Rpm(1e-9), "s").ok());
  EXPECT_FALSE(speedSteps(Rpm(std::nan("")), Rpm(1e6), Rpm(10), "s").ok());
}

// Extreme but legal numbers: an answer, finite, soon.
TEST(StabilityBadInput, ExtremeModelsGiveFiniteAnswers) {
  for (double damping : {1e-5, 0.9}) {
    for (double immersion : {1e-4, 1.0}) {
      for (double rpm : {500.0, 900000.0}) {
        CutModel model = textbookHalf();
        for (Mode& m : model.modes) m.damping = damping;
        model.engagement.radialImmersion = immersion;
        const auto lobes = ExactLobes::make(model, "extreme");
        ASSERT_TRUE(lobes.ok());
        LimitOptions options;
        options.maxAxialDepth = Metres(1.0);
        const auto limits = lobes->limits(Rpm(rpm), options);
        ASSERT_TRUE(limits.ok());
        for (const StabilityLimit& l : limits->crossings) {
          EXPECT_TRUE(std::isfinite(l.depth.value) && std::isfinite(l.frequency.value));
        }
      }
    }
  }
}

}  // namespace
}  // namespace stillcut::milling
