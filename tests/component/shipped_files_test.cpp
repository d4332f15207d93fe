// What comes with the program holds together and is found by its short name from wherever one stands.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "app/compose/profile_rig.h"
#include "app/compose/resource_folder.h"
#include "core/pipeline/catalog.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;

// A build without the desktop has no serial ports (Qt's), and says so where a profile names one.
bool lacksSerialPorts(const Error& error) {
#ifdef STILLCUT_SERIAL
  (void)error;
  return false;
#else
  return error.line().find("serial ports are not part of this build") != std::string::npos;
#endif
}

// Ids, settings, parameters and named files of every profile: up to the point where a device would be opened.
TEST(ShippedFiles, EveryProfileIsOneToStartFromOnceItIsCopied) {
  const record::TempFolder folder;
  int seen = 0;
  for (const auto& entry : fs::directory_iterator(resourceFolder() / "profiles")) {
    const std::string copy = folder / entry.path().filename().string();
    fs::copy_file(entry.path(), copy);
    const auto profile = config::loadProfile(copy, pipeline::fullCatalog(), knownIds());
    ASSERT_TRUE(profile.ok()) << profile.error().line();
    std::vector<config::SettingDecl> asked;
    const auto parts = makeProfileParts(*profile, copy, &asked, AnalogOutputs::LeftAlone);
    EXPECT_TRUE(parts.ok() || lacksSerialPorts(parts.error())) << copy << ": " << parts.error().line();
    ++seen;
  }
  EXPECT_GE(seen, 4);
}

TEST(ShippedFiles, AreFoundByTheirShortNameUnlessOneStandsWhereItIsLookedForFirst) {
  const record::TempFolder folder;
  const std::string name = "scenarios/demo.toml";
  const std::string here = folder / "";
  EXPECT_EQ(foundFile(name, here), (resourceFolder() / name).string());
  fs::create_directory(folder / "scenarios");
  folder.file(name, "");
  EXPECT_EQ(foundFile(name, here), folder / name);
  // What is nowhere is reported where the user looked, and a folder of ours is no file.
  EXPECT_EQ(foundFile("lost.toml", here), folder / "lost.toml");
  EXPECT_EQ(foundFile("manual", here), folder / "manual");
  EXPECT_EQ(foundFile("/lost.toml", here), "/lost.toml");
}

}  // namespace
}  // namespace stillcut::app
