// Tables as loggers, oscilloscopes and phones write them: times of every kind, rates in words, gaps, footers, and the
// numbers that nobody may guess.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "core/formats/wall_clock.h"
#include "core/session/open_recording.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A table of 40 rows at 10 kHz: a line of header, then what `row` makes of each.
std::string table(const std::string& header, const std::function<std::string(int)>& row, const std::string& tail = "") {
  std::string text = header;
  for (int i = 0; i < 40; ++i) text += row(i) + "\n";
  return text + tail;
}

std::string format(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

// The two channels of every table: 0.25 i - 3 and 5 - 0.125 i.
double first(int i) {
  return 0.25 * i - 3.0;
}
std::string both(int i) {
  return format("%.4f", first(i)) + "," + format("%.4f", 5.0 - 0.125 * i);
}

class TextTable : public testing::Test {
 protected:
  std::unique_ptr<RecordingReader> open(const std::string& content, const ReadOptions& options = {}) {
    auto reader = openRecording(folder_.file("cut.csv", content), options);
    if (reader) return std::move(*reader);
    ADD_FAILURE() << reader.error().line() << "\n" << content.substr(0, 200);
    return nullptr;
  }
  std::string refusal(const std::string& content, const ReadOptions& options = {}) {
    const auto reader = openRecording(folder_.file("cut.csv", content), options);
    return reader ? "was accepted" : reader.error().line();
  }
  // 10 kHz, two channels, 40 frames, whose first channel holds what was written.
  void expectWhole(const std::string& content, const ReadOptions& options = {}) {
    SCOPED_TRACE(content.substr(0, 120));
    const auto reader = open(content, options);
    ASSERT_TRUE(reader);
    EXPECT_NEAR(reader->format().rate.value, 10000.0, 1e-3);
    EXPECT_EQ(reader->format().frames, 40);
    ASSERT_EQ(reader->format().channels.size(), 2U);
    SampleBlock block;
    block.allocate(2, 64);
    ASSERT_TRUE(reader->read(block).ok());
    ASSERT_EQ(block.frames, 40);
    for (int i = 0; i < 40; ++i)
      EXPECT_FLOAT_EQ(block.channel(0)[static_cast<std::size_t>(i)], static_cast<float>(first(i)));
  }
  static ReadOptions rate(double hz) {
    ReadOptions options;
    options.rate = Hertz(hz);
    return options;
  }
  TempFolder folder_;
};

TEST_F(TextTable, TimesInEveryUnitByNameOrUnit) {
  struct Case {
    const char* header;
    double steps;  // of the column's unit in a tenth of a millisecond
  };
  for (const Case& c : {Case{"Time [msec]", 0.1},
                        {"Time (usec)", 100.0},
                        {"time_ns", 100000.0},
                        {"Time (ns)", 100000.0},
                        {"microseconds", 100.0},
                        {"millis", 0.1},
                        {"seconds_elapsed", 1e-4},
                        {"#time", 1e-4},
                        {"# Time (ms)", 0.1},
                        {"Elapsed Time (s)", 1e-4},
                        {"Second", 1e-4},
                        {"Seconds", 1e-4},
                        {"relative time", 1e-4},
                        {"Zeit (s)", 1e-4},
                        {"timestamp_us", 100.0}}) {
    expectWhole(
        table(std::string(c.header) + ",ax,ay\n", [&](int i) { return format("%.6f", c.steps * i) + "," + both(i); }));
  }
  expectWhole(table("Time,Channel A,Channel B\n(ms),(mV),(mV)\n\n",
                    [](int i) { return format("%.4f", 0.1 * i - 4000.0) + "," + both(i); }));
}

TEST_F(TextTable, ATimeWhoseUnitNobodyKnowsIsRefusedAndSetAsideByARate) {
  const std::string ticks = table("Time (ticks),ax,ay\n", [](int i) { return std::to_string(7 * i) + "," + both(i); });
  EXPECT_THAT(refusal(ticks), HasSubstr("the unit 'ticks' of its time is not known"));
  expectWhole(ticks, rate(10000.0));
  const std::string bare = table("time,ax,ay\n", [](int i) { return std::to_string(100 * i) + "," + both(i); });
  EXPECT_THAT(refusal(bare), HasSubstr("its time has no unit; its steps of 100 would be 0.01 Hz in seconds"));
  expectWhole(bare, rate(10000.0));
}

TEST_F(TextTable, TimesThatAreTooSlowInSecondsAreAskedFor) {
  const std::string steps = "its time has no unit; its steps of 0.1 would be 10 Hz in seconds";
  const auto row = [](int i) { return format("%.4f", 0.1 * i) + "," + both(i); };
  const std::string named = table("time,ax,ay\n", row), bare = table("", row);
  for (const std::string& content : {named, bare}) {
    EXPECT_THAT(refusal(content), HasSubstr(steps));
    EXPECT_THAT(refusal(content), HasSubstr("say --time-unit ms (10000 Hz), or s if it is that slow"));
    ReadOptions told;
    told.secondsPerTime = 1e-3;
    expectWhole(content, told);
    told.secondsPerTime = 1.0;
    EXPECT_NEAR(open(content, told)->format().rate.value, 10.0, 1e-6);
  }
  EXPECT_NEAR(open(table("Time (s),ax,ay\n", row))->format().rate.value, 10.0, 1e-6) << "the file says so itself";
  const auto slowest = open(table("time,ax,ay\n", [](int i) { return format("%.3f", 0.01 * i) + "," + both(i); }));
  EXPECT_NEAR(slowest->format().rate.value, 100.0, 1e-6) << "a phone's";
  const std::string ticks =
      table("Time (ticks),ax,ay\n", [](int i) { return std::to_string(100 * i) + "," + both(i); });
  ReadOptions micro;
  micro.secondsPerTime = 1e-6;
  expectWhole(ticks, micro);
}

TEST_F(TextTable, ASpectrumIsNoRecording) {
  for (const char* header : {"Frequency (Hz),X (g),Y (g)\n", "freq,x,y\n", "f [kHz],x,y\n"}) {
    const std::string content = table(header, [](int i) { return format("%.4f", 0.5 * i) + "," + both(i); });
    EXPECT_THAT(refusal(content), HasSubstr("is a spectrum and no recording")) << header;
  }
  // A speed in hertz beside times is none.
  const auto reader = open(table("Time (s),X (g),f (Hz)\n",
                                 [](int i) { return format("%.4f", 1e-4 * i) + ",0.5," + format("%.2f", 0.5 * i); }));
  EXPECT_EQ(reader->format().channels.size(), 1U);
}

TEST_F(TextTable, TheDayOfAClockStandsInAColumnOfItsOwn) {
  const auto rows = [](int i) { return "2026-11-25,08:59:59." + format("%06.0f", 100.0 * i) + "Z," + both(i); };
  const auto reader = open(table("Date,Time,ax,ay\n", rows));
  EXPECT_EQ(reader->format().started_ns, wallTime("2026-11-25T08:59:59Z"));
  const auto unclear = [](int i) { return "03/04/2026,08:59:59." + format("%06.0f", 100.0 * i) + "," + both(i); };
  EXPECT_EQ(open(table("Date,Time,ax,ay\n", unclear))->format().started_ns, 0) << "March or April";
}

TEST_F(TextTable, AColumnOfCommentsThatIsFilledIsNamed) {
  expectWhole(table("\"Time (s)\",\"ax\",\"ay\",\"Comment\"\n",
                    [](int i) { return "\"" + format("%.4f", 1e-4 * i) + "\"," + both(i) + ",\"a, b\""; }));
}

TEST_F(TextTable, TimesOfDayAndDates) {
  const auto clock = [](int i, const char* sign) {
    return std::string("08:59:59") + sign + format("%06.0f", 100.0 * i);
  };
  expectWhole(table("Timestamp,ax,ay\n", [&](int i) { return "2026-11-25 " + clock(i, ".") + "," + both(i); }));
  expectWhole(table("Timestamp,ax,ay\n", [&](int i) { return "2026-11-25T" + clock(i, ".") + "Z," + both(i); }));
  expectWhole(table("Timestamp,ax,ay\n", [&](int i) { return "2026-11-25T" + clock(i, ".") + "+01:00," + both(i); }));
  expectWhole(table("Time,ax,ay\n", [&](int i) { return clock(i, ".") + "," + both(i); }));
  expectWhole(table("Time,ax,ay\n", [&](int i) { return clock(i, ".") + " PM," + both(i); }));
  expectWhole(table("Date,Time,ax,ay\n", [&](int i) { return "2026/11/25," + clock(i, ".") + "," + both(i); }));
  expectWhole(table("Datum/Zeit;ax;ay\n", [&](int i) {
    std::string row = "25.11.2026 " + clock(i, ".") + ";" + format("%.4f", first(i)) + ";" + format("%.4f", 1.5);
    std::replace(row.begin() + 12, row.end(), '.', ',');
    return row;
  }));
}

TEST_F(TextTable, AClockPassesMidnight) {
  expectWhole(table("Time,ax,ay\n", [](int i) {
    const int us = 100 * i - 2000;
    return (us < 0 ? "23:59:59." + format("%06.0f", 1e6 + us) : "00:00:00." + format("%06.0f", us)) + "," + both(i);
  }));
}

TEST_F(TextTable, TimesSince1970InTheUnitThatTheirSizeShows) {
  for (const double perSecond : {1.0, 1e3, 1e6, 1e9}) {
    expectWhole(table("time,ax,ay\n", [&](int i) {
      const auto whole = static_cast<long long>(1.7e9 * perSecond);
      const double part = perSecond * 1e-4 * i;
      std::string time = std::to_string(whole + static_cast<long long>(part));
      if (perSecond < 1e4) time += format("%.6f", part - std::floor(part)).substr(1);
      return time + "," + both(i);
    }));
  }
}

TEST_F(TextTable, OfSeveralTimesTheOneWithAUnitIsTakenAndTheOthersAreNoChannels) {
  const auto reader = open(table("time,seconds_elapsed,z\n", [](int i) {
    return std::to_string(1700000000000000000LL + 100000LL * i) + "," + format("%.6f", 1e-4 * i) + "," +
           format("%.3f", first(i));
  }));
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->format().rate.value, 10000.0);
  ASSERT_EQ(reader->format().channels.size(), 1U);
  EXPECT_EQ(reader->format().channels[0].info.name, "z");
  EXPECT_THAT(reader->format().skipped, ElementsAre("time"));
}

