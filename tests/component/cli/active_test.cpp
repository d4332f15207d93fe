// simulate --strategy active: Ford's cuts with the active work-holder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/component/cli/made_files.h"
#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string scenario(const std::string& name) {
  return std::string(STILLCUT_SOURCE_DIR) + "/resources/scenarios/" + name + ".toml";
}

class Active : public testing::Test {
 protected:
  // The scenario with other text in the place of some; gives the name of its copy.
  std::string changed(const std::string& name, const std::map<std::string, std::string>& changes) {
    std::ifstream file(scenario(name));
    std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const auto& [from, to] : changes) {
      EXPECT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    std::ofstream(folder_ / (name + ".toml")) << text;
    return folder_ / (name + ".toml");
  }
  json simulate(const std::string& name, std::vector<std::string> more = {}) {
    return simulateFile(scenario(name), std::move(more));
  }
  json simulateFile(const std::string& file, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"simulate", file, "--strategy", "active", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runCli(folder_ / "", arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }
  // dB by axis at the line nearest to a frequency.
  static double attenuation(const json& answer, const std::string& axis, double frequency) {
    double best = 1e300;
    double db = 0.0;
    for (const json& line : answer["attenuation_db"]) {
      const double distance = std::abs(line["frequency_hz"].get<double>() - frequency);
      if (line["axis"] != axis || distance >= best) continue;
      best = distance;
      db = line["db"];
    }
    return db;
  }
  record::TempFolder folder_;
};

TEST_F(Active, TheUnstableCutBecomesStable) {
  const json answer = simulate("ford-unstable", {"--out", "held.wav"});
  EXPECT_EQ(answer["strategy"], "active");
  EXPECT_TRUE(answer["chatter_alone"].get<bool>());
  EXPECT_EQ(answer["outcome"], "stable");
  for (const json& axis : answer["axes"]) {
    EXPECT_TRUE(axis["released"].is_null()) << axis["released"];
    EXPECT_LE(axis["stroke_used"].get<double>(), 1.0);
    EXPECT_LT(axis["path_residual"].get<double>(), 0.1);
    EXPECT_GT(axis["path_phase_left_deg"].get<double>(), 60.0);
    const std::string name = axis["axis"];
    EXPECT_GE(attenuation(answer, name, answer["chatter_hz"]), 23.0) << name;
    EXPECT_GE(attenuation(answer, name, 339.0), 23.0) << name;
    EXPECT_GE(attenuation(answer, name, 1024.0), 24.5) << name;
    std::printf("%s: %.1f dB at %.1f Hz, %.1f dB at 339 Hz, %.1f dB at 1024 Hz\n", name.c_str(),
                attenuation(answer, name, answer["chatter_hz"]), answer["chatter_hz"].get<double>(),
                attenuation(answer, name, 339.0), attenuation(answer, name, 1024.0));
  }
  EXPECT_LT(answer["final_ratio"].get<double>(), 0.1);
  EXPECT_LT(answer["growth_per_s"].get<double>(), 0.3);
  const Outcome info = runCli(folder_ / "", {"info", "held.wav"});
  EXPECT_EQ(info.exitCode, 0);
  EXPECT_THAT(info.out, HasSubstr("5000 Hz"));
}

TEST_F(Active, TheStableCutStaysStableAndGetsQuieter) {
  const json answer = simulate("ford-stable");
  EXPECT_FALSE(answer["chatter_alone"].get<bool>());
  EXPECT_EQ(answer["outcome"], "stable");
  EXPECT_LT(answer["final_ratio"].get<double>(), 1.0);
  EXPECT_GE(attenuation(answer, "y", 1000.0), 16.0);
  for (const json& axis : answer["axes"]) EXPECT_TRUE(axis["released"].is_null());
}

// Power within 5 Hz of a line over the last second of a channel: Hann window, bins of 1 Hz, summed here by hand.
double powerOf(const std::string& file, int channel, double frequency) {
  SF_INFO info{};
  SNDFILE* sound = sf_open(file.c_str(), SFM_READ, &info);
  EXPECT_NE(sound, nullptr) << file;
  if (sound == nullptr) return 0.0;
  std::vector<double> all(static_cast<std::size_t>(info.frames * info.channels));
  sf_readf_double(sound, all.data(), info.frames);
  sf_close(sound);
  const auto rate = static_cast<std::size_t>(info.samplerate);
  const auto channels = static_cast<std::size_t>(info.channels);
  const double* last = all.data() + all.size() - rate * channels;
  double power = 0.0;
  for (double bin = std::ceil(frequency - 5.0); bin <= frequency + 5.0; bin += 1.0) {
    std::complex<double> sum = 0.0;
    for (std::size_t n = 0; n < rate; ++n) {
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(rate);
      const double window = 0.5 - 0.5 * std::cos(turn);
      sum += window * last[n * channels + static_cast<std::size_t>(channel)] * std::polar(1.0, -bin * turn);
    }
    power += std::norm(sum);
  }
  return power;
}

// What is printed is what two recordings say: of the cut left alone, as --strategy monitor records it, and of the same
// cut with control.
TEST_F(Active, TheDecibelsAreThoseOfTheTwoRecordings) {
  for (const char* name : {"ford-unstable", "ford-stable"}) {
    const std::string cut = changed(name, {{"duration_s = 12.0", "duration_s = 4.0"}});
    const json answer = simulateFile(cut, {"--out", "held.wav"});
    const Outcome alone = runCli(folder_ / "", {"simulate", cut, "--strategy", "monitor", "--out", "alone.wav"});
    ASSERT_EQ(alone.exitCode, 0) << alone.err;
    ASSERT_FALSE(answer["attenuation_db"].empty());
    for (const json& line : answer["attenuation_db"]) {
      const int channel = line["axis"] == "x" ? 0 : 1;
      const double frequency = line["frequency_hz"];
      const double before = powerOf(folder_ / "alone.wav", channel, frequency);
      const double after = powerOf(folder_ / "held.wav", channel, frequency);
      EXPECT_NEAR(10.0 * std::log10(before / after), line["db"].get<double>(), 0.05)
          << name << " " << line["axis"] << " " << frequency;
    }
  }
}

// Released at once by a step far too large: then the cut is what it is without control.
TEST_F(Active, ACutThatIsLetGoChattersAndSaysSo) {
  const json answer =
      simulateFile(changed("ford-unstable", {{"duration_s = 12.0", "duration_s = 5.0"}}), {"--set", "active.step=1"});
  EXPECT_TRUE(answer["chatter_alone"].get<bool>());
  EXPECT_EQ(answer["outcome"], "chatter");
  EXPECT_NEAR(answer["final_ratio"].get<double>(), 1.0, 0.05);
}

// A device that takes 32 samples at a time makes the loop 32 samples late: what can be known beforehand is quietened
// all the same.
TEST_F(Active, RunsThroughADeviceOfBlocks) {
  const json answer = simulate("ford-stable", {"--set", "active.block-frames=32"});
  for (const json& axis : answer["axes"]) {
    EXPECT_GE(axis["loop_delay_ms"].get<double>(), 32.0 / 5.0);
    EXPECT_LE(axis["loop_delay_ms"].get<double>(), 34.0 / 5.0);
    EXPECT_TRUE(axis["promises_stable"].get<bool>());
    EXPECT_TRUE(axis["released"].is_null()) << axis["released"];
  }
  EXPECT_EQ(answer["outcome"], "stable");
  EXPECT_LT(answer["final_ratio"].get<double>(), 1.0);
}

TEST_F(Active, RunsAtFortyEightKilohertzInBlocksOfThirtyTwo) {
  const json answer = simulateFile(
      changed("ford-stable", {{"duration_s = 12.0", "duration_s = 4.0"}, {"rate_hz = 5000.0", "rate_hz = 48000.0"}}),
      {"--set", "active.block-frames=32", "--set", "active.identify-time=2"});
  for (const json& axis : answer["axes"]) {
    EXPECT_NEAR(axis["loop_delay_ms"].get<double>(), 32.0 / 48.0, 0.5);
    EXPECT_TRUE(axis["released"].is_null()) << axis["released"];
  }
  EXPECT_EQ(answer["outcome"], "stable");
  EXPECT_LT(answer["final_ratio"].get<double>(), 1.0);
  EXPECT_GE(attenuation(answer, "y", 1000.0), 6.0);
}

// The cutting force at the spindle's frequency falls; that at tooth passing cannot
// (tests/unit/milling/table_force_test).
TEST_F(Active, ForceFeedbackQuietensTheSpindleLineAndNoTableTheToothPassing) {
  const json answer = simulate("ford-stable", {"--set", "active.feedback=force"});
  EXPECT_EQ(answer["outcome"], "stable");
  for (const json& axis : answer["axes"]) {
    EXPECT_TRUE(axis["released"].is_null()) << axis["released"];
    EXPECT_LT(axis["stroke_used"].get<double>(), 1.0);
    const std::string name = axis["axis"];
    EXPECT_GE(attenuation(answer, name, 477.0 / 60.0), 6.0) << name;
    EXPECT_NEAR(attenuation(answer, name, 8.0 * 477.0 / 60.0), 0.0, 0.5) << name;
    std::printf("%s: %.1f dB at the spindle's line, %.2f dB at tooth passing\n", name.c_str(),
                attenuation(answer, name, 477.0 / 60.0), attenuation(answer, name, 8.0 * 477.0 / 60.0));
  }
  EXPECT_LE(answer["final_ratio"].get<double>(), 1.0);
}

// What the paths were identified from, kept, gives the same models as the loop made of it.
TEST_F(Active, APathIsIdentifiedFromARecordingToo) {
  const std::string cut = changed("ford-stable", {{"duration_s = 12.0", "duration_s = 3.0"}});
  const json answer = simulateFile(cut, {"--path-record", "paths.csv"});
  for (int a = 0; a < 2; ++a) {
    const Outcome told =
        runCli(folder_ / "", {"path", "paths.csv", "--output", std::to_string(2 * a), "--reading",
                              std::to_string(2 * a + 1), "--quieten", "990,1000", "--json", "--out", "fit.csv"});
    ASSERT_EQ(told.exitCode, 0) << told.err;
    const json path = json::parse(told.out, nullptr, false);
    const json& axis = answer["axes"][static_cast<std::size_t>(a)];
    EXPECT_NEAR(path["path_residual"].get<double>(), axis["path_residual"].get<double>(), 1e-3);
    EXPECT_NEAR(path["loop_delay_ms"].get<double>(), axis["loop_delay_ms"].get<double>(), 1e-6);
    EXPECT_TRUE(path["promises_stable"].get<bool>());
    EXPECT_NEAR(path["delay_left_ms"].get<double>(), axis["delay_left_ms"].get<double>(), 0.01);
    std::ifstream fit(folder_ / "fit.csv");
    std::string header;
    ASSERT_TRUE(std::getline(fit, header));
    EXPECT_EQ(header, "frequency_hz,measured_re,measured_im,modelled_re,modelled_im,coherence");
  }
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"path", "paths.csv", "--output", "0", "--reading", "0"},
        {"path", "paths.csv", "--output", "0", "--reading", "9"},
        {"path", "paths.csv", "--output", "0", "--reading", "1", "--quieten", "4000"},
        {"simulate", cut, "--strategy", "monitor", "--path-record", "p.csv"}}) {
    const Outcome outcome = runCli(folder_ / "", wrong);
    EXPECT_EQ(outcome.exitCode, 2) << spelled(wrong);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  }
}

