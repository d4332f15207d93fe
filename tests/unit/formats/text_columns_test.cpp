// Tables whose columns are not what they seem: numbers of rows, labels, clocks of their own, segments; and LabVIEW's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "core/session/open_recording.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

class TextColumns : public testing::Test {
 protected:
  // Null where it is refused.
  std::unique_ptr<RecordingReader> open(const std::string& content) {
    auto reader = openRecording(folder_.file("cut.csv", content));
    EXPECT_TRUE(reader) << reader.error().line();
    return reader ? std::move(*reader) : nullptr;
  }
  std::string refusal(const std::string& content) {
    const auto reader = openRecording(folder_.file("cut.csv", content));
    return reader ? "was accepted" : reader.error().line();
  }

  TempFolder folder_;
};

// `rows` rows: `line` gives each.
std::string table(const std::string& header, int rows, const std::function<std::string(int)>& line) {
  std::string text = header;
  for (int i = 0; i < rows; ++i) text += line(i) + "\n";
  return text;
}

TEST_F(TextColumns, TheNumberOfTheRowIsNoChannelWhateverItsName) {
  for (const char* name : {"No.", "Nr", "", "reading"}) {
    const auto reader = open(table(std::string(name) + ",t,a\n", 60, [](int i) {
      return std::to_string(i + 1) + "," + std::to_string(0.001 * i) + "," + std::to_string(i % 7);
    }));
    ASSERT_TRUE(reader) << name;
    EXPECT_EQ(reader->format().channels.size(), 1U) << name;
    EXPECT_DOUBLE_EQ(reader->format().rate.value, 1000.0) << name;
  }
  EXPECT_THAT(
      refusal(table(
          ",t,a\n", 60,
          [](int i) { return std::to_string(3 * i) + "," + std::to_string(0.001 * i) + ",1," + std::to_string(i); })),
      HasSubstr("names 2 columns where the rows have 4"));
}

TEST_F(TextColumns, AColumnOfWordsIsNoChannel) {
  const auto reader = open(table("t (s),a (g),label\n", 60, [](int i) {
    return std::to_string(0.001 * i) + "," + std::to_string(i % 7) + (i < 30 ? ",stable" : ",chatter");
  }));
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->format().channels.size(), 1U);
  EXPECT_EQ(reader->format().channels[0].info.name, "a");
  EXPECT_EQ(reader->format().frames, 60);
  EXPECT_THAT(reader->format().skipped, testing::ElementsAre("label"));
}

TEST_F(TextColumns, AColumnWithoutAnyNumberIsLeftOut) {
  const auto reader = open(table("t (s),a (g),b (g)\n", 60,
                                 [](int i) { return std::to_string(0.001 * i) + ",NaN," + std::to_string(i % 7); }));
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->format().channels.size(), 1U);
  EXPECT_EQ(reader->format().channels[0].info.name, "b");
  EXPECT_EQ(reader->format().frames, 60);
  EXPECT_EQ(reader->format().notes.size(), 1U);
}

TEST_F(TextColumns, ColumnsWithTimesOfTheirOwnAreNotMixed) {
  const auto two = [](double step) {
    return table("Time1 (s),a (g),Time2 (s),b (g)\n", 60, [step](int i) {
      return std::to_string(0.001 * i) + ",1," + std::to_string(0.0002 + step * i) + "," + std::to_string(i % 7);
    });
  };
  const auto same = open(two(0.001));
  ASSERT_TRUE(same);
  EXPECT_EQ(same->format().channels.size(), 2U);
  EXPECT_THAT(refusal(two(0.002)), HasSubstr("'Time2' goes in other steps"));
}

TEST_F(TextColumns, DaysOfASpreadsheetAreNoSeconds) {
  EXPECT_THAT(refusal(table("Time,a\n", 60,
                            [](int i) {
                              char text[64];
                              std::snprintf(text, sizeof text, "%.12f,%d", 46351.375 + 0.001 * i / 86400.0, i % 7);
                              return std::string(text);
                            })),
              HasSubstr("in days, as spreadsheets count them"));
}

TEST_F(TextColumns, ThousandsBesideDecimalCommasAreAskedFor) {
  EXPECT_THAT(refusal("Zeit;a\n0,000;1.234\n0,001;2.345\n0,002;3.456\n0,003;4.567\n"),
              HasSubstr("'1.234' has a decimal point or thousands set apart"));
  std::string rows = "Zeit;a;b\n";
  for (int i = 0; i < 10; ++i) rows += "0,00" + std::to_string(i) + ";1.234;2.345\n";
  EXPECT_THAT(refusal(rows), HasSubstr("thousands set apart")) << "no column of labels";
}

TEST_F(TextColumns, MonthsMayHaveNames) {
  const auto reader = open(table("Time,a\n", 60, [](int i) {
    char text[64];
    std::snprintf(text, sizeof text, "25-Nov-2026 08:59:59.%03d,%d", i, i % 7);
    return std::string(text);
  }));
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->format().rate.value, 1000.0);
  EXPECT_GT(reader->format().started_ns, 0);
}