TEST_F(TextTable, RatesInWords) {
  for (const char* header :
       {"Sample Rate: 10000 Hz. Sample values on linear scale.\n\nax,ay\n", "Sampling rate [Hz]:,10000\nax,ay\n",
        "# fs = 10 kHz\nax,ay\n", "Sample Interval,Analog:0.0001\nax,ay\n", "Delta t: 0.1 ms\nax,ay\n",
        "Sampling_Frequency;10000\nax,ay\n", "Abtastrate: 10 kHz\nax,ay\n", "dt (s),1e-4\nax,ay\n"}) {
    expectWhole(table(header, both));
  }
  expectWhole(table(
      "Sample,ax,ay\n", [](int i) { return std::to_string(i) + "," + both(i); }, "Rate 10000, overflows 0\n"));
  const auto reader = open(table("X,CH1,CH2,Start,Increment,\nSequence,Volt,Volt,0.000000e+00,1.000000e-04\n",
                                 [](int i) { return std::to_string(i) + "," + both(i) + ",,"; }));
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->format().rate.value, 10000.0);
  ASSERT_EQ(reader->format().channels.size(), 2U);
  EXPECT_EQ(reader->format().channels[0].unit, "Volt");
}

TEST_F(TextTable, WordsThatAreNoRateAreNone) {
  for (const char* header : {"Feed rate: 300 mm/min\nax,ay\n", "Sampling rate of channel 1: 5\nax,ay\n",
                             "Sample rate: 10 kHz\nSample rate: 20 kHz\nax,ay\n", "Refresh rate: 60 Hz\nax,ay\n"}) {
    EXPECT_THAT(refusal(table(header, both)), HasSubstr("the sampling rate is not known")) << header;
  }
}

