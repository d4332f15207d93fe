#include "core/milling/stability/lobe_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/milling/stability/lobe_csv.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

TEST(LobeCase, SharedCasesConvertWithoutLoss) {
  STILLCUT_NEEDS_REFERENCE();
  const record::TempFolder folder;
  for (const char* name : kReferenceNames) {
    const auto imported = loadLobeCase(referenceFile(std::string(name) + ".json").string());
    ASSERT_TRUE(imported.ok());
    const std::string path = folder / "convert.toml";
    ASSERT_TRUE(saveLobeCase(*imported, path).ok());
    const auto read = loadLobeCase(path);
    ASSERT_TRUE(read.ok()) << read.error().line();
    EXPECT_EQ(read->name, imported->name);
    EXPECT_EQ(read->maxAxialDepth, imported->maxAxialDepth);
    EXPECT_EQ(read->reference, imported->reference);
    ASSERT_EQ(read->model.modes.size(), imported->model.modes.size());
    for (std::size_t i = 0; i < read->model.modes.size(); ++i) {
      EXPECT_EQ(read->model.modes[i].frequency, imported->model.modes[i].frequency);
      EXPECT_EQ(read->model.modes[i].damping, imported->model.modes[i].damping);
      EXPECT_EQ(read->model.modes[i].stiffness, imported->model.modes[i].stiffness);
      EXPECT_EQ(read->model.modes[i].direction, imported->model.modes[i].direction);
    }
    EXPECT_EQ(read->model.material.tangential, imported->model.material.tangential);
    EXPECT_EQ(read->model.material.radial, imported->model.material.radial);
    EXPECT_EQ(read->model.engagement.radialImmersion, imported->model.engagement.radialImmersion);
    EXPECT_EQ(read->model.engagement.side, imported->model.engagement.side);
  }
}

TEST(LobeCase, BadFilesAreRefusedWithOneLine) {
  const record::TempFolder folder;
  const std::string path = folder / "bad.json";
  for (const char* text : {"", "{", "[]", "{\"name\": \"x\"}", "{\"name\": \"x\", \"modes\": 3}"}) {
    std::ofstream(path) << text;
    const auto read = loadLobeCase(path);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().line().find('\n'), std::string::npos);
  }
  EXPECT_FALSE(loadLobeCase(folder / "missing.json").ok());
  EXPECT_FALSE(loadLobeCase(folder / "missing.toml").ok());
}

std::string caseWith(const std::string& engagement, const std::string& material = "") {
  return "[[mode]]\nfrequency_hz = 900.0\ndamping = 0.02\nstiffness_n_per_m = 1e7\ndirection = [1.0, 0.0]\n"
         "[tool]\nteeth = 6\ndiameter_mm = 100.0\n[material]\ntangential_n_per_m2 = 2e9\nradial_n_per_m2 = 9e8\n" +
         material + "[engagement]\n" + engagement;
}

Result<LobeCase> readText(const record::TempFolder& folder, const std::string& text) {
  std::ofstream(folder / "cut.toml") << text;
  return loadLobeCase(folder / "cut.toml");
}

TEST(LobeCase, AnEngagementIsSaidByOffsetOrAngles) {
  const record::TempFolder folder;
  const auto centred = readText(folder, caseWith("radial_immersion = 0.6\noffset_mm = 0.0\n"));
  const auto angles = readText(folder, caseWith("start_deg = 53.1301\nexit_deg = 126.8699\n"));
  const auto both = readText(folder, caseWith("start_deg = 53.13\nexit_deg = 126.87\nradial_immersion = 0.6\n"));
  for (const auto* read : {&centred, &angles, &both}) {
    ASSERT_TRUE(read->ok()) << read->error().line();
    EXPECT_NEAR((*read)->model.engagement.startAngle(), std::acos(0.6), 1e-5);
    EXPECT_NEAR((*read)->model.engagement.exitAngle(), std::acos(-0.6), 1e-5);
    std::ofstream(folder / "again.toml") << lobeCaseText(read->value());
    const auto again = loadLobeCase(folder / "again.toml");
    ASSERT_TRUE(again.ok()) << again.error().line();
    EXPECT_EQ(again->model.engagement.startAngle(), (*read)->model.engagement.startAngle());
  }
  // 10 mm to the left of the centre: the left edge of the cut at 40 mm, the right one 20 mm to the right.
  const auto left = readText(folder, caseWith("radial_immersion = 0.6\noffset_mm = 10.0\n"));
  EXPECT_NEAR(left->model.engagement.startAngle(), std::acos(0.8), 1e-9);
  EXPECT_NEAR(left->model.engagement.exitAngle(), std::acos(-0.4), 1e-9);
  for (const char* bad :
       {"radial_immersion = 0.6\noffset_mm = 30.0\n", "start_deg = 90.0\nexit_deg = 60.0\n", "start_deg = 60.0\n",
        "start_deg = 60.0\nexit_deg = 90.0\nradial_immersion = 0.6\n", "radial_immersion = 0.6\n"}) {
    const auto refused = readText(folder, caseWith(bad));
    ASSERT_FALSE(refused.ok()) << bad;
    EXPECT_EQ(refused.error().line().find('\n'), std::string::npos);
  }
}

TEST(LobeCase, AWearLandSaysHowMuchTheFlankDamps) {
  const record::TempFolder folder;
  const std::string side = "radial_immersion = 0.5\nside = \"down\"\n";
  const auto worn = readText(folder, caseWith(side, "indentation_n_per_m3 = 2e13\nwear_land_mm = 0.1\n"));
  ASSERT_TRUE(worn.ok()) << worn.error().line();
  EXPECT_NEAR(worn->model.material.processDamping, 0.5 * 2e13 * 1e-8, 1e-3);
  EXPECT_FALSE(readText(folder, caseWith(side, "wear_land_mm = 0.1\n")).ok());
  const std::string twice = "indentation_n_per_m3 = 2e13\nwear_land_mm = 0.1\nprocess_damping_n_per_m = 1e5\n";
  EXPECT_FALSE(readText(folder, caseWith(side, twice)).ok());
}

TEST(LobeCsv, OneRowPerCrossingAndOneForASpeedWithoutLimit) {
  const std::vector<Rpm> speeds{Rpm(5300), Rpm(13800)};
  SweepOptions options;
  options.limits.maxAxialDepth = Metres(2e-3);
  const auto limited = sweepLobes(textbookSlot(), std::span(speeds).first(1), options, "csv");
  const std::string csv = lobeCsv(*limited);
  EXPECT_EQ(csv.rfind("speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz\n5300,0,1.192822", 0), 0u) << csv;
  EXPECT_NE(csv.find(",0,2,hopf,"), std::string::npos);
  options.limits.maxAxialDepth = Metres(1e-5);
  const auto free = sweepLobes(textbookSlot(), speeds, options, "csv");
  EXPECT_EQ(lobeCsv(*free),
            "speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz\n5300,0,,0,0,none,\n13800,0,,0,0,none,\n");
  EXPECT_FALSE(saveLobeCsv(*free, "/no/such/folder/lobes.csv").ok());
}

}  // namespace
}  // namespace stillcut::milling