// Without a line that is asked for LMS quietens what is loudest: less at 1000 Hz, more over all.
TEST_F(Active, WithoutEmphasisTheLoudestGoesFirst) {
  const json asked = simulate("ford-stable");
  const json plain = simulate("ford-stable", {"--set", "active.emphasis=1"});
  EXPECT_LT(plain["final_ratio"].get<double>(), asked["final_ratio"].get<double>());
  EXPECT_LT(attenuation(plain, "y", 1000.0), attenuation(asked, "y", 1000.0) - 6.0);
}

// A step far beyond what is stable: the gate lets go, and the cut is as if nobody had touched it.
TEST_F(Active, ALoopThatRunsAwayIsLetGo) {
  const json answer = simulate("ford-stable", {"--set", "active.step=1"});
  EXPECT_EQ(answer["outcome"], "stable");
  for (const json& axis : answer["axes"]) EXPECT_FALSE(axis["released"].is_null());
  EXPECT_NEAR(answer["final_ratio"].get<double>(), 1.0, 0.05);
}

TEST_F(Active, NeedsAWorkHolder) {
  writeScenario(folder_ / "cut.toml");
  const Outcome outcome = runCli(folder_ / "", {"simulate", "cut.toml", "--strategy", "active"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_THAT(outcome.err, HasSubstr("[work_holder]"));
  const Outcome session =
      runCli(folder_ / "", {"simulate", scenario("ford-stable"), "--strategy", "active", "--out", "a.h5"});
  EXPECT_EQ(session.exitCode, 2);
  EXPECT_THAT(session.err, HasSubstr(".wav"));
}

}  // namespace
}  // namespace stillcut::cli_test
