// The band of a limit: what doubt of the model makes of it.
#include "core/milling/stability/limit_band.h"

#include <gtest/gtest.h>

#include "core/milling/stability/lobe_csv.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

const std::vector<Rpm> kSpeeds{Rpm(6000), Rpm(9000), Rpm(13000)};

LobeSweep limits() {
  SweepOptions options;
  options.limits = {Metres(10e-3), true, false, {}};
  return sweepLobes(textbookHalf(), kSpeeds, options, "band").value();
}

LimitBands bandsWith(const ModelSpread& spread) {
  return limitBands(textbookHalf(), kSpeeds, Metres(10e-3), spread, 1, "band").value();
}

// The limit is inverse to the force, exactly, so that its band is known.
TEST(LimitBand, OfTheForceAloneIsThatOfItsInverse) {
  ModelSpread spread;
  spread.force = 0.1;
  spread.samples = 200;
  const LimitBands bands = bandsWith(spread);
  const LobeSweep sweep = limits();
  for (std::size_t k = 0; k < kSpeeds.size(); ++k) {
    const double limit = sweep.speeds[k].crossings.front().depth.value;
    EXPECT_NEAR(bands.speeds[k].low.value / limit, 1.0 / (1.0 + 0.1282), 0.03);
    EXPECT_NEAR(bands.speeds[k].high.value / limit, 1.0 / (1.0 - 0.1282), 0.04);
  }
}

TEST(LimitBand, HoldsTheLimitAndGrowsWithTheDoubt) {
  const LimitBands narrow = bandsWith({0.002, 0.05, 0.03, 0.05}), wide = bandsWith({0.01, 0.2, 0.1, 0.2});
  const LobeSweep sweep = limits();
  for (std::size_t k = 0; k < kSpeeds.size(); ++k) {
    const Metres limit = sweep.speeds[k].crossings.front().depth;
    EXPECT_LT(narrow.speeds[k].low, limit);
    EXPECT_GT(narrow.speeds[k].high, limit);
    EXPECT_GT(wide.speeds[k].high - wide.speeds[k].low, narrow.speeds[k].high - narrow.speeds[k].low);
  }
}

TEST(LimitBand, StandsInTheTableAndIsTheSameEveryTime) {
  const LimitBands once = bandsWith({0.01, 0.2, 0.1, 0.1}), again = bandsWith({0.01, 0.2, 0.1, 0.1});
  const std::string csv = lobeCsv(limits(), once.speeds);
  EXPECT_EQ(csv, lobeCsv(limits(), again.speeds));
  EXPECT_NE(csv.find("frequency_hz,depth_low_mm,depth_high_mm\n6000,"), std::string::npos) << csv;
  EXPECT_NE(lobeJson(limits(), "x", once.speeds).find("band_mm"), std::string::npos);
}

TEST(LimitBand, NonsenseIsRefused) {
  for (const ModelSpread& bad :
       {ModelSpread{-0.1, 0, 0, 0}, ModelSpread{0, 0.9, 0, 0}, ModelSpread{0.01, 0, 0, 0, 2}}) {
    EXPECT_FALSE(limitBands(textbookHalf(), kSpeeds, Metres(10e-3), bad, 1, "band").ok());
  }
}

}  // namespace
}  // namespace stillcut::milling
