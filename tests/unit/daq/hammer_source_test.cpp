// The simulated tap test: what its channels deliver.
#include "core/daq/simulated/hammer_source.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/daq/registry.h"

namespace stillcut::daq {
namespace {

// Samples of the first seconds, by channel.
std::vector<std::vector<float>> heard(DaqSource& source, double seconds) {
  const auto format = source.open();
  EXPECT_TRUE(format.ok());
  SampleBlock block;
  block.allocate(static_cast<int>(format->channels.size()), format->blockFrames);
  std::vector<std::vector<float>> all(format->channels.size());
  std::uint64_t sequence = 0;
  while (static_cast<double>(all[0].size()) < seconds * format->rate.value && source.read(block)) {
    EXPECT_EQ(block.sequence, sequence++);
    for (std::size_t c = 0; c < all.size(); ++c) {
      const auto more = block.channel(static_cast<int>(c));
      all[c].insert(all[c].end(), more.begin(), more.end());
    }
  }
  return all;
}

float largest(const std::vector<float>& samples) {
  float most = 0.0F;
  for (const float v : samples) most = std::max(most, std::abs(v));
  return most;
}

TEST(HammerSource, HitsAlongTheAxisThatWasAskedFor) {
  for (const bool alongY : {false, true}) {
    HammerSourceOptions options;
    options.pace = 0.0;
    options.faults = false;
    options.alongY = alongY;
    HammerSource source(options);
    const auto samples = heard(source, 2.0);
    EXPECT_GT(largest(samples[0]), 100.0F) << "a blow";
    const auto along = largest(samples[alongY ? 2 : 1]), across = largest(samples[alongY ? 1 : 2]);
    EXPECT_GT(along, 5.0F * across);
    EXPECT_GT(across, 0.0F) << "a hand is never quite straight";
  }
}

TEST(HammerSource, IsMadeFromAProfileAndRefusesNonsense) {
  SourceRequest request;
  request.settings = {{"axis", "y"}, {"pace", "0"}};
  EXPECT_TRUE(makeSource("simulated-hammer", request).ok());
  request.settings = {{"axis", "z"}};
  const auto wrong = makeSource("simulated-hammer", request);
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().line().find("axis"), std::string::npos) << wrong.error().line();
}

TEST(HammerSource, EndsWhenItIsStopped) {
  HammerSourceOptions options;
  options.pace = 0.0;
  HammerSource source(options);
  const auto format = source.open();
  ASSERT_TRUE(format.ok());
  SampleBlock block;
  block.allocate(3, format->blockFrames);
  EXPECT_TRUE(source.read(block));
  source.stop();
  EXPECT_FALSE(source.read(block));
  EXPECT_TRUE(source.fault().empty());
}

}  // namespace
}  // namespace stillcut::daq
