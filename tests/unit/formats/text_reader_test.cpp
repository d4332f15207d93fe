// Text recordings: every shape of header and number this program promises to read, and one clear line for the rest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/session/open_recording.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct ReadBack {
  std::vector<std::vector<float>> channels;
  std::vector<SampleBlock> blocks;
  std::string error;
};

ReadBack readAll(RecordingReader& reader, int blockFrames = 4) {
  ReadBack all;
  all.channels.resize(reader.format().channels.size());
  SampleBlock block;
  block.allocate(static_cast<int>(all.channels.size()), blockFrames);
  while (true) {
    const Result<bool> more = reader.read(block);
    if (!more) all.error = more.error().line();
    if (!more || !*more) return all;
    all.blocks.push_back(block);
    for (std::size_t c = 0; c < all.channels.size(); ++c) {
      const auto from = block.channel(static_cast<int>(c));
      all.channels[c].insert(all.channels[c].end(), from.begin(), from.end());
    }
  }
}

class TextRecording : public testing::Test {
 protected:
  // Opens `content` as a file; records a failure when it is refused.
  std::unique_ptr<RecordingReader> open(std::string_view content, const ReadOptions& options = {}) {
    Result<std::unique_ptr<RecordingReader>> reader = openRecording(folder_.file("cut.csv", content), options);
    if (!reader) {
      ADD_FAILURE() << reader.error().line();
      return nullptr;
    }
    return std::move(*reader);
  }
  std::string refusal(std::string_view content, const ReadOptions& options = {}) {
    const std::string path = folder_.file("cut.csv", content);
    const Result<std::unique_ptr<RecordingReader>> reader = openRecording(path, options);
    if (reader) return "was accepted";
    EXPECT_THAT(reader.error().line(), testing::StartsWith(path)) << "the file must be named";
    EXPECT_EQ(reader.error().line().find('\n'), std::string::npos) << "one line";
    return reader.error().line().substr(path.size());
  }
  static ReadOptions rate(double hz) {
    ReadOptions options;
    options.rate = Hertz(hz);
    return options;
  }
  TempFolder folder_;
};

TEST_F(TextRecording, ColumnsWithUnitsAreChannelsAndAnIndicatorWithoutOneIsNot) {
  const auto reader = open(
      "Time (s),Accel X (m/s^2),Accel Y (g),Score\n"
      "8.5000,1.0,-1.0,0.3\n8.5005,2.0,-2.0,0.3\n8.5010,3.0,-3.0,0.3\n8.5015,4.0,-4.0,0.3\n8.5020,5.0,-5.0,0.3\n");
  ASSERT_TRUE(reader);
  const RecordingFormat& format = reader->format();
  EXPECT_DOUBLE_EQ(format.rate.value, 2000.0);
  EXPECT_EQ(format.frames, 5);
  ASSERT_EQ(format.channels.size(), 2U);
  EXPECT_EQ(format.channels[0].info.name, "Accel X");
  EXPECT_EQ(format.channels[0].info.axis, "x");
  EXPECT_EQ(format.channels[0].info.quantity, SensorQuantity::Acceleration);
  EXPECT_DOUBLE_EQ(format.channels[0].info.scale, 1.0);
  EXPECT_DOUBLE_EQ(format.channels[1].info.scale, 9.80665);
  EXPECT_THAT(format.skipped, ElementsAre("Score"));

  const ReadBack all = readAll(*reader);
  EXPECT_THAT(all.channels[0], ElementsAre(1.0F, 2.0F, 3.0F, 4.0F, 5.0F));
  EXPECT_THAT(all.channels[1], ElementsAre(-1.0F, -2.0F, -3.0F, -4.0F, -5.0F));
  ASSERT_EQ(all.blocks.size(), 2U);
  EXPECT_EQ(toNs(all.blocks[0].firstSample), 0) << "time counts from the first sample";
  EXPECT_EQ(toNs(all.blocks[1].firstSample), 2'000'000);
  EXPECT_FALSE(all.blocks[0].has(kBlockEnd));
  EXPECT_TRUE(all.blocks[1].has(kBlockEnd));
}

TEST_F(TextRecording, IndicatorsAndMarksAreNoChannelsByName) {
  const auto reader = open("t (s),ax,CI Value,label,Tacho\n0,1,9,0,5\n0.1,2,9,0,5\n0.2,3,9,1,0\n");
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->format().channels.size(), 1U);
  EXPECT_EQ(reader->format().channels[0].info.name, "ax");
  EXPECT_NEAR(reader->format().rate.value, 10.0, 1e-9);
}

