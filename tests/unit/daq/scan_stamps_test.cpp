// The time stamps of scans: losses to the scan, the clock they run on, and devices whose stamps tell nothing.
#include "core/daq/scan_stamps.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace stillcut::daq {
namespace {

constexpr double kRate = 4000.0;
constexpr std::int64_t kPeriod = 250'000;  // ns
constexpr int kBatch = 40;

struct Heard {
  std::vector<int> lostBefore;  // indices of scans that follow a loss
  double worst = 0.0;           // s: taken() less truth, once believed
};

// Scans in batches of 10 ms that arrive up to 5 ms late; stamp(i) is the device's stamp of scan i, taken at at(i).
template <typename At, typename Stamp>
Heard hear(int scans, At at, Stamp stamp) {
  std::mt19937 random(5);
  std::uniform_int_distribution<std::int64_t> late(50'000, 5'000'000);
  ScanStamps stamps;
  stamps.prepare(Hertz(kRate));
  Heard heard;
  for (int begin = 0; begin + kBatch <= scans; begin += kBatch) {
    std::vector<std::int64_t> batch;
    for (int i = begin; i < begin + kBatch; ++i) batch.push_back(stamp(i));
    stamps.arrived(batch.back(), instantFromNs(at(begin + kBatch - 1) + late(random)));
    for (std::span<const std::int64_t> left = batch; !left.empty();) {
      const int run = stamps.run(left.first(std::min<std::size_t>(left.size(), 16)));
      const int scan = begin + kBatch - static_cast<int>(left.size());
      if (run == 0) heard.lostBefore.push_back(scan);
      left = left.subspan(static_cast<std::size_t>(run));
    }
    if (stamps.believed() && begin > scans / 2) {
      const double off = secondsBetween(instantFromNs(at(begin)), stamps.taken(stamp(begin))).value;
      heard.worst = std::max(heard.worst, std::abs(off));
    }
  }
  return heard;
}

TEST(ScanStamps, FindEveryMissingScanAndTellTheTimeOfTheOthers) {
  // One scan missing before number 1000, ten before 1017, ten thousand before 2000; a clock that is a day ahead and
  // 50 ppm fast.
  const auto at = [](int i) {
    return 1'000'000'000 + kPeriod * (i + (i >= 1000 ? 1 : 0) + (i >= 1017 ? 10 : 0) + (i >= 2000 ? 10'000 : 0));
  };
  const Heard heard = hear(8000, at, [&](int i) { return at(i) + at(i) / 20'000 + 86'400'000'000'000; });
  EXPECT_EQ(heard.lostBefore, (std::vector<int>{1000, 1017, 2000}));
  EXPECT_LT(heard.worst, 2e-3);
}

TEST(ScanStamps, OfADeviceThatStampsByTheBatchAreNotBelieved) {
  const auto at = [](int i) { return kPeriod * i; };
  const Heard heard = hear(4000, at, [&](int i) { return at(i - i % 16); });
  EXPECT_TRUE(heard.lostBefore.empty());
  EXPECT_EQ(heard.worst, 0.0);
}

TEST(ScanStamps, JitterOfAStampIsNoLoss) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> jitter(0, kPeriod / 3);
  std::vector<std::int64_t> stamps;
  for (int i = 0; i < 4000; ++i) stamps.push_back(kPeriod * i + jitter(random));
  const Heard heard = hear(
      4000, [](int i) { return kPeriod * i; }, [&](int i) { return stamps[static_cast<std::size_t>(i)]; });
  EXPECT_TRUE(heard.lostBefore.empty());
}

}  // namespace
}  // namespace stillcut::daq
