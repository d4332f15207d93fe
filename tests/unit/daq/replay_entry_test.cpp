// The table of devices: the line "replay" gives a recording's own samples, and refuses in one line what is no
// recording.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "core/base/time.h"
#include "core/daq/registry.h"
#include "tests/support/temp_folder.h"

namespace stillcut::daq {
namespace {

constexpr int kFrames = 700;

struct RegistryReplay : ::testing::Test {
  std::string recorded() const {
    std::string text = "time [s],x [m/s^2]\n";
    for (int k = 0; k < kFrames; ++k) text += std::to_string(k * 1e-3) + ',' + std::to_string(std::sin(0.1 * k)) + '\n';
    return folder.file("cut.csv", text);
  }
  Result<std::unique_ptr<DaqSource>> made(std::map<std::string, std::string> settings) {
    SourceRequest request;
    request.settings = std::move(settings);
    request.clock = &clock;
    return makeSource("replay", request);
  }
  record::TempFolder folder;
  SteadyClock clock;
};

TEST_F(RegistryReplay, GivesEverySampleOfTheRecordingAtItsOwnRate) {
  auto source = made({{"file", recorded()}, {"pace", "10"}});
  ASSERT_TRUE(source) << source.error().line();
  const auto format = (*source)->open();
  ASSERT_TRUE(format) << format.error().line();
  EXPECT_NEAR(format->rate.value, 1000.0, 1e-6);
  ASSERT_EQ(format->channels.size(), 1U);
  EXPECT_FALSE((*source)->live());  // a recorded cut may not drive a real machine
  SampleBlock block;
  block.allocate(1, format->blockFrames);
  int frames = 0;
  while ((*source)->read(block)) {
    for (int f = 0; f < block.frames; ++f, ++frames) {
      ASSERT_NEAR(block.channel(0)[static_cast<std::size_t>(f)], std::sin(0.1 * frames), 1e-5) << frames;
    }
  }
  EXPECT_EQ(frames, kFrames);
}

TEST_F(RegistryReplay, RefusesInOneLineWhatIsMissingOrNoRecording) {
  const auto none = made({});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().line().find("file"), std::string::npos) << none.error().line();
  const auto absent = made({{"file", folder / "no-such.wav"}});
  ASSERT_FALSE(absent);
  EXPECT_NE(absent.error().line().find("no-such.wav"), std::string::npos) << absent.error().line();
  const auto backwards = made({{"file", recorded()}, {"pace", "-1"}});
  ASSERT_FALSE(backwards);
  EXPECT_NE(backwards.error().line().find("pace"), std::string::npos) << backwards.error().line();
}

}  // namespace
}  // namespace stillcut::daq
