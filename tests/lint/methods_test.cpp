// What a detector or a strategy throws is a fault of that method: the chain drops it and goes on with its second. A
// function of theirs that is noexcept would end the program in its place (core/detect/detector.h).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

TEST(Methods, MayThrowWhereverTheyAre) {
  int lines = 0;
  for (const char* room : {"core/detect", "core/control"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(STILLCUT_SOURCE_DIR) / room)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line); ++lines) {
        const std::string code = line.substr(0, line.find("//"));
        EXPECT_EQ(code.find("noexcept"), std::string::npos) << entry.path() << ": " << line;
      }
    }
  }
  EXPECT_GT(lines, 1000);
}

}  // namespace
}  // namespace stillcut::lint
