// One name, one type: two types of one qualified name in two files compile, and the linker then takes the members of
// one for the other's (the one-definition rule). No compiler sees it, for no file sees both. What stands in an
// anonymous namespace may be called what it likes. clang-format puts every type of a namespace at the first column.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/lint/language.h"

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

// Qualified names of the types that `in` defines where other files could define them too.
std::set<std::string> sharedTypes(std::istream& in) {
  static const std::regex kNamespace(R"(^namespace ?([\w:]*) \{)");
  static const std::regex kType(
      R"(^(?:class|struct|union|enum class) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: : .*| \{.*)$)");
  std::vector<std::string> spaces;
  std::set<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_search(line, match, kNamespace)) {
      spaces.push_back(match[1]);
    } else if (line.starts_with("}  // namespace")) {
      if (!spaces.empty()) spaces.pop_back();
    } else if (std::regex_match(line, match, kType)) {
      std::string name;
      bool ownToItsFile = false;
      for (const std::string& space : spaces) {
        ownToItsFile = ownToItsFile || space.empty();
        name += space + "::";
      }
      if (!ownToItsFile) found.insert(name + match[1].str());
    }
  }
  return found;
}

// Type to the files that define it, of those that more than one defines.
std::map<std::string, std::string> definedTwice(const std::map<std::string, std::set<std::string>>& typesOfFiles) {
  std::map<std::string, std::vector<std::string>> files;
  for (const auto& [file, types] : typesOfFiles)
    for (const std::string& type : types) files[type].push_back(file);
  std::map<std::string, std::string> twice;
  for (const auto& [type, in] : files)
    if (in.size() > 1) twice[type] = in[0] + " and " + in[1];
  return twice;
}

std::set<std::string> typesOf(const std::string& text) {
  std::istringstream in(text);
  return sharedTypes(in);
}

TEST(TypeNames, NoTwoFilesDefineOneType) {
  const fs::path top = STILLCUT_SOURCE_DIR;
  std::map<std::string, std::set<std::string>> types;
  for (const char* folder : {"core", "ui", "app", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      if (!entry.is_regular_file() || languageOf(entry.path()) != Language::Cpp) continue;
      std::ifstream in(entry.path());
      types[fs::relative(entry.path(), top).string()] = sharedTypes(in);
    }
  }
  for (const auto& [type, files] : definedTwice(types)) ADD_FAILURE() << type << " is defined in " << files;
  std::size_t all = 0;
  for (const auto& [file, own] : types) all += own.size();
  EXPECT_GT(all, types.size() / 2) << "the check no longer finds types";
}

// That the check itself can fail.
TEST(TypeNamesCheck, FindsATypeDefinedTwice) {
  const std::set<std::string> one =
      typesOf("namespace a::b {\n\nclass Column : public Base {\n};\n}  // namespace a::b\n");
  EXPECT_EQ(one, std::set<std::string>{"a::b::Column"});
  const std::set<std::string> other =
      typesOf("namespace a {\nnamespace b {\nstruct Column {\n};\n}  // namespace b\n}  // namespace a\n");
  EXPECT_EQ(definedTwice({{"x.h", one}, {"y.h", other}}).size(), 1u);
}

TEST(TypeNamesCheck, LeavesFilesTheirOwnAndMembersTheirs) {
  EXPECT_TRUE(typesOf("namespace a {\nnamespace {\nstruct Own {\n};\n}  // namespace\n}  // namespace a\n").empty());
  EXPECT_TRUE(typesOf("namespace a {\nstruct Outer::Inner {\n};\nclass Later;\n}  // namespace a\n").empty());
}

}  // namespace
}  // namespace stillcut::lint
