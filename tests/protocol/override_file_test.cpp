// The record of what stands in a machine, on the disk.
#include "app/io/override_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;
using cnc::SentOverrides;
using cnc::testing::TemporaryFolder;

constexpr SentOverrides kSent{{100, 83}, {110, 91}};

TEST(OverrideFile, IsThereForTheNextProgramAndGoneWhenNothingStandsAnyMore) {
  const TemporaryFolder folder;
  const std::string place = folder.file("overrides"), machine = "grbl device=/dev/ttyUSB0";
  fs::path file;
  {
    OverrideFile memory(place, machine);
    EXPECT_FALSE(memory.left());
    EXPECT_FALSE(fs::exists(place)) << "a machine that is never moved leaves nothing";
    memory.keep({{100, 90}, {110, 99}});
    memory.keep(kSent);
    file = memory.file();
  }
  {
    OverrideFile memory(place, machine);
    EXPECT_EQ(memory.left(), kSent);
    EXPECT_FALSE(OverrideFile(place, "grbl device=/dev/ttyUSB1").left()) << "another machine";
  }
  EXPECT_TRUE(fs::exists(file)) << "nobody has brought it back";
  {
    OverrideFile memory(place, machine);
    memory.forget();
  }
  EXPECT_FALSE(fs::exists(file));
}

// A disk that was full, or a share that was away.
TEST(OverrideFile, WhatCouldNotBeWrittenIsWrittenLater) {
  const TemporaryFolder folder;
  const std::string place = folder.file("overrides");
  std::ofstream(place) << "a file where the folder has to be";
  OverrideFile memory(place, "grbl");
  memory.keep(kSent);
  ASSERT_FALSE(cnc::testing::within(Seconds(0.1), [&] { return fs::is_regular_file(memory.file()); }));
  fs::remove(place);
  EXPECT_TRUE(cnc::testing::within(Seconds(20.0), [&] { return fs::is_regular_file(memory.file()); }));
  EXPECT_EQ(OverrideFile(place, "grbl").left(), kSent);
}

TEST(OverrideFile, WhatIsNoRecordSaysNothing) {
  const TemporaryFolder folder;
  OverrideFile probe(folder.file(""), "grbl");
  for (const char* content : {"", "100 83", "100 83 100 nonsense", "100 83 100 -5", "100 83 100 99999999999"}) {
    std::ofstream(probe.file()) << content;
    EXPECT_FALSE(OverrideFile(folder.file(""), "grbl").left()) << content;
  }
}

}  // namespace
}  // namespace stillcut::app
