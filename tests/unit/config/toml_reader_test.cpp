#include "core/config/toml_reader.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <functional>

#include "core/storage/atomic_file.h"
#include "tests/support/temp_folder.h"

namespace stillcut::config {
namespace {

// The one line that reading `content` with `ask` ends in, "" when all is well.
std::string lineOf(std::string_view content, const std::function<void(const TomlTable&)>& ask) {
  const TomlReader in = TomlReader::text(content, "a.toml");
  ask(in.root());
  const Status status = in.finish();
  std::string line = status ? "" : status.error().line();
  EXPECT_EQ(line.find('\n'), std::string::npos) << "an error is one line";
  return line;
}

TEST(TomlReader, ReadsEveryKindOfValue) {
  const TomlReader in = TomlReader::text(
      "n = 2.5\ni = 4\nb = true\ns = \"x\"\nlist = [1, 2.5]\nwords = [\"a\", \"b\"]\nm = [[0, 1], [2, 3.5]]\n"
      "[tool]\nteeth = 4\n[[mode]]\nf = 100\n[[mode]]\nf = 200\n",
      "a.toml");
  const TomlTable root = in.root();
  EXPECT_DOUBLE_EQ(root.number("n"), 2.5);
  EXPECT_EQ(root.integer("i"), 4);
  EXPECT_TRUE(root.boolean("b"));
  EXPECT_EQ(root.text("s"), "x");
  EXPECT_EQ(root.numbers("list"), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(root.texts("words"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(root.rows("m"), (std::vector<std::vector<double>>{{0.0, 1.0}, {2.0, 3.5}}));
  EXPECT_EQ(root.table("tool").integer("teeth", 1, 12), 4);
  const auto modes = root.tables("mode");
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_DOUBLE_EQ(modes[0].number("f"), 100.0);
  EXPECT_DOUBLE_EQ(modes[1].number("f"), 200.0);
  EXPECT_TRUE(in.finish().ok());
}

TEST(TomlReader, MissingOptionalValuesGiveTheirFallback) {
  EXPECT_EQ(lineOf("n = 1\n",
                   [](const TomlTable& t) {
                     EXPECT_DOUBLE_EQ(t.number("n"), 1.0);
                     EXPECT_DOUBLE_EQ(t.numberOr("x", 7.0), 7.0);
                     EXPECT_EQ(t.textOr("y", "z"), "z");
                     EXPECT_FALSE(t.tableOr("tool").present());
                     EXPECT_EQ(t.tableOr("tool").integerOr("teeth", 3), 3);
                     EXPECT_TRUE(t.tablesOr("mode").empty());
                   }),
            "");
}

TEST(TomlReader, NamesFileLineAndNearestKeyOfWhatNobodyAskedFor) {
  const auto ask = [](const TomlTable& t) {
    const TomlTable tool = t.tableOr("tool");
    (void)tool.integerOr("teeth", 2);
    (void)tool.numberOr("diameter_mm", 10.0);
  };
  EXPECT_EQ(lineOf("[tool]\nteeht = 4\n", ask), "a.toml:2: unknown key 'tool.teeht' (did you mean 'teeth'?)");
  EXPECT_EQ(lineOf("[tool]\nteeth = 4\n[tol]\n", ask), "a.toml:3: unknown key 'tol' (did you mean 'tool'?)");
  EXPECT_EQ(lineOf("[tool]\nqqqqqqqq = 4\n", ask), "a.toml:2: unknown key 'tool.qqqqqqqq'");
}

TEST(TomlReader, SaysWhatIsWrongWithAValue) {
  const auto number = [](const TomlTable& t) { (void)t.number("n", 0.0, 10.0); };
  EXPECT_EQ(lineOf("a = 1\n", number), "a.toml:1: 'n' is missing");
  EXPECT_EQ(lineOf("n = \"1\"\n", number), "a.toml:1: 'n' is not a number");
  EXPECT_EQ(lineOf("\nn = 11\n", number), "a.toml:2: 'n' is out of range: 11 (allowed: 0 to 10)");
  EXPECT_EQ(lineOf("n = nan\n", number), "a.toml:1: 'n' is not a finite number");
  EXPECT_EQ(lineOf("n = -inf\n", number), "a.toml:1: 'n' is not a finite number");
  EXPECT_EQ(lineOf("n = true\n", number), "a.toml:1: 'n' is not a number");
  EXPECT_EQ(lineOf("n = 1.5\n", [](const TomlTable& t) { (void)t.integer("n"); }),
            "a.toml:1: 'n' is not a whole number");
  EXPECT_EQ(lineOf("n = 3000000000\n", [](const TomlTable& t) { (void)t.integer("n"); }),
            "a.toml:1: 'n' is out of range: 3000000000 (allowed: -2147483648 to 2147483647)");
  EXPECT_EQ(lineOf("n = 1\n", [](const TomlTable& t) { (void)t.boolean("n"); }),
            "a.toml:1: 'n' is neither true nor false");
  EXPECT_EQ(lineOf("n = 1\n", [](const TomlTable& t) { (void)t.table("n"); }), "a.toml:1: 'n' is not a table");
  EXPECT_EQ(lineOf("n = [1, nan]\n", [](const TomlTable& t) { (void)t.numbers("n"); }),
            "a.toml:1: 'n' holds something that is not a finite number");
  EXPECT_EQ(lineOf("n = [[1], [\"a\"]]\n", [](const TomlTable& t) { (void)t.rows("n"); }),
            "a.toml:1: 'n' holds a row that is not all finite numbers");
  EXPECT_EQ(lineOf("n = \"dwn\"\n",
                   [](const TomlTable& t) {
                     (void)t.choice("n", {"up", "down"});
                   }),
            "a.toml:1: 'n' is not a choice: 'dwn' (choices: up, down)");
}

TEST(TomlReader, TheFirstErrorCounts) {
  EXPECT_EQ(lineOf("a = 1\nb = nan\nzzz = 3\n",
                   [](const TomlTable& t) {
                     (void)t.text("a");
                     (void)t.number("b");
                   }),
            "a.toml:1: 'a' is not a text");
}

TEST(TomlReader, HostileTextIsOneLineNeverACrash) {
  const auto nothing = [](const TomlTable& t) {
    (void)t.numberOr("n", 1.0);
    (void)t.tablesOr("t");
  };
  for (std::string_view hostile :
       {"n = ", "[a\n", "n = 1\nn = 2\n", "[[a]]\n[a]\n", "n = \"open\n", "\x80\xff\xfe", "= 1", "n = 1e999999",
        "n = 99999999999999999999999", "a.b = 1\na = 2\n", "n = \"\\u{110000}\"", "t = [1, {}]", "\xef\xbb\xbf[[[",
        "n = 1979-05-27", "n = [[[[[[[["}) {
    const std::string line = lineOf(hostile, nothing);
    EXPECT_EQ(line.substr(0, 6), "a.toml") << hostile;
  }
  std::string deep = "n = ";
  for (int i = 0; i < 100000; ++i) deep += '[';
  EXPECT_NE(lineOf(deep, nothing), "");
}

TEST(TomlReader, EmptyMissingAndUnreadableFilesSaySo) {
  EXPECT_EQ(lineOf("", [](const TomlTable&) {}), "a.toml: is empty");
  EXPECT_EQ(lineOf("# only words\n", [](const TomlTable&) {}), "a.toml: is empty");
  const std::string missing = testing::TempDir() + "no-such-profile.toml";
  EXPECT_EQ(TomlReader::file(missing).error()->line(), missing + ": cannot be read (no such file)");
  EXPECT_EQ(TomlReader::file(testing::TempDir()).error()->line(),
            testing::TempDir() + ": cannot be read (not a readable file)");
}

TEST(TomlReader, FileAndTextReadTheSame) {
  const record::TempFolder folder;
  const std::string path = folder / "toml-reader-test.toml";
  ASSERT_TRUE(writeFileAtomically(path, "n = 4\n").ok());
  const TomlReader in = TomlReader::file(path);
  EXPECT_EQ(in.root().integer("n"), 4);
  EXPECT_EQ(in.root().place("n"), path + ":1");
  EXPECT_TRUE(in.finish().ok());
}

TEST(TomlReader, FreeKeysAreListedAndGivenAsText) {
  const TomlReader in = TomlReader::text("a = 0.2\nb = true\nc = \"auto\"\nd = 25600\ne = [1]\n[f]\n", "a.toml");
  const TomlTable root = in.root();
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"a", "b", "c", "d", "e", "f"}));
  EXPECT_EQ(root.scalarText("a"), "0.2");
  EXPECT_EQ(root.scalarText("b"), "true");
  EXPECT_EQ(root.scalarText("c"), "auto");
  EXPECT_EQ(root.scalarText("d"), "25600");
  EXPECT_TRUE(root.isTable("f"));
  EXPECT_FALSE(root.isTable("a"));
  EXPECT_TRUE(in.finish().ok());
  (void)root.scalarText("e");
  EXPECT_EQ(in.error()->line(), "a.toml:5: 'e' is not a single value");
}

// 50,000 nested keys ended every command: the library follows them by recursion.
TEST(TomlReader, TablesNestedTooDeeplyAreRefusedWithTheirLine) {
  std::string keys = "a";
  for (int k = 0; k < 50'000; ++k) keys += ".a";
  for (const std::string& text :
       {"x = 1\n" + keys + " = 1\n", "x = 1\n[" + keys + "]\n", "x = 1\ny = {" + keys + " = 1}\n"}) {
    const TomlReader reader = TomlReader::text(text, "deep.toml");
    ASSERT_TRUE(reader.error());
    EXPECT_NE(reader.error()->line().find("deep.toml:2: nests"), std::string::npos) << reader.error()->line();
  }
  std::string numbers = "x = [";
  for (int k = 0; k < 500; ++k) numbers += "1.5, ";
  EXPECT_FALSE(TomlReader::text(numbers + "]\n# " + keys + "\ny = \"" + keys + "\"\n", "numbers.toml").error());
}

TEST(TomlReader, APipeIsNoFile) {
  const std::string path = testing::TempDir() + "stillcut-toml-pipe-" + std::to_string(::getpid());
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const TomlReader reader = TomlReader::file(path);
  std::remove(path.c_str());
  ASSERT_TRUE(reader.error());
  EXPECT_NE(reader.error()->line().find("not a readable file"), std::string::npos) << reader.error()->line();
}

}  // namespace
}  // namespace stillcut::config
