// What a reader can hold: a folder has at most 40 sources, 95 of 100 files have at most 350 lines, and a function fits
// a screen; one that does not says why in the line above it, which begins "// Longer than a screen:".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/lint/language.h"

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

constexpr int kScreen = 60;  // lines of a function
constexpr std::string_view kReason = "// Longer than a screen: ";
constexpr int kNearlyAll = 350;
constexpr double kNearlyAllFraction = 0.95;
constexpr int kFolder = 40;

std::vector<fs::path> sources(std::initializer_list<const char*> folders, bool scripts) {
  std::vector<fs::path> all;
  for (const char* folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(STILLCUT_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file()) continue;
      const Language language = languageOf(entry.path());
      if (language == Language::Cpp || (scripts && language == Language::Script)) all.push_back(entry.path());
    }
  }
  return all;
}

TEST(Sizes, NearlyAllFilesFitInAHead) {
  std::vector<std::pair<long, std::string>> lengths;
  for (const fs::path& path : sources({"core", "ui", "app", "tests", "translations", "packaging"}, true)) {
    std::ifstream in(path);
    lengths.emplace_back(std::count(std::istreambuf_iterator<char>(in), {}, '\n'), path.string());
  }
  ASSERT_GT(lengths.size(), 1000u);
  std::sort(lengths.begin(), lengths.end());
  const auto& edge = lengths[static_cast<std::size_t>(kNearlyAllFraction * static_cast<double>(lengths.size() - 1))];
  EXPECT_LE(edge.first, kNearlyAll) << edge.second;
}

TEST(Sizes, AFolderHoldsOneSubject) {
  std::map<std::string, int> files;
  for (const fs::path& path : sources({"core", "ui", "app", "tests"}, false))
    ++files[fs::relative(path.parent_path(), STILLCUT_SOURCE_DIR).string()];
  ASSERT_GT(files.size(), 50u);
  for (const auto& [folder, count] : files) EXPECT_LE(count, kFolder) << folder;
}

// Functions outside of classes that are longer than a screen and do not say why, as "line: length". clang-format puts
// the first line and the closing brace of each at the first column.
std::vector<std::string> longFunctions(std::istream& in) {
  static const std::regex kBegins(R"(^[A-Za-z].*\{$)");
  static const std::regex kNoFunction(
      R"(^(namespace|struct|class|enum|union|extern|constexpr|const|inline constexpr)\b.*)");
  std::vector<std::string> found;
  int number = 0, begin = 0;
  bool reasoned = false;
  std::string before;
  for (std::string line; std::getline(in, line); before = line) {
    ++number;
    if (std::regex_match(line, kBegins) && !std::regex_match(line, kNoFunction)) {
      begin = number;
      reasoned = before.starts_with(kReason) && before.size() > kReason.size() + 10;
    } else if (line == "}" && begin > 0) {
      if (number - begin + 1 > kScreen && !reasoned)
        found.push_back(std::to_string(begin) + ": " + std::to_string(number - begin + 1) + " lines");
      begin = 0;
    }
  }
  return found;
}

TEST(Sizes, AFunctionFitsAScreen) {
  for (const fs::path& path : sources({"core", "ui", "app"}, false)) {
    std::ifstream in(path);
    for (const std::string& function : longFunctions(in))
      ADD_FAILURE() << fs::relative(path, STILLCUT_SOURCE_DIR).string() << ':' << function;
  }
}

// That the check itself can fail.
TEST(SizesCheck, FindALongFunctionAndTakeAReason) {
  const auto found = [](const std::string& head, int lines) {
    std::istringstream text(head + "int f(int x) {\n" + std::string(static_cast<std::size_t>(lines), '\n') + "}\n");
    return longFunctions(text);
  };
  EXPECT_THAT(found("", kScreen - 2), testing::IsEmpty());
  EXPECT_THAT(found("", kScreen - 1), testing::ElementsAre("1: 61 lines"));
  EXPECT_THAT(found(std::string(kReason) + "one table, row for row\n", 100), testing::IsEmpty());
  EXPECT_THAT(found("struct S {\n};\n", kScreen - 1), testing::SizeIs(1));
}

}  // namespace
}  // namespace stillcut::lint
