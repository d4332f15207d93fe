// What a profile knows of its cut reaches the strategies as stable speeds.

#include "app/compose/known_lobes.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/compose/profile_rig.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/lobe_case.h"
#include "core/pipeline/catalog.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

// The demo's profile with its cut's own modes beside it.
class KnownLobes : public testing::Test {
 protected:
  void SetUp() override {
    const auto demo = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml");
    ASSERT_TRUE(demo.ok());
    const milling::LobeCase cut{.name = "demo", .model = demo->model, .maxAxialDepth = Metres(5e-3), .reference = {}};
    ASSERT_TRUE(milling::saveLobeCase(cut, path("cut.toml")).ok());
    auto read = config::loadProfile(STILLCUT_SOURCE_DIR "/resources/profiles/simulated.toml", pipeline::fullCatalog());
    ASSERT_TRUE(read.ok()) << read.error().line();
    profile_ = *read;
    profile_.source.settings["scenario"] = STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml";
    profile_.model = "cut.toml";
    profile_.depth = Metres(1.5e-3);
  }
  std::string path(const char* file) const { return folder_ / file; }

  record::TempFolder folder_;
  config::Profile profile_;
};

TEST_F(KnownLobes, OfAProfilesModelReachTheStrategies) {
  const auto rig = buildProfileRig(profile_, path("mill.toml"));
  ASSERT_TRUE(rig.ok()) << rig.error().line();
  const auto& known = (*rig)->setup().stableSpeeds;
  ASSERT_TRUE(known.has_value());
  EXPECT_EQ(known->depth.value, 1.5e-3);
  bool demoPocket = false, programmed = false;
  for (const StableSpeeds::Range& r : known->ranges) {
    demoPocket = demoPocket || (r.from < Rpm(7030.0) && r.to > Rpm(7030.0));
    programmed = programmed || (r.from < Rpm(8500.0) && r.to > Rpm(8500.0));
  }
  EXPECT_TRUE(demoPocket);  // where the scenario's own text says that 1.8 mm are stable
  EXPECT_FALSE(programmed) << "1.5 mm are too deep for the programmed speed";
}

TEST_F(KnownLobes, WithoutAModelNothingIsKnown) {
  profile_.model.clear();
  const auto rig = buildProfileRig(profile_, path("mill.toml"));
  ASSERT_TRUE(rig.ok()) << rig.error().line();
  EXPECT_FALSE((*rig)->setup().stableSpeeds.has_value());
}

TEST_F(KnownLobes, WithoutADepthTheCutRunsAndNothingIsKnown) {
  profile_.depth = {};
  const auto shallow = buildProfileRig(profile_, path("mill.toml"));
  ASSERT_TRUE(shallow.ok()) << shallow.error().line();
  EXPECT_FALSE((*shallow)->setup().stableSpeeds.has_value());
}

// Of the tool in the spindle, not of the one the modes were measured with.
TEST_F(KnownLobes, AnUnevenPitchHasStableSpeedsOfItsOwn) {
  const auto even = stableSpeeds(profile_, path("cut.toml"));
  profile_.pitch = {80.0, 100.0, 80.0, 100.0};
  const auto uneven = stableSpeeds(profile_, path("cut.toml"));
  ASSERT_TRUE(even.ok() && uneven.ok());
  ASSERT_TRUE(even.value() && uneven.value());
  const auto edges = [](const StableSpeeds& speeds) {
    std::vector<double> list;
    for (const auto& range : speeds.ranges) list.insert(list.end(), {range.from.value, range.to.value});
    return list;
  };
  EXPECT_NE(edges(**even), edges(**uneven));
  const auto lobes = milling::ExactLobes::make(cutOfProfile(profile_, path("cut.toml"))->model, "cut");
  ASSERT_TRUE(lobes.ok());
  for (const auto& range : (*uneven)->ranges) {
    const auto limits = lobes->limits(range.best, {4.0 * profile_.depth, true, false, {}});
    ASSERT_TRUE(limits.ok());
    EXPECT_TRUE(limits->stableAt(profile_.depth)) << range.best.value;
  }
}

TEST_F(KnownLobes, TheProfileNamesAMaterialOfTheTable) {
  const double own = cutOfProfile(profile_, path("cut.toml"))->model.material.tangential;
  profile_.material = "7075-T6";
  const auto cut = cutOfProfile(profile_, path("cut.toml"));
  ASSERT_TRUE(cut.ok());
  EXPECT_NE(cut->model.material.tangential, own);
  EXPECT_EQ(cut->model.material.tangential, 767e6);
  profile_.material = "7075-T8";
  const auto unknown = stableSpeeds(profile_, path("cut.toml"));
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().line().find("did you mean '7075-T6'?"), std::string::npos) << unknown.error().line();
}

TEST_F(KnownLobes, AModelThatIsMissingOrOfAnotherToolIsOneLine) {
  profile_.model = "absent.toml";
  auto rig = buildProfileRig(profile_, path("mill.toml"));
  ASSERT_FALSE(rig.ok());
  EXPECT_NE(rig.error().line().find("absent.toml"), std::string::npos) << rig.error().line();
  profile_.model = "cut.toml";
  profile_.cut.teeth = 3;
  rig = buildProfileRig(profile_, path("mill.toml"));
  ASSERT_FALSE(rig.ok());
  EXPECT_NE(rig.error().line().find("the tool has 4 teeth (the profile's has 3)"), std::string::npos)
      << rig.error().line();
}

}  // namespace
}  // namespace stillcut::app
