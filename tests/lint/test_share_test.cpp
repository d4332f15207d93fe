// At least as much code in tests as in core. What is counted, on both sides: lines that are neither blank nor comment
// only. Core: every .h and .cpp below core/. Tests: every .h and .cpp below tests/, and its programs in Python and
// shell; no data, no lists for CMake.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/lint/language.h"

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

constexpr double kLeastShare = 1.0;

// Python's doc strings count as code: they are the scripts' help.
int codeLines(std::istream& in, Language language) {
  const std::string_view comment = language == Language::Cpp ? "//" : "#";
  int lines = 0;
  bool inBlock = false;
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    const std::string_view text = std::string_view(line).substr(first);
    if (language == Language::Cpp && text.starts_with("/*")) inBlock = true;
    const bool skipped = inBlock || text.starts_with(comment);
    if (inBlock && text.find("*/") != std::string_view::npos) inBlock = false;
    lines += skipped ? 0 : 1;
  }
  return lines;
}

int codeBelow(std::string_view folder, bool scripts) {
  int lines = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(STILLCUT_SOURCE_DIR) / folder)) {
    if (!entry.is_regular_file()) continue;
    const Language language = languageOf(entry.path());
    if (language == Language::None || (language == Language::Script && !scripts)) continue;
    std::ifstream in(entry.path());
    lines += codeLines(in, language);
  }
  return lines;
}

TEST(TestShare, TestsHoldAsMuchCodeAsCore) {
  const int core = codeBelow("core", false);
  const int tests = codeBelow("tests", true);
  ASSERT_GT(core, 10000);
  const double share = static_cast<double>(tests) / core;
  std::cout << "code: core " << core << ", tests " << tests << " (of which ui " << codeBelow("tests/ui", true)
            << ", bench " << codeBelow("tests/bench", true) << "); share " << share << "\n";
  EXPECT_GE(share, kLeastShare);
}

TEST(TestShareCheck, CountsCodeOnly) {
  std::istringstream cpp("// a\n\n  // b\nint x;  // c\n/* d\n e */\n}\n");
  EXPECT_EQ(codeLines(cpp, Language::Cpp), 2);
  std::istringstream script("#!/bin/sh\n# a\n\nfoo\n");
  EXPECT_EQ(codeLines(script, Language::Script), 1);
}

}  // namespace
}  // namespace stillcut::lint
