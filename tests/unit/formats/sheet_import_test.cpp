// Tables out of spreadsheets (XLSX) and text in UTF-16: what the same rows are as CSV.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/formats/utf_text.h"
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"
#include "tests/support/zip_archive.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr const char* kWorkbook =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?><workbook xmlns:r=\"r\"><workbookPr/><sheets>"
    "<sheet name=\"Cut &amp; more\" sheetId=\"2\" r:id=\"rId7\"/><sheet name=\"Other\" sheetId=\"1\" r:id=\"rId1\"/>"
    "</sheets></workbook>";
constexpr const char* kRelations =
    "<Relationships><Relationship Id=\"rId1\" Target=\"worksheets/sheet1.xml\"/>"
    "<Relationship Id='rId7' Target='/xl/worksheets/sheet2.xml'/></Relationships>";
constexpr const char* kStrings =
    "<sst><si><t>Time (s)</t></si><si><r><t>Acc </t></r><r><t xml:space=\"preserve\">(g)</t></r>"
    "<rPh><t>spoken</t></rPh></si><si><t>Force (N)</t></si></sst>";
// Style 0: number; 1: a date of its own format; 2: built-in time of day.
constexpr const char* kStyles =
    "<styleSheet><numFmts><numFmt numFmtId=\"164\" formatCode=\"yyyy\\-mm\\-dd hh:mm:ss.000\"/></numFmts>"
    "<cellStyleXfs><xf numFmtId=\"14\"/></cellStyleXfs>"
    "<cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"164\"/><xf numFmtId=\"21\"/></cellXfs></styleSheet>";

std::string cell(const char* column, int row, const std::string& rest) {
  return std::string("<c r=\"") + column + std::to_string(row) + "\"" + rest + "</c>";
}
std::string number(const char* column, int row, double value, int style = 0) {
  char text[64];
  std::snprintf(text, sizeof text, " s=\"%d\"><v>%.17g</v>", style, value);
  return cell(column, row, text);
}

// A title, a header, 200 rows; `time`: what stands in the first column.
std::string sheet(const std::function<std::string(int row)>& time) {
  std::string xml = "<worksheet><!-- made > by a test --><sheetData><row r=\"1\">" +
                    cell("A", 1, " t=\"inlineStr\"><is><t>Cut of a test</t></is>") + "</row><row r=\"3\">" +
                    cell("A", 3, " t=\"s\"><v>0</v>") + cell("B", 3, " t=\"s\"><v>1</v>") +
                    cell("D", 3, " t=\"s\"><v>2</v>") + "</row>";
  for (int i = 0; i < 200; ++i) {
    const int row = 4 + i;
    xml += "<row r=\"" + std::to_string(row) + "\">" + time(i) + number("B", row, std::sin(0.1 * i)) +
           number("D", row, 10.0 * i) + "</row>";
  }
  return xml + "</sheetData></worksheet>";
}

// `content`: of the first sheet by name, "Cut & more"; `other`: of the second, "Other".
std::string workbook(const std::string& content, const std::string& other = "<worksheet><sheetData/></worksheet>") {
  return zip({{"xl/workbook.xml", kWorkbook},
              {"xl/_rels/workbook.xml.rels", kRelations},
              {"xl/sharedStrings.xml", kStrings},
              {"xl/styles.xml", kStyles},
              {"xl/worksheets/sheet1.xml", other},
              {"xl/worksheets/sheet2.xml", content}},
             true);
}

TEST(Sheets, AreReadAsTheirTables) {
  const TempFolder folder;
  const WholeRecording all =
      readAll(folder.file("cut.xlsx", workbook(sheet([](int i) { return number("A", 4 + i, 1e-3 * i); }))));
  ASSERT_EQ(all.error, "");
  EXPECT_NEAR(all.format.rate.value, 1000.0, 1e-6);
  ASSERT_EQ(all.format.channels.size(), 2U);
  EXPECT_EQ(all.format.channels[0].info.name, "Acc");
  EXPECT_DOUBLE_EQ(all.format.channels[0].info.scale, 9.80665);
  EXPECT_EQ(all.format.channels[1].info.quantity, SensorQuantity::Force);
  ASSERT_EQ(all.values[0].size(), 200U);
  EXPECT_NEAR(all.values[0][50], 9.80665 * std::sin(5.0), 1e-5);
  EXPECT_NEAR(all.values[1][199], 1990.0, 1e-3);
}

