// No wall of text: most files want 100 to 300 lines; one over 400 says why in a line that begins "// Over 400 lines:",
// and nothing is longer than 600. Headers, sources and scripts alike, but for those that a program writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/lint/language.h"

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

constexpr int kLongest = 600;
constexpr int kNeedsReason = 400;
constexpr std::string_view kReason = "// Over 400 lines: ";
constexpr std::string_view kReasonInScript = "# Over 400 lines: ";
constexpr int kNearlyAll = 350;  // 95 of 100 files are no longer
constexpr double kNearlyAllShare = 0.95;

// Not counted, and why.
struct Exempt {
  std::string_view path, because;
};
constexpr std::array kExempt{
    Exempt{"translations/core_sentences.h",
           "written by translations/core_sentences: every sentence of core, for lupdate"},
    Exempt{"translations/core_texts.h",
           "written by core_texts of tests/ui: every label that core declares, for lupdate"},
};
bool isExempt(std::string_view path) {
  return std::ranges::any_of(kExempt, [&](const Exempt& e) { return e.path == path; });
}

struct Length {
  int lines = 0;
  std::string path;
  bool reasoned = false;
};

Length lengthOf(std::istream& in, const std::string& path) {
  Length length{0, path, false};
  for (std::string line; std::getline(in, line);) {
    ++length.lines;
    for (const std::string_view reason : {kReason, kReasonInScript})
      length.reasoned = length.reasoned || (line.starts_with(reason) && line.size() > reason.size() + 20);
  }
  return length;
}
bool isFine(const Length& length) {
  return length.lines <= kNeedsReason || (length.reasoned && length.lines <= kLongest);
}

std::vector<Length> lengths() {
  const fs::path top = STILLCUT_SOURCE_DIR;
  std::vector<Length> all;
  for (const char* folder : {"core", "ui", "app", "tests", "translations", "packaging"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const std::string path = fs::relative(entry.path(), top).string();
      if (!entry.is_regular_file() || languageOf(entry.path()) == Language::None || isExempt(path)) continue;
      std::ifstream in(entry.path());
      all.push_back(lengthOf(in, path));
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

// What is exempt is there, is long, and says itself what writes it.
TEST(FileSizes, OnlyWhatAProgramWritesIsExempt) {
  for (const Exempt& file : kExempt) {
    std::ifstream in(fs::path(STILLCUT_SOURCE_DIR) / file.path);
    std::string first;
    std::getline(in, first);
    EXPECT_TRUE(first.starts_with("// Made by ")) << file.path << ": " << file.because;
    EXPECT_FALSE(isFine(lengthOf(in, std::string(file.path)))) << file.path << " needs no exemption";
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
  EXPECT_TRUE(fine(500, std::string(kReasonInScript) + "one table of the standard, row for row\n"));
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
