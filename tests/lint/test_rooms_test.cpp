// What tests of several rooms use lies in tests/support; a helper that lies with the tests of one room is theirs alone.
// A folder inside a room (an oracle, the command line's) belongs to it.
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

// "tests/unit/detect" of "tests/unit/detect/oracle/sources.h", "tests/ui" of "tests/ui/support/main.cpp".
std::string testRoomOf(std::string_view path) {
  const std::size_t words = path.starts_with("tests/unit/") ? 3 : 2;
  std::size_t end = 0;
  for (std::size_t i = 0; i < words && end != std::string_view::npos; ++i) end = path.find('/', end + (i > 0 ? 1 : 0));
  return std::string(path.substr(0, end));
}

// One line for each include of another room's helper.
std::vector<std::string> borrowed(const std::string& path, std::istream& text) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*"(tests/[^"]+)".*)re");
  std::vector<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (!std::regex_match(line, match, kInclude)) continue;
    const std::string from = testRoomOf(match[1].str());
    if (from != "tests/support" && from != testRoomOf(path)) found.push_back(path + ": includes " + match[1].str());
  }
  return found;
}

TEST(TestRooms, ShareOnlyWhatLiesInSupport) {
  const fs::path top = STILLCUT_SOURCE_DIR;
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(top / "tests")) {
    const fs::path kind = entry.path().extension();
    if (!entry.is_regular_file() || (kind != ".h" && kind != ".cpp")) continue;
    std::ifstream text(entry.path());
    for (const std::string& line : borrowed(fs::relative(entry.path(), top).string(), text)) ADD_FAILURE() << line;
    ++seen;
  }
  EXPECT_GT(seen, 300);
}

// That the check itself can fail.
TEST(TestRoomsCheck, FindsWhatIsBorrowed) {
  const auto lines = [](const std::string& path, const std::string& include) {
    std::istringstream text("#include <vector>\n#include \"" + include + "\"\n");
    return borrowed(path, text);
  };
  EXPECT_THAT(lines("tests/unit/control/a.cpp", "tests/unit/safety/b.h"),
              testing::ElementsAre("tests/unit/control/a.cpp: includes tests/unit/safety/b.h"));
  EXPECT_EQ(lines("tests/support/a.h", "tests/protocol/b.h").size(), 1U);
  EXPECT_EQ(lines("tests/soak/a.cpp", "tests/support/b.h").size(), 0U);
  EXPECT_EQ(lines("tests/unit/detect/a.cpp", "tests/unit/detect/oracle/b.h").size(), 0U);
  EXPECT_EQ(lines("tests/component/cli/a.cpp", "tests/component/b.h").size(), 0U);
  EXPECT_EQ(lines("tests/ui/a.cpp", "core/model/verdict.h").size(), 0U);
}

}  // namespace
}  // namespace stillcut::lint