TEST(Sheets, DatesAndTimesOfDayAreTimes) {
  const TempFolder folder;
  // 46351.375 is 2026-11-25 09:00; a millisecond is 1/86 400 000 of a day.
  for (const std::pair<int, double>& as : {std::pair{1, 46351.375}, {2, 0.375}}) {
    const std::string content =
        sheet([as](int i) { return number("A", 4 + i, as.second + 1e-2 * i / 86400.0, as.first); });
    const WholeRecording all = readAll(folder.file("cut.xlsx", workbook(content)));
    ASSERT_EQ(all.error, "") << as.first;
    EXPECT_NEAR(all.format.rate.value, 100.0, 0.01) << as.first;
    EXPECT_EQ(all.values[0].size(), 200U);
  }
}

TEST(Sheets, OfSeveralTheFirstWithRowsOfNumbersIsReadAndTold) {
  const TempFolder folder;
  const std::string words = "<worksheet><sheetData><row r=\"1\">" +
                            cell("A", 1, " t=\"inlineStr\"><is><t>Machine</t></is>") +
                            cell("B", 1, " t=\"inlineStr\"><is><t>Mill 3</t></is>") + "</row></sheetData></worksheet>";
  const auto rate = [](double hertz) { return sheet([hertz](int i) { return number("A", 4 + i, i / hertz); }); };
  const WholeRecording second = readAll(folder.file("second.xlsx", workbook(words, rate(500.0))));
  ASSERT_EQ(second.error, "");
  EXPECT_NEAR(second.format.rate.value, 500.0, 1e-6);
  ASSERT_EQ(second.format.notes.size(), 1U);
  EXPECT_THAT(text(second.format.notes[0]), HasSubstr("of its 2 sheets 'Other' is read"));
  const std::string both = folder.file("both.xlsx", workbook(rate(1000.0), rate(500.0)));
  EXPECT_NEAR(readAll(both).format.rate.value, 1000.0, 1e-6);
  EXPECT_NEAR(readAll(both + ":/Other").format.rate.value, 500.0, 1e-6);
  EXPECT_NEAR(readAll(both + ":/Cut & more").format.rate.value, 1000.0, 1e-6);
  EXPECT_THAT(readAll(both + ":/other").error, HasSubstr("has no sheet 'other' (it has 'Cut & more', 'Other')"));
  EXPECT_THAT(readAll(folder.file("none.xlsx", workbook(words, words))).error,
              HasSubstr("none of its sheets holds rows of numbers"));
  EXPECT_EQ(readAll(folder.file("cut.csv", workbook(words, rate(500.0)))).error, "") << "by content, not by name";
}

TEST(Sheets, DamagedOnesAreRefusedInOneLine) {
  const TempFolder folder;
  const std::string whole = workbook(sheet([](int i) { return number("A", 4 + i, 1e-3 * i); }));
  for (std::size_t keep = 4; keep < whole.size(); keep += 71)
    EXPECT_NE(readAll(folder.file("cut.xlsx", whole.substr(0, keep))).error, "") << keep;
  for (const char* odd : {"", "<", "<worksheet", "<!DOCTYPE a [<!ENTITY b 'c'>]><worksheet/>", "<c r=\"A1\"><v>1</v>",
                          "<row r=\"1\"><c r=\"ZZZZZZZ1\"><v>&#99999999999;</v></c></row>"}) {
    EXPECT_NE(readAll(folder.file("cut.xlsx", workbook(odd))).error, "") << odd;
  }
}

TEST(TextInUtf16, IsReadInBothOrders) {
  const TempFolder folder;
  std::string table = "Zeit (s);Beschleunigung \u00e4\U0001F527 (g)\r\n";
  for (int i = 0; i < 5000; ++i) table += "0," + std::to_string(10000 + i) + ";" + std::to_string(i % 7) + ",5\r\n";
  for (const bool big : {false, true}) {
    std::string bytes = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const std::uint16_t letter : toUtf16(table)) {
      const char low = static_cast<char>(letter & 0xFFU), high = static_cast<char>(letter >> 8U);
      bytes += big ? high : low;
      bytes += big ? low : high;
    }
    const WholeRecording all = readAll(folder.file("cut.txt", bytes));
    ASSERT_EQ(all.error, "");
    EXPECT_NEAR(all.format.rate.value, 1e5, 1.0);
    ASSERT_EQ(all.values.at(0).size(), 5000U);
    EXPECT_NEAR(all.values[0][6], 9.80665 * 6.5, 1e-4);
    EXPECT_THAT(all.format.channels[0].info.name, HasSubstr("\u00e4"));
  }
}

}  // namespace
}  // namespace stillcut::record
