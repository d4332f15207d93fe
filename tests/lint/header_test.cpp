// A header begins with what it is: a comment before anything else. That is the documentation a reader meets first.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFewest = 20;  // characters that say something

// Comment text before the first line of code.
std::size_t spokenFirst(std::istream& in) {
  std::size_t characters = 0;
  for (std::string line; std::getline(in, line) && (line.empty() || line.starts_with("//"));) {
    characters += line.size() > 3 ? line.size() - 3 : 0;
  }
  return characters;
}

TEST(Headers, BeginWithWhatTheyAre) {
  int seen = 0;
  for (const char* folder : {"core", "ui", "app", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(STILLCUT_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file() || entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      EXPECT_GE(spokenFirst(in), kFewest) << fs::relative(entry.path(), STILLCUT_SOURCE_DIR);
      ++seen;
    }
  }
  EXPECT_GT(seen, 300);
}

// The pages beside the interfaces, one for each kind of part a stranger may want to add.
TEST(Headers, EveryInterfaceHasItsPageOnAdding) {
  for (const char* page : {"core/detect/ADDING.md", "core/control/ADDING.md", "core/daq/ADDING.md",
                           "core/cnc/ADDING.md", "ui/pages/ADDING.md"}) {
    const fs::path file = fs::path(STILLCUT_SOURCE_DIR) / page;
    ASSERT_TRUE(fs::exists(file)) << page;
    EXPECT_GT(fs::file_size(file), 500U) << page;
  }
}

TEST(HeadersCheck, CountsOnlyWhatStandsFirst) {
  std::istringstream spoken("// What it is.\n//\n// And why so.\n#pragma once\n// later\n");
  EXPECT_EQ(spokenFirst(spoken), 11U + 11U);
  std::istringstream silent("#pragma once\n// What it is, too late.\n");
  EXPECT_EQ(spokenFirst(silent), 0U);
}

}  // namespace
}  // namespace stillcut::lint
