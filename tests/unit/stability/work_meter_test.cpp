// How soon a stop is noticed, and that no input makes the work unbounded: both counted in operations, not in time.
#include "core/milling/stability/work_meter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/stability/semi_discretization.h"
#include "core/milling/stability/zeroth_order.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

// Cuts that need much work at once: tiny and huge speeds, a metre of depth, many modes, hardly any cut.
struct Extreme {
  std::string name;
  CutModel model;
  double rpm;
  double depth;  // [m]
};

CutModel manyModes(int count) {
  CutModel model = textbookHalf();
  for (int i = 2; i < count; ++i) {
    Mode mode = model.modes[static_cast<std::size_t>(i % 2)];
    mode.frequency = Hertz(400.0 + 60.0 * i);
    mode.stiffness *= 2.0 + i;
    mode.damping = 0.02 + 0.001 * i;
    model.modes.push_back(mode);
  }
  return model;
}

std::vector<Extreme> extremes() {
  CutModel shaving = textbookHalf();
  shaving.engagement.radialImmersion = 1e-4;
  CutModel ringing = textbookHalf();
  for (Mode& m : ringing.modes) m.damping = 1e-5;
  CutModel stiff = manyModes(4);
  for (Mode& m : stiff.modes) m.damping = 0.9;
  return {{"a metre deep at 60 rpm", textbookHalf(), 60.0, 1.0},
          {"four modes at 60 rpm", manyModes(4), 60.0, 1.0},
          {"nearly undamped", ringing, 100.0, 1.0},
          {"nearly overdamped", stiff, 60.0, 1.0},
          {"hardly any cut", shaving, 60.0, 1.0},
          {"hardly any cut, fast", shaving, 9e5, 1.0},
          {"twelve modes", manyModes(12), 3000.0, 20e-3}};
}

void expectSmallPieces(const WorkMeter& meter) {
  EXPECT_LE(meter.largestPiece(), WorkMeter::kLargestPiece);
  EXPECT_GT(meter.total(), 0.0);
}

TEST(WorkMeter, TheExactSearchWorksInSmallPiecesAndEnds) {
  for (const Extreme& extreme : extremes()) {
    SCOPED_TRACE(extreme.name);
    const auto lobes = ExactLobes::make(extreme.model, "extreme").value();
    LimitOptions options;
    options.maxAxialDepth = Metres(extreme.depth);
    WorkMeter meter;
    const SpeedLimits limits = lobes.limits(Rpm(extreme.rpm), options, meter).value();
    expectSmallPieces(meter);
    EXPECT_LT(meter.total(), 3e10);
    EXPECT_TRUE(std::isfinite(limits.searchedTo.value));
    for (const StabilityLimit& l : limits.crossings) {
      EXPECT_TRUE(std::isfinite(l.depth.value) && std::isfinite(l.frequency.value));
    }
  }
}

TEST(WorkMeter, TheOtherMethodsWorkInSmallPiecesToo) {
  for (const Extreme& extreme : extremes()) {
    SCOPED_TRACE(extreme.name);
    WorkMeter zeroth;
    const auto byMean = ZerothOrder::make(extreme.model, "extreme")
                            .value()
                            .limit(Rpm(extreme.rpm), Metres(extreme.depth), zeroth)
                            .value();
    expectSmallPieces(zeroth);
    WorkMeter discrete;
    const auto sdm = SemiDiscretization::make(extreme.model, {40, 1}, "extreme").value();
    const auto byCells = sdm.limit(Rpm(extreme.rpm), Metres(extreme.depth), 20, discrete).value();
    expectSmallPieces(discrete);
    for (const SpeedLimits& limits : {byMean, byCells}) {
      for (const StabilityLimit& l : limits.crossings) {
        EXPECT_TRUE(std::isfinite(l.depth.value) && std::isfinite(l.frequency.value));
      }
    }
  }
}

TEST(WorkMeter, FineSemiDiscretizationOfManyModesLooksUpWithinOnePeriod) {
  WorkMeter meter;
  const auto sdm = SemiDiscretization::make(manyModes(12), {2000, 1}, "fine").value();
  ASSERT_TRUE(sdm.limit(Rpm(3000), Metres(1e-6), 1, meter).ok());
  expectSmallPieces(meter);
  EXPECT_GT(meter.total(), 10.0 * WorkMeter::kLargestPiece);
}

// What is asked for after the stop is refused; little may be asked for at all before the work is given up.
TEST(WorkMeter, AfterAStopEveryMethodGivesUp) {
  std::stop_source stop;
  stop.request_stop();
  for (const Extreme& extreme : extremes()) {
    SCOPED_TRACE(extreme.name);
    LimitOptions options;
    options.maxAxialDepth = Metres(extreme.depth);
    WorkMeter exact(stop.get_token());
    const auto lobes = ExactLobes::make(extreme.model, "extreme").value();
    const auto limits = lobes.limits(Rpm(extreme.rpm), options, exact);
    EXPECT_LE(exact.total(), 5.0 * WorkMeter::kLargestPiece);
    EXPECT_FALSE(limits->verified);
    EXPECT_EQ(limits->searchedTo.value, 0.0);
    WorkMeter discrete(stop.get_token());
    const auto sdm = SemiDiscretization::make(extreme.model, {40, 1}, "extreme").value();
    EXPECT_FALSE(sdm.limit(Rpm(extreme.rpm), Metres(extreme.depth), 80, discrete)->hasLimit());
    EXPECT_LE(discrete.total(), 5.0 * WorkMeter::kLargestPiece);
    WorkMeter zeroth(stop.get_token());
    const auto mean = ZerothOrder::make(extreme.model, "extreme").value();
    EXPECT_EQ(mean.limit(Rpm(extreme.rpm), Metres(extreme.depth), zeroth)->searchedTo.value, 0.0);
    EXPECT_LE(zeroth.total(), 5.0 * WorkMeter::kLargestPiece);
  }
}

}  // namespace
}  // namespace stillcut::milling