TEST_F(TextRecording, NamesAndUnitsOnTwoLinesBelowAKeyValueHeader) {
  const auto reader = open(
      "DynoWare,Version 2.5.1.2\nPath:,C:\\x\nSampling rate [Hz]:,10000\nCycles:,1\nTime,Fx,Fy\ns,N,kN\n"
      "8,72.6,-0.2\n8.0001,78.0,-0.1\n8.0002,92.6,-0.3\n");
  ASSERT_TRUE(reader);
  const RecordingFormat& format = reader->format();
  EXPECT_EQ(format.kind, "DynoWare text");
  EXPECT_DOUBLE_EQ(format.rate.value, 10000.0);
  ASSERT_EQ(format.channels.size(), 2U);
  EXPECT_EQ(format.channels[0].info.quantity, SensorQuantity::Force);
  EXPECT_EQ(format.channels[1].info.name, "Fy");
  EXPECT_EQ(format.channels[1].info.axis, "y");
  EXPECT_DOUBLE_EQ(format.channels[1].info.scale, 1e3);
}

TEST_F(TextRecording, LabViewWithACommentColumn) {
  const auto reader = open(
      "LabVIEW Measurement\t\r\nSeparator\tTab\t\r\nX_Columns\tOne\t\r\n***End_of_Header***\t\r\n\t\r\n"
      "Channels\t2\t\t\r\nY_Unit_Label\tVolts\tg\t\r\nDelta_X\t0.000100\t0.000100\t\r\n***End_of_Header***\t\t\t\r\n"
      "X_Value\tFx\tAz\tComment\r\n0.000000\t5.7\t-6.4\r\n0.000100\t5.5\t-6.5\r\n0.000200\t5.4\t-6.2\r\n");
  ASSERT_TRUE(reader);
  const RecordingFormat& format = reader->format();
  EXPECT_EQ(format.kind, "LabVIEW measurement text");
  EXPECT_DOUBLE_EQ(format.rate.value, 10000.0);
  ASSERT_EQ(format.channels.size(), 2U);
  EXPECT_EQ(format.channels[0].unit, "Volts");
  EXPECT_EQ(format.channels[0].info.quantity, SensorQuantity::Force) << "from its name";
  EXPECT_DOUBLE_EQ(format.channels[0].info.scale, 1.0);
  EXPECT_DOUBLE_EQ(format.channels[1].info.scale, 9.80665);
}

TEST_F(TextRecording, LabViewWithoutTimesTakesItsRateFromTheHeader) {
  const auto reader = open(
      "LabVIEW Measurement\t\nX_Columns\tNo\t\n***End_of_Header***\t\nDelta_X\t0.0005\t\n***End_of_Header***\t\n"
      "X_Value\tAx\tComment\n\t1.0\n\t2.0\n\t3.0\n");
  ASSERT_TRUE(reader);
  EXPECT_NEAR(reader->format().rate.value, 2000.0, 1e-9);
  EXPECT_EQ(reader->format().channels.size(), 1U);
  EXPECT_THAT(readAll(*reader).channels[0], ElementsAre(1.0F, 2.0F, 3.0F));
}

TEST_F(TextRecording, TabTextWithThreeDigitExponentsAndNoHeaderFindsItsTimeColumn) {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    char line[80];
    std::snprintf(line, sizeof line, "%.6fe-003\t3.100538e-020\t-%d.5e+002\n", i * 0.5, i);
    text += line;
  }
  const auto reader = open(text);
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->format().rate.value, 2000.0);
  ASSERT_EQ(reader->format().channels.size(), 2U);
  const ReadBack all = readAll(*reader);
  EXPECT_FLOAT_EQ(all.channels[0][3], 3.100538e-20F);
  EXPECT_FLOAT_EQ(all.channels[1][3], -350.0F);
}

TEST_F(TextRecording, GermanNumbers) {
  const auto reader = open("Zeit [ms];Kraft [N]\n0,0;1,5\n0,5;-2,25\n1,0;3,0\n");
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->format().rate.value, 2000.0);
  EXPECT_THAT(readAll(*reader).channels[0], ElementsAre(1.5F, -2.25F, 3.0F));
}

TEST_F(TextRecording, TimeStampLinesBeforeBareNumbersNeedARate) {
  const std::string_view content =
      "2016-05-26 21:15:16.881\n2016-05-26 21:15:16.963\n65583104\n-27866880\n"
      "2016-05-26 21:15:17.017\n9\n";
  EXPECT_THAT(refusal(content), HasSubstr("--rate"));
  const auto reader = open(content, rate(8000.0));
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->format().rate.value, 8000.0);
  EXPECT_THAT(readAll(*reader).channels[0], ElementsAre(65583104.0F, -27866880.0F, 9.0F));
}

