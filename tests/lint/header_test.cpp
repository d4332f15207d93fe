// A header begins with what it is: a comment before anything else, which a reader meets first. In core it also names
// the thread, and an interface says of every function what its implementations owe.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

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

// Who may call what is in it, and when: a header of core says so, if only that any thread may.
bool namesThread(const std::string& text) {
  static const std::regex kWords("thread|real-time|worker", std::regex::icase);
  return std::regex_search(text, kWords);
}

// Functions without a body that a class leaves to others, and that no comment stands above or behind.
std::vector<std::string> unspoken(std::istream& in) {
  static const std::regex kBegins(R"(^\s*virtual\b)");
  std::vector<std::string> found;
  std::string before;
  for (std::string line; std::getline(in, line); before = line) {
    if (!std::regex_search(line, kBegins) || line.find('~') != std::string::npos) continue;
    const std::string first = line;
    std::string whole = line;
    while (line.find(';') == std::string::npos && line.find('{') == std::string::npos && std::getline(in, line)) {
      whole += line;
    }
    const bool open = whole.find("= 0") != std::string::npos;
    const bool above = before.find_first_not_of(' ') != std::string::npos &&
                       std::string_view(before).substr(before.find_first_not_of(' ')).starts_with("//");
    if (open && !above && whole.find("//") == std::string::npos) found.push_back(first);
  }
  return found;
}

TEST(Headers, OfCoreNameTheThreadAndSayWhatEveryImplementationOwes) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(STILLCUT_SOURCE_DIR) / "core")) {
    if (!entry.is_regular_file() || entry.path().extension() != ".h") continue;
    const std::string path = fs::relative(entry.path(), STILLCUT_SOURCE_DIR).string();
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    EXPECT_TRUE(namesThread(text.str())) << path << ": says nowhere which thread";
    for (const std::string& line : unspoken(text)) ADD_FAILURE() << path << ": not a word on" << line;
  }
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

TEST(HeadersCheck, FindsAFunctionLeftToOthersWithoutAWord) {
  std::istringstream text(
      "  virtual ~A() = default;\n"
      "  // Said.\n  virtual void a() = 0;\n"
      "  virtual void b() = 0;  // said\n"
      "  virtual int c(int one,\n        int two) const = 0;\n"
      "  virtual bool d() const { return false; }\n");
  EXPECT_THAT(unspoken(text), testing::ElementsAre("  virtual int c(int one,"));
  EXPECT_TRUE(namesThread("// Thread: any."));
  EXPECT_FALSE(namesThread("// Something.\nint f();\n"));
}

}  // namespace
}  // namespace stillcut::lint