TEST_F(TextColumns, LabViewWithoutTimesWithACommentAndWithTimesForEach) {
  const std::string head =
      "LabVIEW Measurement\t\nX_Columns\tNo\n***End_of_Header***\t\n\t\nChannels\t2\t\t\nY_Unit_Label\tg\tN\t\n"
      "Delta_X\t0.001\t0.001\t\n***End_of_Header***\t\t\t\n";
  const auto none = open(head + "\tAx\tFx\tComment\n\t1\t2\n\t3\t4\n\t5\t6\n\t7\t8\n");
  ASSERT_TRUE(none);
  ASSERT_EQ(none->format().channels.size(), 2U);
  EXPECT_EQ(none->format().channels[0].unit, "g");
  EXPECT_EQ(none->format().channels[1].unit, "N");
  EXPECT_DOUBLE_EQ(none->format().rate.value, 1000.0);
  const auto commented =
      open(head + "X_Value\tAx\tFx\tComment\n0\t1\t2\tstart\n0.001\t3\t4\n0.002\t5\t6\n0.003\t7\t8\n");
  ASSERT_TRUE(commented);
  EXPECT_EQ(commented->format().frames, 4);
  EXPECT_EQ(commented->format().channels.size(), 2U);
  const auto each =
      open(head + "X_Value\tAx\tX_Value\tFx\tComment\n0\t1\t0\t2\n0.001\t3\t0.001\t4\n0.002\t5\t0.002\t6\n");
  ASSERT_TRUE(each);
  ASSERT_EQ(each->format().channels.size(), 2U);
  EXPECT_EQ(each->format().channels[1].unit, "N");
  std::string rates = head;
  rates.replace(rates.find("0.001\t0.001"), 11, "0.001\t0.002");
  EXPECT_THAT(refusal(rates + "\tAx\tFx\tComment\n\t1\t2\n\t3\t4\n\t5\t6\n"), HasSubstr("several rates"));
}

// LabVIEW with a header above every segment.
std::string segments(const std::string& xColumn, const std::vector<std::string>& rows) {
  std::string text = "LabVIEW Measurement\t\nMulti_Headings\tYes\nX_Columns\tOne\t\n***End_of_Header***\t\n\t\n";
  for (const std::string& segment : rows) {
    text += "Channels\t1\t\t\nY_Unit_Label\tg\t\t\nDelta_X\t0.001000\t\t\n***End_of_Header***\t\t\t\n" + xColumn +
            "\tAx\tComment\n" + segment + "\n";
  }
  return text;
}

TEST_F(TextColumns, SegmentsOfLabViewThatGoOnAreOneRecording) {
  const auto reader = open(segments("X_Value", {"0\t1\n0.001\t2\n0.002\t3\n", "0.003\t4\n0.004\t5\n", "0.008\t9\n"}));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 6);
  EXPECT_DOUBLE_EQ(reader->format().rate.value, 1000.0);
  EXPECT_EQ(reader->format().channels.size(), 1U);
  EXPECT_TRUE(reader->format().notes.empty());
  SampleBlock block;
  block.allocate(1, 100);
  std::uint64_t lost = 0;
  for (Result<bool> more = reader->read(block); more && *more; more = reader->read(block)) lost += block.lostFrames;
  EXPECT_EQ(lost, 3U) << "time between segments is a gap";
}

// Without a column of times: the header says when a segment begins.
std::string startedSegments(const std::vector<std::pair<std::string, int>>& starts) {
  std::string text =
      "LabVIEW Measurement\t\nMulti_Headings\tYes\nX_Columns\tNo\t\nDate\t2026/11/25\t\n"
      "Time\t08:00:00.5\t\n***End_of_Header***\t\n\t\n";
  int value = 0;
  for (const auto& [start, rows] : starts) {
    text += "Channels\t1\t\t\nY_Unit_Label\tg\t\t\n" + start +
            "Delta_X\t0.001000\t\t\n***End_of_Header***\t\t\t\nX_Value\tAx\tComment\n";
    for (int i = 0; i < rows; ++i) text += "\t" + std::to_string(0.5 * (value++ % 7)) + "\n";
    text += "\n";
  }
  return text;
}

TEST_F(TextColumns, HeadersOfLabViewTellWhatIsMissingBetweenSegments) {
  const std::string day = "Date\t2026/11/25\t\nTime\t08:59:59.";
  const auto lostOf = [&](const std::vector<std::pair<std::string, int>>& starts, std::int64_t frames) {
    const auto reader = open(startedSegments(starts));
    if (!reader) return std::int64_t{-1};
    EXPECT_EQ(reader->format().frames, frames);
    EXPECT_EQ(reader->format().channels.size(), 1U);
    EXPECT_TRUE(reader->format().notes.empty());
    SampleBlock block;
    block.allocate(1, 100);
    std::int64_t lost = 0;
    for (Result<bool> more = reader->read(block); more && *more; more = reader->read(block))
      lost += static_cast<std::int64_t>(block.lostFrames);
    return lost;
  };
  const std::string first = day + "9500\t\nX0\t0\t\n";
  EXPECT_EQ(lostOf({{first, 5}, {day + "9500\t\nX0\t0.005\t\n", 5}, {day + "9500\t\nX0\t0.010\t\n", 4}}, 14), 0);
  EXPECT_EQ(lostOf({{first, 5}, {day + "9580\t\nX0\t0\t\n", 5}, {day + "9660\t\nX0\t0\t\n", 4}}, 14), 6);
  EXPECT_EQ(lostOf({{first, 5}, {day + "9540\t\nX0\t0\t\n", 5}}, 10), 0) << "a millisecond early by its clock";
  EXPECT_THAT(refusal(startedSegments({{first, 300}, {day + "9500\t\nX0\t0\t\n", 5}})),
              HasSubstr(": a second segment"));
}

TEST_F(TextColumns, SegmentsWhoseTimesBeginAgainAreRefused) {
  EXPECT_THAT(refusal(segments("X_Value", {"0\t1\n0.001\t2\n0.002\t3\n", "0\t4\n0.001\t5\n"})),
              HasSubstr(": a second segment"));
  EXPECT_THAT(refusal(segments("", {"\t1\n\t2\n\t3\n", "\t4\n\t5\n"})), HasSubstr(": a second segment"));
}

}  // namespace
}  // namespace stillcut::record