TEST_F(TextRecording, BlankSeparatedColumnsWithATrailingBlank) {
  const auto reader =
      open("2016-05-26 21:15:16.881\n-1.11 -0.04 0.17 \n-1.12 -0.03 0.18 \n-1.13 -0.02 0.19 \n", rate(1e3));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().channels.size(), 3U);
  EXPECT_THAT(readAll(*reader).channels[2], ElementsAre(0.17F, 0.18F, 0.19F));
}

TEST_F(TextRecording, MissingRowsBecomeAGapAtTheStartOfABlock) {
  const auto reader = open("t,a\n0.00,1\n0.01,2\n0.02,3\n0.06,4\n0.07,5\n0.08,6\n0.09,7\n0.10,8\n");
  ASSERT_TRUE(reader);
  EXPECT_NEAR(reader->format().rate.value, 100.0, 1e-9);
  const ReadBack all = readAll(*reader);
  ASSERT_EQ(all.blocks.size(), 3U);
  EXPECT_EQ(all.blocks[0].frames, 3);
  EXPECT_EQ(all.blocks[0].flags, 0U);
  EXPECT_EQ(all.blocks[1].frames, 4);
  EXPECT_TRUE(all.blocks[1].has(kBlockGap));
  EXPECT_EQ(all.blocks[1].lostFrames, 3U);
  EXPECT_EQ(toNs(all.blocks[1].firstSample), 60'000'000);
  EXPECT_EQ(all.blocks[2].frames, 1);
  EXPECT_FALSE(all.blocks[2].has(kBlockGap));
  EXPECT_EQ(toNs(all.blocks[2].firstSample), 100'000'000);
}

TEST_F(TextRecording, AGivenRateOverridesATimeColumnThatCannotBeUsed) {
  const std::string_view content = "t,a\n0.0,1\n0.0,2\n0.1,3\n0.1,4\n";
  EXPECT_THAT(refusal(content), HasSubstr("--rate"));
  const auto reader = open(content, rate(20.0));
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().channels.size(), 1U);
  EXPECT_EQ(reader->format().frames, 4);
}

TEST_F(TextRecording, OptionsChooseChannelsQuantityAndScale) {
  ReadOptions options;
  options.channels = {2, 0};
  options.quantity = SensorQuantity::Displacement;
  const std::string_view content = "t (s),a (V),b (V),c (um)\n0,1,2,3\n1,4,5,6\n2,7,8,9\n";
  auto reader = open(content, options);
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->format().channels.size(), 2U);
  EXPECT_DOUBLE_EQ(reader->format().channels[0].info.scale, 1e-6) << "the unit fits the wanted quantity";
  EXPECT_DOUBLE_EQ(reader->format().channels[1].info.scale, 1.0);
  EXPECT_THAT(readAll(*reader).channels[0], ElementsAre(3.0F, 6.0F, 9.0F));

  options.scale = 0.25;
  reader = open(content, options);
  ASSERT_TRUE(reader);
  EXPECT_DOUBLE_EQ(reader->format().channels[0].info.scale, 0.25);
  options.channels = {3};
  EXPECT_THAT(refusal(content, options), HasSubstr("no channel 3"));
  options.channels = {};
  options.scale = 0.0;
  EXPECT_FALSE(openRecording(folder_.file("cut.csv", content), options).ok());
  EXPECT_FALSE(openRecording(folder_.file("cut.csv", content), rate(-1.0)).ok());
}

TEST_F(TextRecording, SpindleSpeedIsAChannelOnlyWhenAskedFor) {
  const std::string_view content = "t (s),Spindle speed (rpm),a (g)\n0,6000,2\n1,6001,5\n2,6000,8\n";
  auto reader = open(content);
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->format().channels.size(), 1U);
  EXPECT_EQ(reader->format().channels[0].info.name, "a");
  ReadOptions options;
  options.quantity = SensorQuantity::SpindleSpeed;
  reader = open(content, options);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->format().channels[0].info.name, "Spindle speed");
}

// As programs of Windows write it in western Europe.
TEST_F(TextRecording, HeadersInLatin1KeepTheirUnits) {
  const auto reader = open("t (s);dx (\xB5m);ax (mm/s\xB2)\n0;1;1\n0,001;2;2\n0,002;3;3\n");
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->format().channels.size(), 2U);
  EXPECT_EQ(reader->format().channels[0].info.quantity, SensorQuantity::Displacement);
  EXPECT_DOUBLE_EQ(reader->format().channels[0].info.scale, 1e-6);
  EXPECT_EQ(reader->format().channels[1].info.quantity, SensorQuantity::Acceleration);
  EXPECT_DOUBLE_EQ(reader->format().channels[1].info.scale, 1e-3);
}

