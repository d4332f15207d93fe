// Judged cuts of a run end in the store of cuts, and a run that does not say what it cuts leaves it alone.
#include "app/compose/learn/evidence_log.h"

#include <gtest/gtest.h>

#include "core/learn/evidence_store.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

constexpr const char* kModel =
    "[[mode]]\nfrequency_hz = 950.0\ndamping = 0.02\nstiffness_n_per_m = 3e6\ndirection = [1.0, 0.0]\n"
    "[tool]\nteeth = 4\ndiameter_mm = 10.0\n[engagement]\nradial_immersion = 0.5\nside = \"up\"\n"
    "[material]\ntangential_n_per_m2 = 6e8\nradial_n_per_m2 = 2e8\n";

config::Profile profileOf(const std::string& model) {
  config::Profile profile;
  profile.cut.machine = "Mill 3";
  profile.cut.tool = "T12";
  profile.cut.teeth = 4;
  profile.holder = "ER32";
  profile.stickOut = Metres(48e-3);
  profile.depth = Metres(1.5e-3);
  profile.model = model;
  return profile;
}

// A second of air, and `seconds` of one state.
void pass(EvidenceLog& log, Instant& time, CutState state, double seconds) {
  Snapshot snapshot;
  snapshot.detectorCount = 1;
  Verdict& v = snapshot.verdicts[0];
  v.valid = true;
  v.spindle = Hertz(140.0);
  const auto show = [&](CutState shown, CutPhase phase, double length) {
    v.state = shown;
    v.phase = phase;
    v.frequency = Hertz(shown == CutState::Chatter ? 912.0 : 0.0);
    for (int i = 0; i < static_cast<int>(20.0 * length); ++i) {
      v.time = time = time + toDuration(Seconds(0.05));
      log.look(snapshot);
    }
  };
  show(CutState::AirCutting, CutPhase::AirCutting, 1.0);
  show(state, CutPhase::Steady, seconds);
}

TEST(EvidenceLog, KeepsTheJudgedCutsOfARun) {
  const record::TempFolder folder;
  const std::string path = folder.file("model.toml", kModel);
  const auto common = evidenceOf(profileOf(path), folder / "profile.toml");
  ASSERT_TRUE(common.ok()) << common.error().line();
  ASSERT_TRUE(common->has_value());
  {
    EvidenceLog log(**common, folder / "new/cuts.sqlite");
    Instant time = instantFromNs(5'000'000'000);
    pass(log, time, CutState::Stable, 4.0);
    pass(log, time, CutState::Chatter, 1.0);
    log.finish();
    EXPECT_TRUE(log.problem().empty()) << text(log.problem());
  }
  const auto cuts = learn::EvidenceStore::open(folder / "new/cuts.sqlite").value().cuts().value();
  ASSERT_EQ(cuts.size(), 2U);
  int chattered = 0;
  for (const learn::CutEvidence& cut : cuts) {
    EXPECT_EQ(cut.assembly.tool, "T12");
    EXPECT_EQ(cut.assembly.holder, "ER32");
    EXPECT_DOUBLE_EQ(cut.assembly.stickOut.value, 48e-3);
    EXPECT_EQ(cut.depth, Metres(1.5e-3));
    EXPECT_EQ(cut.diameter, Metres(10e-3));
    EXPECT_EQ(cut.engagement.radialImmersion, 0.5);
    EXPECT_NEAR(cut.speed.value, 8400.0, 1.0);
    chattered += cut.outcome == learn::CutOutcome::Chatter ? 1 : 0;
  }
  EXPECT_EQ(chattered, 1);
}

TEST(EvidenceLog, SaysWhyNothingCanBeKept) {
  const record::TempFolder folder;
  const std::string other = folder.file("notes.txt", "a shop's notes that are no store of cuts, however often asked");
  const std::string path = folder.file("model.toml", kModel);
  EvidenceLog log(**evidenceOf(profileOf(path), folder / "profile.toml"), other);
  Instant time = instantFromNs(5'000'000'000);
  pass(log, time, CutState::Stable, 4.0);
  log.finish();
  EXPECT_FALSE(log.problem().empty());
}

TEST(EvidenceLog, NeedsToKnowWhatIsCut) {
  config::Profile profile = profileOf("");
  EXPECT_FALSE(evidenceOf(profile, "profile.toml")->has_value());
  profile = profileOf("missing.toml");
  EXPECT_FALSE(evidenceOf(profile, "profile.toml").ok());
  profile.depth = Metres{};
  EXPECT_FALSE(evidenceOf(profile, "profile.toml")->has_value());
}

}  // namespace
}  // namespace stillcut::app
