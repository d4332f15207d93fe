// Cells and numbers of text recordings, against the plain way.
#include "core/formats/text/text_cells.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace stillcut::record {
namespace {

TEST(TextCells, EveryNumberAProgramPrintsReadsBack) {
  std::mt19937_64 random(1);
  const char* forms[] = {"%.17g", "%.16e", "%.9E", "%+.12g"};
  for (int trial = 0; trial < 40000; ++trial) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    char text[64];
    std::snprintf(text, sizeof text, forms[trial % 4], value);
    const auto got = parseNumber(text, false);
    ASSERT_TRUE(got.has_value()) << text;
    EXPECT_EQ(*got, std::strtod(text, nullptr)) << text;
    std::string german(text);
    for (char& c : german) c = c == '.' ? ',' : c;
    EXPECT_EQ(parseNumber(german, true), got) << german;
  }
}

TEST(TextCells, WordsOfNumbersThatAreNone) {
  EXPECT_TRUE(std::isnan(parseNumber("nan", false).value()));
  EXPECT_TRUE(std::isinf(parseNumber("inf", false).value()));
  EXPECT_TRUE(std::isinf(parseNumber("1e999", false).value()));
  EXPECT_EQ(parseNumber("1e-999", false), 0.0);
}

TEST(TextCells, WhatIsNoNumberIsNone) {
  for (const char* text : {"", "x", "1x", "1 2", "1.2.3", "--1", "+-1", "+", "-", "e5", "0x10", "1,5"}) {
    EXPECT_FALSE(parseNumber(text, false).has_value()) << text;
  }
  EXPECT_FALSE(parseNumber(std::string(100, '1'), false).has_value());
  EXPECT_FALSE(parseNumber("1,2,3", true).has_value());
}

TEST(TextCells, SplittingAndJoiningAreInverse) {
  std::mt19937 random(2);
  for (char delimiter : {',', ';', '\t'}) {
    for (int trial = 0; trial < 500; ++trial) {
      std::vector<std::string> wanted(1 + random() % 12);
      std::string line;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        for (auto n = random() % 6; n > 0; --n) wanted[i] += static_cast<char>('a' + random() % 26);
        const std::string blanks(random() % 3, ' ');
        line += (i > 0 ? std::string(1, delimiter) : "") + blanks +
                (trial % 2 == 0 ? "\"" + wanted[i] + "\"" : wanted[i]) + blanks;
      }
      std::vector<std::string_view> cells{"left over"};
      splitCells(line, delimiter, cells);
      ASSERT_EQ(cells.size(), wanted.size()) << line;
      for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(cells[i], wanted[i]) << line;
    }
  }
}

TEST(TextCells, ADelimiterWithinQuotesPartsNothing) {
  std::vector<std::string_view> cells;
  splitCells("\"Time (s)\", \"Acc, X (g)\",3", ',', cells);
  EXPECT_EQ(cells, (std::vector<std::string_view>{"Time (s)", "Acc, X (g)", "3"}));
  splitCells("\"Time (s)\" \"Acc X (g)\"", ' ', cells);
  EXPECT_EQ(cells, (std::vector<std::string_view>{"Time (s)", "Acc X (g)"}));
  splitCells("\"never closed,2", ',', cells);
  EXPECT_EQ(cells.size(), 2U);
}

TEST(TextCells, BlanksPartCellsHoweverMany) {
  std::vector<std::string_view> cells;
  splitCells("  1.5   2\t\t-3e4  ", ' ', cells);
  EXPECT_EQ(cells, (std::vector<std::string_view>{"1.5", "2", "-3e4"}));
  splitCells("", ' ', cells);
  EXPECT_TRUE(cells.empty());
  splitCells("", ',', cells);
  EXPECT_EQ(cells.size(), 1U);
  splitCells("1,,3,", ',', cells);
  EXPECT_EQ(cells, (std::vector<std::string_view>{"1", "", "3", ""}));
}

TEST(TextCells, TimeStampsAndBlankLinesArePassedOver) {
  for (const char* line : {"", "   ", "\t", "2016-05-26 21:15:16.881", "2016-05-26T21:15:16Z", " 2016-05-26 21:15 "}) {
    EXPECT_TRUE(isSkippedLine(line)) << line;
  }
  for (const char* line : {"1.0", "2016", "2016-05-26", "2016-05-26 21:15 noted", "2016/05/26 21:15:16", "-1,2"}) {
    EXPECT_FALSE(isSkippedLine(line)) << line;
  }
}

}  // namespace
}  // namespace stillcut::record
