// BlockRun against a recording of the same samples, and what it refuses.

#include "app/embed/block_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include "app/compose/recording_rig.h"
#include "app/compose/scenario_rig.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

using ::testing::HasSubstr;

constexpr int kRate = 12800;

std::vector<float> noise(std::size_t n) {
  std::vector<float> x;
  std::uint32_t state = 1;
  for (std::size_t k = 0; k < n; ++k) {
    state = 1664525U * state + 1013904223U;
    x.push_back(static_cast<float>(state >> 8U) / 16777216.0F - 0.5F + (k % 32 < 4 ? 1.0F : 0.0F));
  }
  return x;
}

void writeFloatWav(const std::string& path, const std::vector<float>& x) {
  SF_INFO info{};
  info.samplerate = kRate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  ASSERT_NE(file, nullptr);
  sf_write_float(file, x.data(), static_cast<sf_count_t>(x.size()));
  sf_close(file);
}

BlockRunOptions optionsOf(std::vector<ChannelInfo> channels) {
  BlockRunOptions options;
  options.setup.rate = Hertz(kRate);
  options.setup.teeth = 2;
  options.setup.nominalSpeed = Rpm(12'000);
  options.setup.channels = std::move(channels);
  return options;
}

TEST(BlockRun, SaysWhatARecordingOfTheSameSamplesGives) {
  const record::TempFolder folder;
  const std::string path = folder / "x.wav";
  const auto x = noise(4 * kRate);
  writeFloatWav(path, x);
  RecordingOptions recording;
  recording.teeth = 2;
  recording.speed = Rpm(12'000);
  auto built = buildRecordingRig(path, recording);
  ASSERT_TRUE(built.ok()) << built.error().line();
  std::vector<Verdict> wanted;
  built->rig->runToEnd([&](const StepInput&, const StepOutput& out) { wanted.push_back(out.verdicts[0]); });

  auto run = BlockRun::build(optionsOf(built->rig->setup().channels));
  ASSERT_TRUE(run.ok()) << run.error().line();
  std::vector<Verdict> got;
  const auto keep = [&](const StepInput&, const StepOutput& out) { got.push_back(out.verdicts[0]); };
  const std::span<const float> all(x);
  (*run)->feed(all.first(777), Rpm{}, keep);
  (*run)->feed(all.subspan(777), Rpm{}, keep);
  (*run)->finish(keep);
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t k = 0; k < got.size(); ++k) {
    EXPECT_EQ(got[k].time, wanted[k].time);
    EXPECT_EQ(got[k].state, wanted[k].state);
    EXPECT_EQ(got[k].reason.code, wanted[k].reason.code);
    EXPECT_EQ(got[k].severity.value, wanted[k].severity.value);
    EXPECT_EQ(got[k].frequency.value, wanted[k].frequency.value);
  }
}

TEST(BlockRun, RefusesWithOneLine) {
  const auto lineOf = [](const BlockRunOptions& options) {
    const auto run = BlockRun::build(options);
    return run.ok() ? std::string() : run.error().line();
  };
  EXPECT_THAT(lineOf(optionsOf({})), HasSubstr("no channel"));
  EXPECT_THAT(lineOf(optionsOf(std::vector<ChannelInfo>(33))), HasSubstr("33"));
  auto options = optionsOf({ChannelInfo{}});
  EXPECT_EQ(lineOf(options), "");
  options.detectors = {"magic"};
  EXPECT_THAT(lineOf(options), HasSubstr("magic"));
  options.detectors = {};
  EXPECT_THAT(lineOf(options), HasSubstr("detectors"));
  options = optionsOf({ChannelInfo{}});
  options.setup.rate = Hertz(50.0);
  EXPECT_THAT(lineOf(options), HasSubstr("rate"));
}

}  // namespace
}  // namespace stillcut::app
