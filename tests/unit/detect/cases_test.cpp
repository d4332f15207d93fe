// Simulated cuts with known truth: every channel alone and both, told speed right and 3 % off either way.
#include "tests/support/recording_runner.h"

namespace stillcut::detect::testing {
namespace {

struct Case {
  const char* name;
  int teeth;
  double rpm;
  double earliest;   // s; the 1 % time, less 50 ms where the depth is still changing slowly
  double latest;     // s; the 20 % time plus the allowance
  double chatterHz;  // at onset
  double airFrom;    // s; no alarm afterwards (0: to the end in cut)
};

// onset_1pct_s, onset_20pct_s and chatter_hz_at_onset of the cases' json files.
constexpr Case kChatter[] = {
    {"c2_hopf", 2, 11000.0, 0.841 - 0.050, 0.927 + 0.010, 939.2, 0.0},
    {"c6_air_entry_chatter_exit", 3, 6300.0, 1.992 - 0.050, 2.080 + 0.010, 806.25, 3.3},
    {"c7b_xu_800rpm", 4, 800.0, 3.201, 3.843 + 0.040, 198.9, 0.0},
};

std::filesystem::path wav(const char* name) {
  return sharedDir() / "cases" / (std::string(name) + "_acc.wav");
}

const std::vector<std::vector<int>> kChannelSets{{}, {0}, {1}};

TEST(Cases, StableCutIsSilent) {
  STILLCUT_NEEDS(wav("c1_stable"));
  const Recording recording = readWav(wav("c1_stable"));
  for (const auto& channels : kChannelSets) {
    for (const double error : {0.0, -0.03, 0.03}) {
      RunOptions options;
      options.teeth = 2;
      options.rpm = 11000.0 * (1.0 + error);
      options.channels = channels;
      const RunResult r = run(recording, options);
      EXPECT_LT(r.firstAlarm, 0.0) << error;
      // Found to be a cut although the recording has no air to compare with, and its speed found to 0.1 %.
      EXPECT_EQ(r.verdicts.back().state, CutState::Stable);
      EXPECT_NEAR(r.verdicts.back().spindle.value, 11000.0 / 60.0, 1e-3 * 11000.0 / 60.0);
    }
  }
}

TEST(Cases, ChatterAlarmsBetweenOneAndTwentyPercent) {
  for (const Case& c : kChatter) {
    STILLCUT_NEEDS(wav(c.name));
    const Recording recording = readWav(wav(c.name));
    for (const auto& channels : kChannelSets) {
      for (const double error : {0.0, -0.03, -0.02, 0.02, 0.03}) {
        SCOPED_TRACE(std::string(c.name) + " told speed off by " + std::to_string(error) + " channels " +
                     (channels.empty() ? "all" : std::to_string(channels[0])));
        RunOptions options;
        options.teeth = c.teeth;
        options.rpm = c.rpm * (1.0 + error);
        options.channels = channels;
        const RunResult r = run(recording, options);
        EXPECT_GE(r.firstAlarm, c.earliest);
        EXPECT_LE(r.firstAlarm, c.latest);
        EXPECT_NEAR(r.at(r.firstAlarm + 0.05).frequency.value, c.chatterHz, 0.005 * c.chatterHz);
        if (c.airFrom > 0.0) {
          EXPECT_LT(r.firstAlarmAfter(c.airFrom), 0.0);
        }
      }
    }
  }
}

TEST(Cases, ChatterIsHeldOnceItIsFull) {
  const Case& c = kChatter[0];
  STILLCUT_NEEDS(wav(c.name));
  RunOptions options;
  options.teeth = c.teeth;
  options.rpm = c.rpm;
  const RunResult r = run(readWav(wav(c.name)), options);
  int chatter = 0;
  int all = 0;
  for (const Verdict& v : r.verdicts) {
    if (sinceEpoch(v.time).value < 1.1) continue;
    ++all;
    chatter += v.state == CutState::Chatter ? 1 : 0;
  }
  EXPECT_EQ(chatter, all);
  EXPECT_GT(r.verdicts.back().severity.value, 0.2);
  EXPECT_GT(r.verdicts.back().sinceOnset.value, 0.9);
  // 10 mm/s of feed in the runner's setup.
  EXPECT_NEAR(r.verdicts.back().feedSinceOnset.value, 0.01 * r.verdicts.back().sinceOnset.value, 2e-4);
}

TEST(Cases, BlockSizeDoesNotMatter) {
  const Case& c = kChatter[0];
  STILLCUT_NEEDS(wav(c.name));
  const Recording recording = readWav(wav(c.name));
  for (const int frames : {16, 100, 256}) {
    RunOptions options;
    options.teeth = c.teeth;
    options.rpm = c.rpm;
    options.blockFrames = frames;
    const RunResult r = run(recording, options);
    EXPECT_GE(r.firstAlarm, c.earliest) << frames;
    EXPECT_LE(r.firstAlarm, c.latest + frames / recording.rate) << frames;
  }
}

}  // namespace
}  // namespace stillcut::detect::testing
