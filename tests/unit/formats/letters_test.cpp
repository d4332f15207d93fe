// Names beyond ASCII: what is written comes back letter by letter, in our reader and in others'.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/utf_text.h"
#include "core/session/convert_recording.h"
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

// German, Chinese, and a letter beyond 16 bits.
const std::vector<std::string> kNames{
    "Kr\xC3\xA4"
    "fte \xC2\xB5",
    "\xE4\xB8\xBB\xE8\xBD\xB4\xE6\x8C\xAF\xE5\x8A\xA8 X", "\xF0\x9F\x94\x94 mic"};

// Letters beyond 16 bits are counted differently by those who read .mat.
constexpr const char* kInMatlab = "? mic";

std::string source(const TempFolder& folder) {
  std::string text = "t," + kNames[0] + " (N)," + kNames[1] + " (m/s^2)," + kNames[2] + " (Pa)\n";
  for (int i = 0; i < 50; ++i) text += std::to_string(i) + "e-3,1,2,3\n";
  return folder.file("in.csv", text);
}

std::vector<std::string> namesIn(const std::string& path) {
  const WholeRecording all = readAll(path);
  EXPECT_EQ(all.error, "") << path;
  std::vector<std::string> names;
  for (const RecordedChannel& channel : all.format.channels) names.push_back(channel.info.name);
  return names;
}

TEST(Letters, NamesComeBackFromEveryFormatThatHoldsThem) {
  const TempFolder folder;
  const std::string from = source(folder);
  ASSERT_EQ(namesIn(from), kNames);
  for (const char* name : {"x.mat", "x.uff", "x.unv", "x.h5", "x.csv", "x.wav", "x.flac"}) {
    const Status converted = convertRecording(from, folder / name);
    ASSERT_TRUE(converted.ok()) << converted.error().line();
    std::vector<std::string> expected = kNames;
    if (std::string_view(name) == "x.mat") expected[2] = kInMatlab;
    EXPECT_EQ(namesIn(folder / name), expected) << name;
  }
}

TEST(Letters, ScipyReadsTheSameNames) {
  constexpr const char* kPython = "/usr/bin/python3";
  if (std::system((std::string(kPython) + " -c 'import scipy.io' 2>/dev/null").c_str()) != 0) {
    GTEST_SKIP() << "python3-scipy is not installed";
  }
  const TempFolder folder;
  ASSERT_TRUE(convertRecording(source(folder), folder / "x.mat").ok());
  const std::string script =
      "import scipy.io,sys; m = scipy.io.loadmat(sys.argv[1]); "
      "sys.stdout.buffer.write('|'.join(str(v[0]) for k, v in m.items() if k.endswith('_name')).encode())";
  std::FILE* pipe = popen((std::string(kPython) + " -c \"" + script + "\" " + folder / "x.mat").c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::array<char, 512> out{};
  const std::size_t bytes = std::fread(out.data(), 1, out.size(), pipe);
  ASSERT_EQ(pclose(pipe), 0);
  EXPECT_EQ(std::string(out.data(), bytes), kNames[0] + "|" + kNames[1] + "|" + kInMatlab);
}

// As instruments in Europe write them: one byte a letter.
TEST(Letters, AUniversalFileInLatin1IsRead) {
  const TempFolder folder;
  ASSERT_TRUE(convertRecording(source(folder), folder / "x.unv").ok());
  std::ifstream in(folder / "x.unv", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::string utf8 = kNames[0].substr(0, 6), latin =
                                                       "Kr\xE4"
                                                       "ft ";
  for (std::size_t at = bytes.find(utf8); at != std::string::npos; at = bytes.find(utf8)) bytes.replace(at, 6, latin);
  EXPECT_THAT(namesIn(folder.file("latin.unv", bytes)).at(0), HasSubstr("Kr\xC3\xA4"
                                                                        "ft"));
}

TEST(Letters, ALongNameIsCutBetweenTwoLetters) {
  const TempFolder folder;
  std::string name;
  for (int i = 0; i < 30; ++i) name += "\xE8\xBD\xB4";
  const std::string from = folder.file("in.csv", "t," + name + " (N)\n0,1\n0.001,2\n0.002,3\n");
  for (const char* to : {"x.mat", "x.uff"}) {
    ASSERT_TRUE(convertRecording(from, folder / to).ok());
    EXPECT_EQ(namesIn(folder / to).at(0), name.substr(0, 78)) << "26 letters of three bytes fit into 80";
  }
}

TEST(Letters, BrokenTextIsShownAndNeverBelieved) {
  EXPECT_EQ(fromUtf16(toUtf16(kNames[2])), kNames[2]);
  EXPECT_EQ(toUtf16(kNames[2]).size(), 6U) << "two halves, a space, three letters";
  const std::vector<std::uint16_t> halves{0xD83D, 'a', 0xDD14};
  EXPECT_EQ(fromUtf16(halves), "?a?");
  EXPECT_EQ(fromUtf16(toUtf16("a\xC3")), "a?");
  EXPECT_EQ(fromUtf16(toUtf16("\xED\xA0\x80")), "???") << "half of a pair in three bytes";
  EXPECT_EQ(utf8Of("\xC0\x80"), "\xC3\x80\xC2\x80") << "a longer form than needed is no UTF-8";
  EXPECT_EQ(cutUtf8("a\xC3\xBC", 2), "a");
}

}  // namespace
}  // namespace stillcut::record
