#include "core/milling/identify/number_table.h"

#include <gtest/gtest.h>

namespace stillcut::identify {
namespace {

TEST(NumberTable, TakesAnySeparatorAndAHeader) {
  for (const char* text :
       {"f\tre\tim\n1\t2\t3\n4\t5\t6\n", "f,re,im\r\n1,2,3\r\n4,5,6", "1;2;3\n4;5;6;\n", "1 2  3\n 4 5 6\n\n"}) {
    const auto table = parseNumberTable(text, "t", 3);
    ASSERT_TRUE(table.ok()) << table.error().line();
    EXPECT_EQ(table->columns[2], (std::vector<double>{3, 6})) << text;
  }
}

TEST(NumberTable, NamesLineAndCause) {
  const auto words = parseNumberTable("1,2,3\n4,x,6\n", "t", 3);
  ASSERT_FALSE(words.ok());
  EXPECT_EQ(words.error().line(), "t:2: 'x' is not a number");
  const auto ragged = parseNumberTable("1,2,3\n4,5\n", "t", 3);
  ASSERT_FALSE(ragged.ok());
  EXPECT_EQ(ragged.error().line(), "t:2: has 2 columns (the rows before have 3)");
  const auto nan = parseNumberTable("1,2,3\n4,nan,6\n", "t", 3);
  ASSERT_FALSE(nan.ok());
  EXPECT_EQ(nan.error().line(), "t:2: column 2 is not finite");
  const auto comma = parseNumberTable("1,5\t2,5\t3,5\n1,6\t2,6\t3,6\n", "t", 3);
  EXPECT_FALSE(comma.ok());
}

TEST(NumberTable, RefusesProseAndBytes) {
  EXPECT_FALSE(parseNumberTable("a b c\nd e f\n", "t", 3).ok());
  EXPECT_FALSE(parseNumberTable(std::string(5000, '\0'), "t", 3).ok());
  EXPECT_FALSE(parseNumberTable("1,2,3\n", "t", 3).ok());
  std::string lines;
  for (int i = 0; i < 1000; ++i) lines += "word\n";
  const auto many = parseNumberTable(lines, "t", 3);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(text(many.error().why), "none in its first 64 lines");
}

}  // namespace
}  // namespace stillcut::identify
