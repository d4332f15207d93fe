// The default detector on every shared real recording, its programmed speed told 2 % too low, right and 2 % too high:
// what is labelled chatter alarms within 0.3 s and is called chatter for nine tenths of its length; nothing alarms in
// what is labelled stable, idle or entry, nor anywhere in the files where nothing chatters.
#include <gtest/gtest.h>

#include "tests/support/real_cuts.h"

namespace stillcut::bench {
namespace {

constexpr double kMostDelay = 0.3;  // s
constexpr double kLeastPart = 0.9;

class RealCuts : public ::testing::TestWithParam<double> {};

TEST_P(RealCuts, ChatterAlarmsAndNothingElseDoes) {
  const std::vector<RealCut> cuts = realCuts(std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings");
  if (cuts.empty()) GTEST_SKIP() << "reference material not found: " << STILLCUT_SHARED_DIR;
  for (const RealCut& cut : cuts) {
    const std::string file = cut.file.filename().string();
    const auto judged = judgeRealCut(cut, cut.channels, GetParam(), {"energy-ratio"});
    ASSERT_TRUE(judged.ok()) << judged.error().line();
    const Tally& t = judged->front();
    EXPECT_EQ(t.falseInSegment, 0.0) << file << " from " << t.firstFalse;
    const double length = chatterLength(cut);
    if (!(length > 0.0)) continue;
    EXPECT_GE(t.delay, 0.0) << file;
    EXPECT_LE(t.delay, kMostDelay) << file;
    EXPECT_GE(t.chatter, kLeastPart * length) << file;
  }
}

INSTANTIATE_TEST_SUITE_P(ToldSpeed, RealCuts, ::testing::Values(-0.02, 0.0, 0.02));

}  // namespace
}  // namespace stillcut::bench
