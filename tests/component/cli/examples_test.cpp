// The manual's example for MATLAB and GNU Octave, run as a reader runs it. Python's are run by the test of the manual.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/component/cli/in_folder.h"
#include "tests/component/cli/made_files.h"

namespace stillcut::cli_test {
namespace {

using testing::HasSubstr;

class Examples : public InFolder {
 protected:
  void SetUp() override {
    if (std::system("command -v octave-cli >/dev/null 2>&1") != 0) GTEST_SKIP() << "octave-cli is not here";
    writeSound(folder_ / "cut.wav", {cutSignal(true)});
    std::filesystem::copy(STILLCUT_SOURCE_DIR "/resources/manual/read_answers.m", folder_ / "read_answers.m");
  }
  // What the line of Octave prints; the program it calls is the one of this build.
  std::string octave(const std::string& line, int& code) {
    const std::string programs = std::filesystem::path(STILLCUT_CLI).parent_path().string();
    const std::string out = folder_ / "out";
    code = std::system(("cd '" + folder_ / "" + "' && PATH='" + programs +
                        "':\"$PATH\" octave-cli --norc --quiet --eval \"" + line + "\" >'" + out + "' 2>&1 </dev/null")
                           .c_str());
    return content("out");
  }
};

TEST_F(Examples, OctaveReadsTheAnswerAndTheSeries) {
  int code = -1;
  const std::string out = octave("a = read_answers('cut.wav', '--teeth 4 --speed 8500'); disp(a.finding)", code);
  EXPECT_EQ(code, 0) << out;
  EXPECT_THAT(out, HasSubstr("chatter at 937"));
  EXPECT_THAT(out, HasSubstr(" s of 2.50 s, in alarm "));
  // Octave 7.3 may say something of its own about its exit after it.
  EXPECT_THAT(out, HasSubstr("\nchatter\n"));
}

TEST_F(Examples, OctaveStopsWhereTheCommandDoes) {
  int code = 0;
  const std::string out = octave("read_answers('none.wav', '')", code);
  EXPECT_NE(code, 0);
  EXPECT_THAT(out, HasSubstr("there is no such file"));
  EXPECT_THAT(out, HasSubstr("ended with 2"));
}

}  // namespace
}  // namespace stillcut::cli_test
