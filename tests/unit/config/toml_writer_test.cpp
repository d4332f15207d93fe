#include "core/config/toml_writer.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/config/toml_reader.h"

namespace stillcut::config {
namespace {

TEST(TomlWriter, WritesWhatTheReaderReads) {
  TomlWriter out;
  out.comment("one machine");
  out.text("name", "Mill \"3\" \\ T12\tnew\nline \x01 \xc3\xa4");
  out.table("tool");
  out.integer("teeth", 4);
  out.number("diameter_mm", 0.012 * 1e3);
  out.boolean("coated", true);
  out.text("odd key", "");
  for (const char* name : {"x", "y"}) {
    out.arrayElement("channels");
    out.text("name", name);
  }
  const TomlReader in = TomlReader::text(out.content(), "w.toml");
  ASSERT_FALSE(in.error()) << in.error()->line() << "\n" << out.content();
  EXPECT_EQ(in.root().text("name"), "Mill \"3\" \\ T12\tnew\nline \x01 \xc3\xa4");
  const TomlTable tool = in.root().table("tool");
  EXPECT_EQ(tool.integer("teeth"), 4);
  EXPECT_DOUBLE_EQ(tool.number("diameter_mm"), 12.0);
  EXPECT_TRUE(tool.boolean("coated"));
  EXPECT_EQ(tool.text("odd key"), "");
  const auto channels = in.root().tables("channels");
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[0].text("name"), "x");
  EXPECT_EQ(channels[1].text("name"), "y");
  EXPECT_TRUE(in.finish().ok());
}

TEST(TomlWriter, ScalarsReadBackAsTheSameText) {
  for (const char* text : {"0.2", "true", "auto", "25600", "200000", "1e-05", "007", "1e5", "1e+20", "-0", "nan", "inf",
                           "+1", "0x10", "9007199254740993", "", "/dev/ttyUSB0", "1.0", " 1"}) {
    TomlWriter out;
    out.scalar("k", text);
    const TomlReader in = TomlReader::text(out.content(), "w.toml");
    EXPECT_EQ(in.root().scalarText("k"), text) << out.content();
    EXPECT_TRUE(in.finish().ok());
  }
}

TEST(TomlWriter, NumbersAndTruthAreWrittenBare) {
  TomlWriter out;
  out.scalar("a", "0.2");
  out.scalar("b", "true");
  out.scalar("c", "auto");
  EXPECT_EQ(out.content(), "a = 0.2\nb = true\nc = \"auto\"\n");
}

TEST(TomlWriter, SavesWholeOrNotAtAll) {
  TomlWriter out;
  out.integer("n", 1);
  const std::string nowhere = testing::TempDir() + "no-such-folder/p.toml";
  const Status failed = out.save(nowhere);
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().line(), nowhere + ": cannot be written (No such file or directory)");
  EXPECT_FALSE(std::filesystem::exists(testing::TempDir() + "no-such-folder"));
}

}  // namespace
}  // namespace stillcut::config
