// No wall of text: most files want 100 to 300 lines, and nothing is longer than 600.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

constexpr int kLongest = 600;
constexpr int kNearlyAll = 350;  // 95 of 100 files are no longer
constexpr double kNearlyAllShare = 0.95;

struct Length {
  int lines = 0;
  std::string path;
};

std::vector<Length> lengths() {
  const fs::path top = STILLCUT_SOURCE_DIR;
  std::vector<Length> all;
  for (const char* folder : {"core", "ui", "app", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const fs::path kind = entry.path().extension();
      if (!entry.is_regular_file() || (kind != ".h" && kind != ".cpp")) continue;
      std::ifstream in(entry.path());
      int lines = 0;
      for (std::string line; std::getline(in, line);) ++lines;
      all.push_back({lines, fs::relative(entry.path(), top).string()});
    }
  }
  std::sort(all.begin(), all.end(), [](const Length& a, const Length& b) { return a.lines < b.lines; });
  return all;
}

TEST(FileSizes, NoFileIsAWall) {
  for (const Length& file : lengths()) EXPECT_LE(file.lines, kLongest) << file.path;
}

TEST(FileSizes, NearlyAllFilesFitInAHead) {
  const std::vector<Length> all = lengths();
  ASSERT_FALSE(all.empty());
  const Length& edge = all[static_cast<std::size_t>(kNearlyAllShare * static_cast<double>(all.size() - 1))];
  EXPECT_LE(edge.lines, kNearlyAll) << edge.path;
}

}  // namespace
}  // namespace stillcut::lint
