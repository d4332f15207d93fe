#include "core/milling/stability/lobe_case.h"

#include <gtest/gtest.h>

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