TEST_F(TextTable, AHeaderBesideTheFirstRowsCostsNoRow) {
  const auto reader = open(table("", [](int i) {
    const char* beside[] = {"Record Length,4.0e+01,,", "Sample Interval,1.0e-04,,", "Source,CH1,,"};
    return (i < 3 ? beside[i] : ",,,") + format("%.6f", 1e-4 * i - 0.002) + "," + format("%.4f", first(i)) + ",";
  }));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 40);
  EXPECT_NEAR(reader->format().rate.value, 10000.0, 1e-3);
  EXPECT_EQ(reader->format().channels.size(), 1U);
}

TEST_F(TextTable, NumbersAsOtherProgramsPrintThem) {
  expectWhole(table("", [](int i) {
    std::string row = format("%.6E", 1e-4 * i) + " " + format("%.6E", first(i)) + " " + format("%.6E", 1.0);
    std::replace(row.begin(), row.end(), 'E', 'D');
    return row;
  }));
  expectWhole(table("Time (s)\tax (g)\tay (g)\n", [](int i) {
    return format("%.4f", 1e-4 * i) + "\t" + (first(i) < 0 ? "- " : "+ ") + format("%.4f", std::abs(first(i))) +
           "\t+ 1.5";
  }));
  expectWhole(table("Time (s)|ax (g)|ay (g)\n",
                    [](int i) { return format("%.4f", 1e-4 * i) + "|" + format("%.4f", first(i)) + "|1.5"; }));
  expectWhole(table("\"Time (s)\",\"ax (g)\",\"ay (g)\"\n", [](int i) {
    std::string row = "\"" + format("%.4f", 1e-4 * i) + "\",\"" + format("%.4f", first(i)) + "\",\"1.5\"";
    std::replace(row.begin(), row.end(), '.', ',');
    return row;
  }));
}

