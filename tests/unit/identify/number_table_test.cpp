#include "core/milling/identify/import/number_table.h"

#include <gtest/gtest.h>

#include <random>

namespace stillcut::identify {
namespace {

TEST(NumberTable, TakesAnySeparatorAndAHeader) {
  for (const char* text :
       {"f\tre\tim\n1\t2\t3\n4\t5\t6\n", "f,re,im\r\n1,2,3\r\n4,5,6", "1;2;3\n4;5;6;\n", "1 2  3\n 4 5 6\n\n",
        "f;re;im\n1,0;2,0;3,0\n4,0;5,0;6,0\n", "f\tre\tim\n1,0\t2,0\t3,0\n4,0\t5,0\t6,0\n"}) {
    const auto table = parseNumberTable(text, "t", 3);
    ASSERT_TRUE(table.ok()) << table.error().line();
    EXPECT_EQ(table->columns[2].real, (std::vector<double>{3, 6})) << text;
  }
}

TEST(NumberTable, ReadsComplexNumbersAsTheyArePrinted) {
  for (const char* cell : {"1.5e-7-2e-9i", "(1.5e-07-2e-09j)", "1.5e-7 - 2e-9i", "1.5E-007-2.0E-009*i"}) {
    const std::string text = "f,H\n1," + std::string(cell) + "\n2," + cell + "\n";
    const auto table = parseNumberTable(text, "t", 3);
    ASSERT_TRUE(table.ok()) << cell << ": " << table.error().line();
    ASSERT_EQ(table->columns.size(), 2u);
    EXPECT_TRUE(table->columns[0].imaginary.empty());
    EXPECT_DOUBLE_EQ(table->columns[1].real[1], 1.5e-7);
    EXPECT_DOUBLE_EQ(table->columns[1].imaginary[1], -2e-9);
  }
}

TEST(NumberTable, NamesAndUnitsComeFromTheNearestFittingLine) {
  const auto one = parseNumberTable("made 1998\nFrequency (Hz),Real ((m/s^2)/N),Im_m/N\n1,2,3\n4,5,6\n", "t", 3);
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(one->columns[0].name, "Frequency");
  EXPECT_EQ(one->columns[1].unit, "(m/s^2)/N");
  EXPECT_EQ(one->columns[2].name, "Im");
  EXPECT_EQ(one->columns[2].unit, "m/N");
  const auto two = parseNumberTable("Freq\tReal\tImag\nkHz\tum/N\tum/N\n1\t2\t3\n4\t5\t6\n", "t", 3);
  ASSERT_TRUE(two.ok());
  EXPECT_EQ(two->columns[1].name, "Real");
  EXPECT_EQ(two->columns[0].unit, "kHz");
  EXPECT_EQ(two->columns[2].unit, "um/N");
  const auto behind = parseNumberTable("1\t2\t3\tFreq\tHz\tReal\tmm/N\n4\t5\t6\n", "t", 3);
  ASSERT_TRUE(behind.ok());
  EXPECT_EQ(behind->remarks, (std::vector<std::string>{"Freq", "Hz", "Real", "mm/N"}));
  const auto latin = parseNumberTable("f,Re [(m/s\xB2)/N],Im [(m/s\xB2)/N]\n1,2,3\n4,5,6\n", "t", 3);
  ASSERT_TRUE(latin.ok());
  EXPECT_EQ(latin->columns[1].unit, "(m/s\xC2\xB2)/N");
}

TEST(NumberTable, AHeaderMayBeLong) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "User-defined property " + std::to_string(i) + ":\t0\n";
  const auto table = parseNumberTable(text + "Line\tX [Hz]\tReal\tImaginary\n1\t2\t3\t4\n2\t4\t5\t6\n", "t", 3);
  ASSERT_TRUE(table.ok()) << table.error().line();
  EXPECT_EQ(table->columns[1].unit, "Hz");
  EXPECT_EQ(table->rows(), 2u);
}

TEST(NumberTable, NamesLineAndCause) {
  const auto words = parseNumberTable("1,2,3\n4,x,6\n", "t", 3);
  ASSERT_FALSE(words.ok());
  EXPECT_EQ(words.error().line(), "t:2: 'x' is not a number");
  const auto ragged = parseNumberTable("1,2,3\n4,5,6\n7,8\n", "t", 3);
  ASSERT_FALSE(ragged.ok());
  EXPECT_EQ(ragged.error().line(), "t:3: has 2 columns (the rows before have 3)");
}

TEST(NumberTable, RowsThatAreNotFiniteAreLeftOutAndCounted) {
  for (const char* first : {"0,nan,nan", "0,inf,0", "0,NaN,-inf"}) {
    const auto table = parseNumberTable(std::string("f,re,im\n") + first + "\n1,2,3\n4,5,6\n", "t", 3);
    ASSERT_TRUE(table.ok()) << table.error().line();
    EXPECT_EQ(table->rows(), 2u);
    EXPECT_EQ(table->leftOut, 1u);
    EXPECT_EQ(table->columns[0].real[0], 1.0);
  }
  const auto empty = parseNumberTable("f [Hz],re,im\n0.0,,\n1,2,3\n4,5,6\n", "t", 3);
  ASSERT_TRUE(empty.ok()) << empty.error().line();
  EXPECT_EQ(empty->rows(), 2u);
  EXPECT_EQ(empty->columns[0].name, "f");
}

TEST(NumberTable, EverySpellingOfAComplexNumber) {
  for (const char* cell :
       {"(3+-4j)", "3+-4j", "3-4j", "3-j4", "3 - 4i", "3-4*i", "(3,-4)", "5\xE2\x88\xA0-53.130102354156\xC2\xB0",
        "5<-53.130102354156 deg", "5\xE2\x88\xA0-0.927295218001612 rad"}) {
    const auto table = parseNumberTable(std::string("1;") + cell + "\n2;1+2j\n", "t", 3);
    ASSERT_TRUE(table.ok()) << cell << table.error().line();
    ASSERT_EQ(table->columns.size(), 2u) << cell;
    EXPECT_NEAR(table->columns[1].real[0], 3.0, 1e-9) << cell;
    EXPECT_NEAR(table->columns[1].imaginary[0], -4.0, 1e-9) << cell;
  }
  const auto positive = parseNumberTable("1\t1e-7+j3e-9\n2\t1e-7+-3e-9j\n", "t", 3);
  ASSERT_TRUE(positive.ok()) << positive.error().line();
  EXPECT_DOUBLE_EQ(positive->columns[1].real[0], 1e-7);
  EXPECT_DOUBLE_EQ(positive->columns[1].imaginary[0], 3e-9);
  EXPECT_DOUBLE_EQ(positive->columns[1].imaginary[1], -3e-9);
  for (const char* cell : {"5<30", "3++4j", "j", "(3,4", "ij"}) {
    EXPECT_FALSE(parseNumberTable(std::string("1;") + cell + "\n2;" + cell + "\n", "t", 3).ok()) << cell;
  }
}

TEST(NumberTable, RefusesProseAndBytes) {
  EXPECT_FALSE(parseNumberTable("a b c\nd e f\n", "t", 3).ok());
  EXPECT_FALSE(parseNumberTable(std::string(5000, '\0'), "t", 3).ok());
  EXPECT_FALSE(parseNumberTable("1,2,3\n", "t", 3).ok());
  std::string lines;
  for (int i = 0; i < 1000; ++i) lines += "word\n";
  const auto many = parseNumberTable(lines, "t", 3);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(text(many.error().why), "none in its first 512 lines");
}

TEST(NumberTable, RandomBytesNeverBreakIt) {
  std::mt19937 random(7);
  const std::string good = "f\tH\n1.0e+000\t2.0e-007-1.0e-008i\n2.0e+000\t3.0e-007-2.0e-008i\n";
  for (int trial = 0; trial < 5000; ++trial) {
    std::string bytes = good;
    for (int k = 0; k < 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    const auto got = parseNumberTable(bytes, "t", 3);
    EXPECT_EQ(got ? std::string::npos : got.error().line().find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace stillcut::identify