TEST_F(TextRecording, TheUnitOfATimeMayStandAtTheEndOfItsName) {
  for (const char* name : {"time_ms", "Time_ms", "t_ms", "Time ms"}) {
    const auto reader = open(std::string(name) + ",ax\n0,1\n1,2\n2,3\n");
    ASSERT_TRUE(reader) << name;
    EXPECT_DOUBLE_EQ(reader->format().rate.value, 1000.0) << name;
  }
  EXPECT_DOUBLE_EQ(open("time_s,ax\n0,1\n0.01,2\n0.02,3\n")->format().rate.value, 100.0);
}

TEST_F(TextRecording, NamesInQuotesMayHoldTheDelimiter) {
  const auto reader = open("\"Time (s)\",\"Acc, X (g)\"\n0,1\n0.001,2\n0.002,3\n");
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->format().channels.size(), 1U);
  EXPECT_EQ(reader->format().channels[0].info.name, "Acc, X");
  EXPECT_DOUBLE_EQ(reader->format().channels[0].info.scale, 9.80665);
  EXPECT_THAT(refusal("Time (s),Acc, X (g)\n0,1\n0.001,2\n0.002,3\n"),
              HasSubstr(":1: names 3 columns where the rows have 2"));
}

TEST_F(TextRecording, EveryKindOfBadInputGivesOneLineWithItsPlace) {
  const std::string good = "t,a\n0,1\n1,2\n2,3\n";
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal("hello\nworld\n"), HasSubstr("no rows of numbers"));
  EXPECT_THAT(refusal("t,a\n"), HasSubstr("no rows of numbers"));
  EXPECT_THAT(refusal(good + "3,nan\n"), HasSubstr(":5: column 'a' holds 'nan'"));
  EXPECT_THAT(refusal(good + "3,inf\n"), HasSubstr(":5: column 'a' holds 'inf'"));
  EXPECT_THAT(refusal(good + "3,1e99\n"), HasSubstr(":5: column 'a' holds '1e99'"));
  EXPECT_THAT(refusal(good + "3,1e999\n"), HasSubstr(":5: column 'a' holds '1e999'"));
  EXPECT_THAT(refusal(good + "3,1,2\n"), HasSubstr(":5: has 3 columns where 2"));
  EXPECT_THAT(refusal(good + "3\n4\n"), HasSubstr(":5: has 1 columns where 2"));
  EXPECT_THAT(refusal(good + "x,5\n"), HasSubstr(":5: column 't' holds 'x'"));
  EXPECT_THAT(refusal(good + "2,5\n"), HasSubstr(":5: the time repeats"));
  EXPECT_THAT(refusal(good + "1.5,5\n"), HasSubstr(":5: the time runs backwards"));
  EXPECT_THAT(refusal(good + "2.1,5\n"), HasSubstr(":5: the time steps are uneven"));
  EXPECT_THAT(refusal(good + "1e300,5\n"), HasSubstr(":5"));
  EXPECT_THAT(refusal(good + std::string(100'000, '1') + "\n"), HasSubstr(":5: the line is too long"));
  EXPECT_THAT(refusal(good + std::string("3,\0", 3) + "\n"), HasSubstr(":5: holds bytes that are no text"));
  EXPECT_THAT(refusal("    -1\n    58\nname\n 1 2\n"), HasSubstr("dataset 1: its header ends early"));
  EXPECT_THAT(refusal("time\n0\n1\n2\n"), HasSubstr("no column is a channel"));
}

TEST_F(TextRecording, RubbishOfAnyKindIsRefusedWithoutHarm) {
  std::uint32_t state = 12345;
  for (int round = 0; round < 200; ++round) {
    std::string content;
    const bool printable = round % 2 == 0;
    for (int i = 0; i < 600; ++i) {
      state = state * 1664525U + 1013904223U;
      constexpr std::string_view kAlphabet = "0123456789.,;\t -+eE\n\nxN";
      content += printable ? kAlphabet[(state >> 16U) % kAlphabet.size()] : static_cast<char>(state >> 24U);
    }
    const Result<std::unique_ptr<RecordingReader>> reader = openRecording(folder_.file("rubbish", content), rate(1e3));
    if (reader) {
      const ReadBack all = readAll(**reader);
      EXPECT_TRUE(all.error.empty()) << "what the first pass accepted, the second must read";
    }
  }
}

}  // namespace
}  // namespace stillcut::record
