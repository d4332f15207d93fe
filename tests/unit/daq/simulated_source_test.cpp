#include "core/daq/simulated/simulated_source.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/daq/registry.h"

namespace stillcut::daq {
namespace {

milling::Scenario demo() {
  Result<milling::Scenario> s = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml");
  if (!s) throw std::runtime_error(s.error().line());
  s->programme.duration = Seconds(0.5);
  return *s;
}

std::vector<float> readAll(SimulatedSource& source, int channels, int frames) {
  SampleBlock block;
  block.allocate(channels, frames);
  std::vector<float> all;
  while (source.read(block)) {
    const auto v = block.channel(0);
    all.insert(all.end(), v.begin(), v.end());
  }
  return all;
}

TEST(SimulatedSource, FormatIsTheScenarios) {
  SimulatedSource source(demo(), 0, nullptr);
  const Result<SourceFormat> format = source.open();
  ASSERT_TRUE(format.ok());
  EXPECT_EQ(format->rate.value, 25600.0);
  EXPECT_EQ(format->blockFrames, 256);
  ASSERT_EQ(format->channels.size(), 2U);
  EXPECT_EQ(format->channels[1].axis, "y");
  EXPECT_NEAR(format->channels[0].scale * 0.0102, 1.0, 1e-12);  // 100 mV/g in volts
}

TEST(SimulatedSource, UnpacedItStartsAtZeroAndEndsPlainly) {
  SimulatedSource source(demo(), 3, nullptr);
  ASSERT_TRUE(source.open().ok());
  SampleBlock block;
  block.allocate(2, 256);
  ASSERT_TRUE(source.read(block));
  EXPECT_EQ(block.firstSample, Instant{});
  EXPECT_EQ(readAll(source, 2, 256).size(), 12800U - 256U);
  EXPECT_FALSE(source.read(block));
  EXPECT_TRUE(source.fault().empty());
  EXPECT_FALSE(source.live());
}

TEST(SimulatedSource, TheSeedDecides) {
  SimulatedSource a(demo(), 3, nullptr), b(demo(), 3, nullptr), c(demo(), 4, nullptr);
  for (SimulatedSource* s : {&a, &b, &c}) ASSERT_TRUE(s->open().ok());
  const std::vector<float> first = readAll(a, 2, 256);
  EXPECT_EQ(first, readAll(b, 2, 256));
  EXPECT_NE(first, readAll(c, 2, 256));
}

TEST(SimulatedSource, StopEndsIt) {
  SimulatedSource source(demo(), 0, nullptr);
  ASSERT_TRUE(source.open().ok());
  SampleBlock block;
  block.allocate(2, 256);
  ASSERT_TRUE(source.read(block));
  source.stop();
  EXPECT_FALSE(source.read(block));
}

TEST(SimulatedSource, PacedItRunsOnTheSteadyClockAndAheadOfItByNothing) {
  milling::Scenario s = demo();
  s.programme.duration = Seconds(0.02);
  SimulatedSource source(s, 0, nullptr, {true, 1.0});
  ASSERT_TRUE(source.open().ok());
  const Instant before = SteadyClock().now();  // the cut begins with the first read, not when it was opened
  SampleBlock block;
  block.allocate(2, 256);
  while (source.read(block)) {
    EXPECT_GE(block.firstSample, before);
    EXPECT_GE(SteadyClock().now(), block.end());
  }
}

TEST(SourceRegistry, MakesWhatItListsAndNamesTheKnown) {
  const milling::Scenario s = demo();
  SourceRequest request;
  EXPECT_FALSE(makeSource("simulated", request).ok());
  request.scenario = &s;
  EXPECT_TRUE(makeSource("simulated", request).ok());
  const auto unknown = makeSource("smulated", request);
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().line().find("simulated"), std::string::npos);
}

}  // namespace
}  // namespace stillcut::daq
