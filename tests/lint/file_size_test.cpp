// No wall of text: most files want 100 to 300 lines; one over 400 says why in a line that begins "// Over 400 lines:",
// and nothing is longer than 600.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

constexpr int kLongest = 600;
constexpr int kNeedsReason = 400;
constexpr std::string_view kReason = "// Over 400 lines: ";
constexpr int kNearlyAll = 350;  // 95 of 100 files are no longer
constexpr double kNearlyAllShare = 0.95;

struct Length {
  int lines = 0;
  std::string path;
  bool reasoned = false;
};

Length lengthOf(std::istream& in, const std::string& path) {
  Length length{0, path, false};
  for (std::string line; std::getline(in, line);) {
    ++length.lines;
    length.reasoned = length.reasoned || (line.starts_with(kReason) && line.size() > kReason.size() + 20);
  }
  return length;
}
bool isFine(const Length& length) {
  return length.lines <= kNeedsReason || (length.reasoned && length.lines <= kLongest);
}

std::vector<Length> lengths() {
  const fs::path top = STILLCUT_SOURCE_DIR;
  std::vector<Length> all;
  for (const char* folder : {"core", "ui", "app", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const fs::path kind = entry.path().extension();
      if (!entry.is_regular_file() || (kind != ".h" && kind != ".cpp")) continue;
      std::ifstream in(entry.path());
      all.push_back(lengthOf(in, fs::relative(entry.path(), top).string()));
    }
  }
  std::sort(all.begin(), all.end(), [](const Length& a, const Length& b) { return a.lines < b.lines; });
  return all;
}

TEST(FileSizes, NoFileIsAWall) {
  for (const Length& file : lengths()) {
    EXPECT_TRUE(isFine(file)) << file.path << ": " << file.lines << " lines and no '" << kReason << "...'";
  }
}

// That the check itself can fail.
TEST(FileSizesCheck, AskForAReasonAndRefuseAWallWithOne) {
  const auto fine = [](int lines, const std::string& head) {
    std::istringstream text(head + std::string(static_cast<std::size_t>(lines), '\n'));
    return isFine(lengthOf(text, "a.cpp"));
  };
  const std::string reason = std::string(kReason) + "one table of the standard, row for row\n";
  EXPECT_TRUE(fine(400, ""));
  EXPECT_FALSE(fine(401, ""));
  EXPECT_TRUE(fine(500, reason));
  EXPECT_FALSE(fine(500, std::string(kReason) + "long\n"));
  EXPECT_FALSE(fine(600, reason));
}

TEST(FileSizes, NearlyAllFilesFitInAHead) {
  const std::vector<Length> all = lengths();
  ASSERT_FALSE(all.empty());
  const Length& edge = all[static_cast<std::size_t>(kNearlyAllShare * static_cast<double>(all.size() - 1))];
  EXPECT_LE(edge.lines, kNearlyAll) << edge.path;
}

}  // namespace
}  // namespace stillcut::lint