TEST_F(TextTable, ANumberIsNeverReadAsAnother) {
  const auto decimal = [](std::string row) {
    std::replace(row.begin(), row.end(), '.', ',');
    return row;
  };
  const std::string commas =
      table("Zeit (s),ax (g),ay (g)\n", [&](int i) { return decimal(format("%.4f", 1e-4 * i) + "," + both(i)); });
  EXPECT_THAT(refusal(commas), HasSubstr("both decimal signs and delimiters"));
  EXPECT_THAT(refusal(commas, rate(10000.0)), HasSubstr("both decimal signs and delimiters"));
  EXPECT_THAT(refusal("a,b\n1,25,3,50\n1,26,3,75\n1,27,3,80\n", rate(100.0)),
              HasSubstr(":1: names 2 columns where the rows have 4 (with decimal commas"));
  EXPECT_THAT(refusal("a;b\n1,234;2,345\n1,235;2,346\n1,236;2,347\n", rate(100.0)),
              HasSubstr("whether '1,234' has a decimal comma or thousands set apart"));
  const auto clear = open("a;b\n0,234;2,345\n1,235;2,346\n1,236;2,347\n", rate(100.0));
  EXPECT_TRUE(clear) << "0,234 can only be a decimal";
  const std::string points =
      table("t (s);a (g)\n", [](int i) { return "0,00" + std::to_string(10 + i) + ";" + (i == 20 ? "1.234" : "1,5"); });
  const auto reader = open(points);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 39) << "1.234 beside decimal commas may be 1234: missing, not guessed";
}

TEST_F(TextTable, ACellWithoutANumberIsAGap) {
  for (const char* cell : {"NaN", "", "OVERLOAD", "1e999"}) {
    const auto reader = open(table("Time (s),ax (g),ay (g)\n", [&](int i) {
      return format("%.4f", 1e-4 * i) + "," + (i == 12 ? cell : format("%.4f", first(i))) + ",1.5";
    }));
    ASSERT_TRUE(reader) << cell;
    EXPECT_EQ(reader->format().frames, 39);
    ASSERT_EQ(reader->format().notes.size(), 1U);
    EXPECT_THAT(text(reader->format().notes[0]), HasSubstr("1 of 40 rows")) << cell;
    EXPECT_THAT(text(reader->format().notes[0]), HasSubstr(":14: column 'ax' holds"));
    SampleBlock block;
    block.allocate(2, 64);
    ASSERT_TRUE(reader->read(block).ok());
    EXPECT_EQ(block.frames, 12);
    ASSERT_TRUE(reader->read(block).ok());
    EXPECT_EQ(block.frames, 27);
    EXPECT_TRUE(block.has(kBlockGap));
    EXPECT_EQ(block.lostFrames, 1U);
    EXPECT_EQ(toNs(block.firstSample), 1'300'000);
    EXPECT_TRUE(block.has(kBlockEnd));
  }
}

