// Every format there is an export for: what was exported comes back within the format's resolution, with its
// calibration, and whole or in part. matio is the second opinion on MATLAB files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/formats/gap_list.h"
#include "core/formats/universal/uff58.h"
#include "core/session/convert_recording.h"
#include "core/session/file/session_markers.h"
#include "core/session/file/session_writer.h"
#include "core/session/marker_span.h"
#include "tests/support/read_all.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr int kFrames = 9001;  // more than two blocks, and no multiple of what a line holds

// Two channels in g and kN, at a rate of whole hertz.
std::string source(const TempFolder& folder) {
  std::string text = "t,Accel Y (g),Fx (kN)\n";
  for (int i = 0; i < kFrames; ++i) {
    char line[80];
    std::snprintf(line, sizeof line, "%.5f,%.7g,%.7g\n", i / 10'000.0, 40.0 * std::sin(0.07 * i), 0.3 + 0.001 * i);
    text += line;
  }
  return folder.file("source.csv", text);
}

struct Kind {
  const char* suffix;
  double resolution;  // of the largest sample; .flac: one step of its 24 bits, whose full scale is 512 m/s2 here
};

class ExportKinds : public testing::TestWithParam<Kind> {};

TEST_P(ExportKinds, ComesBackWithValuesAndCalibration) {
  const TempFolder folder;
  const std::string from = source(folder);
  const std::string to = folder / ("out" + std::string(GetParam().suffix));
  const Status converted = convertRecording(from, to);
  ASSERT_TRUE(converted.ok()) << converted.error().line();
  EXPECT_EQ(folder.files(), 2U) << "nothing else is left behind";
  const WholeRecording before = readAll(from);
  const WholeRecording after = readAll(to);
  ASSERT_EQ(after.error, "");
  EXPECT_EQ(after.format.rate.value, 10'000.0);
  ASSERT_EQ(after.format.channels.size(), 2U);
  const ChannelInfo& accel = after.format.channels[0].info;
  EXPECT_EQ(accel.name, "Accel Y");
  EXPECT_EQ(accel.axis, "y");
  EXPECT_EQ(accel.quantity, SensorQuantity::Acceleration);
  EXPECT_TRUE(after.format.channels[0].quantityKnown);
  EXPECT_EQ(after.format.channels[1].info.quantity, SensorQuantity::Force);
  for (std::size_t c = 0; c < 2; ++c) {
    ASSERT_EQ(after.values[c].size(), std::size_t{kFrames});
    const double largest = c == 0 ? 40.0 * 9.80665 : 9300.0;
    for (std::size_t i = 0; i < kFrames; ++i) {
      ASSERT_NEAR(after.values[c][i], before.values[c][i], GetParam().resolution * largest)
          << "channel " << c << " " << i;
    }
  }
}

TEST_P(ExportKinds, ASpanAloneIsThatSpan) {
  const TempFolder folder;
  const std::string to = folder / ("out" + std::string(GetParam().suffix));
  const Status converted = convertRecording(source(folder), to, {}, {Seconds(0.1), Seconds(0.7003)});
  ASSERT_TRUE(converted.ok()) << converted.error().line();
  const WholeRecording span = readAll(to);
  ASSERT_EQ(span.error, "");
  ASSERT_EQ(span.values[1].size(), 6003U);
  EXPECT_NEAR(span.values[1].front(), 300.0 + 1000.0, 9300 * GetParam().resolution + 1e-3);
  EXPECT_NEAR(span.values[1].back(), 300.0 + 7002.0, 9300 * GetParam().resolution + 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Suffixes, ExportKinds,
                         testing::Values(Kind{".wav", 6e-8}, Kind{".flac", 1.6e-7}, Kind{".csv", 1e-7},
                                         Kind{".mat", 6e-8}, Kind{".uff", 6e-8}, Kind{".unv", 1e-7}, Kind{".h5", 0.0}),
                         [](const auto& instance) { return std::string(instance.param.suffix + 1); });

constexpr std::string_view kGapped = "t,a (g)\n0,1\n0.001,2\n0.002,3\n0.005,4\n0.006,5\n";

// What is missing is missing in every format, and comes back as missing.
TEST(Export, GapsStayGapsWhateverTheFormat) {
  const TempFolder folder;
  const std::string from = folder.file("in.csv", kGapped);
  for (const char* name : {"x.csv", "x.mat", "x.uff", "x.unv", "x.flac", "x.wav", "x.h5"}) {
    for (const int capacity : {1, 2, 64}) {
      ASSERT_TRUE(convertRecording(from, folder / name).ok()) << name;
      const auto reader = openRecording(folder / name);
      ASSERT_TRUE(reader.ok()) << reader.error().line();
      SampleBlock block;
      block.allocate(1, capacity);
      std::vector<double> values;
      std::vector<std::uint64_t> lost;
      double latest = 0.0;
      bool ended = false;
      while (true) {
        const Result<bool> more = (*reader)->read(block);
        ASSERT_TRUE(more.ok()) << more.error().line();
        if (!*more) break;
        EXPECT_EQ(block.has(kBlockGap), block.lostFrames > 0) << name;
        for (const float v : block.channel(0)) {
          values.push_back((*reader)->format().channels[0].info.scale * static_cast<double>(v) / 9.80665);
        }
        lost.resize(values.size());
        lost[values.size() - static_cast<std::size_t>(block.frames)] = block.lostFrames;
        latest = sinceEpoch(block.end()).value;
        ended = block.has(kBlockEnd);
      }
      ASSERT_EQ(values.size(), 5U) << name;
      for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(values[i], static_cast<double>(i + 1), 1e-4) << name;
      EXPECT_EQ(lost, (std::vector<std::uint64_t>{0, 0, 0, 2, 0})) << name;
      EXPECT_NEAR(latest, 0.007, 1e-9) << name;
      EXPECT_TRUE(ended) << name;
    }
  }
  EXPECT_TRUE(std::filesystem::exists(gapListPath(folder / "x.wav")));
  EXPECT_FALSE(std::filesystem::exists(gapListPath(folder / "x.mat")));
  mat_t* mat = Mat_Open((folder / "x.mat").c_str(), MAT_ACC_RDONLY);
  ASSERT_NE(mat, nullptr);
  matvar_t* gaps = Mat_VarRead(mat, "gaps");
  ASSERT_NE(gaps, nullptr);
  EXPECT_EQ(static_cast<double*>(gaps->data)[0], 3.0);
  EXPECT_EQ(static_cast<double*>(gaps->data)[1], 2.0);
  Mat_VarFree(gaps);
  matvar_t* a = Mat_VarRead(mat, "a");
  ASSERT_NE(a, nullptr);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(std::isnan(static_cast<double*>(a->data)[i]), i == 3 || i == 4) << i;
  Mat_VarFree(a);
  Mat_Close(mat);
}

TEST(Export, AListOfGapsBelongsToItsFile) {
  const TempFolder folder;
  const std::string to = folder / "x.wav";
  ASSERT_TRUE(convertRecording(folder.file("in.csv", kGapped), to).ok());
  ASSERT_TRUE(convertRecording(folder.file("whole.csv", "t,a (g)\n0,1\n0.001,2\n0.002,3\n"), to).ok());
  EXPECT_FALSE(std::filesystem::exists(gapListPath(to))) << "what replaced the gapped file has no gap";
  for (const char* wrong : {"2,5", "x", "-1,1", "1,1\n1,1"}) {
    std::ofstream(gapListPath(to)) << "first_frame,frames,from_s,to_s\n" << wrong << "\n";
    EXPECT_THAT(readAll(to).error, HasSubstr("is no gap of the recording beside it")) << wrong;
  }
}

TEST(Export, WhatIsToldOfASensorComesAlongWhereTheFormatHasAPlaceForIt) {
  const TempFolder folder;
  const std::string from = folder / "cut.h5";
  auto writer = SessionWriter::create(from, {exampleSetup(), "", "0.1.0", false});
  ASSERT_TRUE(writer.ok());
  StepRecord step = exampleStep(1);
  step.input.block.flags = 0;
  step.input.block.lostFrames = 0;
  ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  ASSERT_TRUE((*writer)->close().ok());
  for (const char* name : {"x.h5", "x.wav", "x.flac"}) {
    ASSERT_TRUE(convertRecording(from, folder / name).ok()) << name;
    const WholeRecording all = readAll(folder / name);
    ASSERT_EQ(all.error, "");
    const ChannelInfo& told = all.format.channels.at(0).info;
    EXPECT_EQ(told.sensitivity, 101.7) << name;
    EXPECT_EQ(told.volts, 0.339) << name;
    EXPECT_EQ(told.coupling, "iepe") << name;
    EXPECT_EQ(told.place, exampleSetup().channels[0].place) << name;
    EXPECT_EQ(all.format.channels.at(1).info.place, "") << name;
  }
}

TEST(Export, SpansAcrossAGapKeepTheirTimes) {
  const TempFolder folder;
  const std::string from = folder.file("in.csv", kGapped);
  ASSERT_TRUE(convertRecording(from, folder / "x.wav", {}, {Seconds(0.002), Seconds(0.006)}).ok());
  const WholeRecording all = readAll(folder / "x.wav");
  ASSERT_EQ(all.values.at(0).size(), 2U) << "two more are missing between them";
  EXPECT_NEAR(all.values[0][0], 3 * 9.80665, 1e-4);
  EXPECT_NEAR(all.values[0][1], 4 * 9.80665, 1e-4);
  ASSERT_TRUE(convertRecording(from, folder / "y.wav", {}, {Seconds(0.004), std::nullopt}).ok());
  EXPECT_EQ(readAll(folder / "y.wav").values.at(0).size(), 2U) << "the gap before the span is no part of it";
}

TEST(Export, EmptySpansAreRefusedAndLeaveNothing) {
  const TempFolder folder;
  const std::string from = folder.file("in.csv", kGapped);
  for (const char* name : {"x.wav", "x.mat", "x.h5", "x.csv"}) {
    EXPECT_THAT(convertRecording(from, folder / name, {}, {Seconds(5.0), Seconds(6.0)}).error().line(),
                HasSubstr("the span holds no samples"));
    EXPECT_THAT(convertRecording(from, folder / name, {}, {Seconds(2.0), Seconds(1.0)}).error().line(),
                HasSubstr("is empty"));
  }
  EXPECT_EQ(folder.files(), 1U);
}

TEST(Export, AMarkedSpanIsFoundByItsName) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  auto writer = SessionWriter::create(path, {exampleSetup(), "", "0.1.0", false});
  ASSERT_TRUE(writer.ok());
  StepRecord step = exampleStep(1);
  const Instant start = step.input.block.firstSample;
  const double blockSeconds = step.input.block.frames / step.input.block.rate.value;
  for (int i = 0; i < 40; ++i) {
    step.input.block.sequence = static_cast<std::uint64_t>(i);
    step.input.block.firstSample = start + toDuration(Seconds(i * blockSeconds));
    step.input.block.flags = 0;
    step.input.block.lostFrames = 0;
    ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  ASSERT_TRUE((*writer)->close().ok());
  Marker marker;
  marker.begin = start + toDuration(Seconds(5 * blockSeconds));
  marker.end = start + toDuration(Seconds(9 * blockSeconds));
  marker.label = "chatter";
  marker.note = "second pass";
  ASSERT_TRUE(addMarker(path, marker).ok());
  for (const char* name : {"chatter", "second pass"}) {
    const auto span = markerSpan(path, name);
    ASSERT_TRUE(span.ok()) << span.error().line();
    EXPECT_NEAR(span->from->value, 5 * blockSeconds, 1e-9);
    EXPECT_NEAR(span->to->value, 9 * blockSeconds, 1e-9);
  }
  ASSERT_TRUE(convertRecording(path, folder / "x.wav", {}, *markerSpan(path, "chatter")).ok());
  EXPECT_EQ(readAll(folder / "x.wav").values.at(0).size(), 4U * static_cast<std::size_t>(step.input.block.frames));
  EXPECT_THAT(markerSpan(path, "entry").error().line(), HasSubstr("has no marker 'entry' (there are: chatter)"));
  EXPECT_THAT(markerSpan(folder.file("in.csv", kGapped), "x").error().line(), HasSubstr("is no session"));
}

TEST(Export, MatioReadsTheSameMatrix) {
  const TempFolder folder;
  ASSERT_TRUE(convertRecording(source(folder), folder / "x.mat").ok());
  mat_t* mat = Mat_Open((folder / "x.mat").c_str(), MAT_ACC_RDONLY);
  ASSERT_NE(mat, nullptr);
  matvar_t* force = Mat_VarRead(mat, "Fx");
  ASSERT_NE(force, nullptr);
  EXPECT_EQ(force->class_type, MAT_C_DOUBLE);
  EXPECT_EQ(force->dims[0], std::size_t{kFrames});
  EXPECT_EQ(force->dims[1], 1U);
  EXPECT_NEAR(static_cast<double*>(force->data)[1000], 1300.0, 1e-3);
  Mat_VarFree(force);
  matvar_t* unit = Mat_VarRead(mat, "Fx_unit");
  ASSERT_NE(unit, nullptr);
  EXPECT_EQ(unit->class_type, MAT_C_CHAR);
  Mat_VarFree(unit);
  Mat_Close(mat);
}

TEST(Export, UniversalFilesAreWhatTheParserReadsFromMemory) {
  const TempFolder folder;
  ASSERT_TRUE(convertRecording(source(folder), folder / "x.unv").ok());
  std::ifstream in(folder / "x.unv", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto sets = uff::parseUff58(bytes, "x.unv");
  ASSERT_TRUE(sets.ok()) << sets.error().line();
  ASSERT_EQ(sets->size(), 2U);
  EXPECT_EQ((*sets)[1].ordinate.unit, "N");
  EXPECT_EQ((*sets)[1].function, uff::Uff58Function::TimeResponse);
  EXPECT_EQ((*sets)[1].y.size(), std::size_t{kFrames});
}

TEST(Export, ASilentChannelAndALoudOneSurviveFlac) {
  const TempFolder folder;
  std::string text = "t,Fx (N),Fy (N)\n";
  for (int i = 0; i < 100; ++i) text += std::to_string(i) + "e-3,0," + std::to_string(i % 2 == 0 ? 1024 : -1024) + "\n";
  ASSERT_TRUE(convertRecording(folder.file("in.csv", text), folder / "x.flac").ok());
  const WholeRecording all = readAll(folder / "x.flac");
  ASSERT_EQ(all.error, "");
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(all.values[0][i], 0.0);
    EXPECT_NEAR(all.values[1][i], i % 2 == 0 ? 1024.0 : -1024.0, 3e-4);
  }
}

}  // namespace
}  // namespace stillcut::record