TEST_F(TextTable, WithoutTimesABadRowIsOneFrame) {
  const auto reader = open(
      table("ax,ay\n", [&](int i) { return i == 12 || i == 13 ? "x," + std::to_string(i) : both(i); }), rate(10000.0));
  ASSERT_TRUE(reader);
  SampleBlock block;
  block.allocate(2, 64);
  ASSERT_TRUE(reader->read(block).ok());
  ASSERT_TRUE(reader->read(block).ok());
  EXPECT_EQ(block.lostFrames, 2U);
  EXPECT_EQ(toNs(block.firstSample), 1'400'000);
  const std::string wide = table("ax,ay\n", [&](int i) { return i == 12 ? "1,2,3" : both(i); });
  EXPECT_THAT(refusal(wide, rate(10000.0)), HasSubstr(":14: has 3 columns where 2"));
}

TEST_F(TextTable, AFooterAndALastLineCutOffAreLeftOutAndSaid) {
  const auto row = [](int i) { return format("%.4f", 1e-4 * i) + "," + both(i); };
  auto reader = open(table("t_s,ax,ay\n", row, "End of data\n\nTotal,40\n"));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 40);
  ASSERT_EQ(reader->format().notes.size(), 1U);
  EXPECT_THAT(text(reader->format().notes[0]), HasSubstr("cut.csv:42: 'End of data'"));
  reader = open(table("t_s,ax,ay\n", row, "0.0041,1."));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 40);
  EXPECT_THAT(text(reader->format().notes.at(0)), HasSubstr("line 42, the last, is cut off"));
  EXPECT_THAT(refusal(table("t,ax,ay\n", row, "0.004,1\n0.0041,1\n")), HasSubstr(":42: has 2 columns where 3"))
      << "two such lines are another table";
}

TEST_F(TextTable, ColumnsOfUnequalLengthEndWithTheShortestAndSparseOnesAreLeftOut) {
  const std::string content = table("TimeStamp (s);2025-07-03 14-07-22;2025-07-03 14-42-33\n", [](int i) {
    return format("%.4f", 1e-4 * i) + ";" + format("%.4f", first(i)) + ";" + (i < 30 ? "1.5" : "");
  });
  auto reader = open(content);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 30);
  EXPECT_EQ(reader->format().channels.size(), 2U);
  EXPECT_THAT(text(reader->format().notes.at(0)), HasSubstr("after 30 of 40 rows"));
  ReadOptions longest;
  longest.channels = {0};
  reader = open(content, longest);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 40);
  EXPECT_THAT(reader->format().notes, testing::IsEmpty());
  reader = open(table("t,ax (g),temp (g)\n", [](int i) {
    return format("%.4f", 1e-4 * i) + "," + format("%.4f", first(i)) + "," + (i % 5 == 0 ? "21.5" : "");
  }));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().frames, 40);
  EXPECT_THAT(reader->format().skipped, ElementsAre("temp"));
}

TEST_F(TextTable, ATableWithoutAHeaderThatCountsItsRowsNeedsARate) {
  const std::string counted = table("", [](int i) { return std::to_string(i) + "," + both(i); });
  EXPECT_THAT(refusal(counted), HasSubstr("the sampling rate is not known"));
  expectWhole(counted, rate(10000.0));
}

// 2026-11-25 08:59:59 UTC.
TEST_F(TextTable, TheTimeOfDayOfTheFirstRowIsKeptWhereItIsSaid) {
  constexpr std::int64_t kBegun = 1'795'597'199'000'000'000;
  const auto rows = [](const std::function<std::string(int)>& time) {
    return [time](int i) { return time(i) + "," + both(i); };
  };
  const auto stamped = [](const char* zone) {
    return [zone](int i) { return format("2026-11-25T08:59:59.%04.0f", i) + zone; };
  };
  EXPECT_EQ(open(table("time,ax,ay\n", rows(stamped("Z"))))->format().started_ns, kBegun);
  EXPECT_EQ(open(table("time,ax,ay\n", rows(stamped("+01:00"))))->format().started_ns, kBegun - 3'600'000'000'000);
  EXPECT_EQ(open(table("time,ax,ay\n", rows([](int i) { return std::to_string(1'795'597'199'000'000 + 100 * i); })))
                ->format()
                .started_ns,
            kBegun);
  EXPECT_EQ(open(table("t (s),ax,ay\n", rows([](int i) { return format("%.4f", 1e-4 * i); })))->format().started_ns, 0);
  EXPECT_EQ(open(table("time,ax,ay\n", rows([](int i) { return format("08:59:59.%04.0f", i); })))->format().started_ns,
            0);
}

}  // namespace
}  // namespace stillcut::record
