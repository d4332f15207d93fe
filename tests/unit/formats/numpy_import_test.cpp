// What NumPy saves, as recordings; and files of formats that are known and not read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"
#include "tests/support/zip_archive.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

template <class T>
std::string raw(const std::vector<T>& values, bool swapped = false) {
  std::string bytes;
  for (const T value : values) {
    std::string one(sizeof(T), '\0');
    std::memcpy(one.data(), &value, sizeof(T));
    if (swapped) std::reverse(one.begin(), one.end());
    bytes += one;
  }
  return bytes;
}

std::string npy(const std::string& type, const std::string& shape, const std::string& bytes, bool fortran = false) {
  const std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\x01\x00", 8) + word(header.size(), 2) + header + bytes;
}

// 300 frames of two channels, i and -2 i.
template <class T>
std::vector<T> interleaved() {
  std::vector<T> values;
  for (int i = 0; i < 300; ++i) {
    values.push_back(static_cast<T>(i));
    values.push_back(static_cast<T>(-2 * i));
  }
  return values;
}

void expectTwoRamps(const WholeRecording& all) {
  ASSERT_EQ(all.error, "");
  ASSERT_EQ(all.values.size(), 2U);
  ASSERT_EQ(all.values[0].size(), 300U);
  for (std::size_t i = 0; i < 300; ++i) {
    ASSERT_EQ(all.values[0][i], static_cast<double>(i));
    ASSERT_EQ(all.values[1][i], -2.0 * static_cast<double>(i));
  }
}

ReadOptions atOneKilohertz() {
  ReadOptions options;
  options.rate = Hertz(1000.0);
  return options;
}

TEST(NumpyArrays, EveryRealTypeOrderAndByteOrderIsRead) {
  const TempFolder folder;
  const auto read = [&](const std::string& content) {
    return readAll(folder.file("cut.npy", content), atOneKilohertz());
  };
  expectTwoRamps(read(npy("<f8", "(300, 2)", raw(interleaved<double>()))));
  expectTwoRamps(read(npy("<f4", "(300, 2)", raw(interleaved<float>()))));
  expectTwoRamps(read(npy(">f8", "(300, 2)", raw(interleaved<double>(), true))));
  expectTwoRamps(read(npy("<i2", "(300, 2)", raw(interleaved<std::int16_t>()))));
  expectTwoRamps(read(npy(">i4", "(300, 2)", raw(interleaved<std::int32_t>(), true))));
  std::vector<double> apart(600);
  for (std::size_t i = 0; i < 300; ++i) {
    apart[i] = static_cast<double>(i);
    apart[300 + i] = -2.0 * static_cast<double>(i);
  }
  expectTwoRamps(read(npy("<f8", "(300, 2)", raw(apart), true)));
  expectTwoRamps(read(npy("<f8", "(2, 300)", raw(apart))));
  EXPECT_EQ(read(npy("<f8", "(600,)", raw(apart))).values.size(), 1U);
}

TEST(NumpyArrays, AnArchiveHoldsChannelsByNameWithTheirRate) {
  const TempFolder folder;
  std::vector<double> x(500);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(0.1 * static_cast<double>(i));
  for (const bool deflated : {false, true}) {
    const std::string path =
        folder.file("cut.npz", zip({{"accel_x.npy", npy("<f8", "(500,)", raw(x))},
                                    {"fs.npy", npy("<i8", "()", raw(std::vector<std::int64_t>{25'600}))},
                                    {"about.npy", npy("<U3", "()", std::string(12, 'a'))},
                                    {"accel_y.npy", npy("<f8", "(500,)", raw(x))}},
                                   deflated));
    const WholeRecording all = readAll(path);
    ASSERT_EQ(all.error, "");
    EXPECT_EQ(all.format.rate.value, 25'600.0);
    ASSERT_EQ(all.format.channels.size(), 2U);
    EXPECT_EQ(all.format.channels[0].info.name, "accel_x");
    EXPECT_EQ(all.format.channels[0].info.axis, "x");
    EXPECT_THAT(all.format.skipped, testing::ElementsAre("about"));
    EXPECT_NEAR(all.values[1][123], x[123], 1e-6);
    EXPECT_EQ(readAll(path + ":/accel_y").format.channels.size(), 1U);
  }
}

TEST(NumpyArrays, TimesThatAreTooSlowInSecondsAreAskedFor) {
  const TempFolder folder;
  std::vector<double> times(500), columns;
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = 0.1 * static_cast<double>(i);
    columns.push_back(times[i]);
    columns.push_back(std::sin(static_cast<double>(i * i)));
  }
  const std::string named = folder.file(
      "cut.npz",
      zip({{"time.npy", npy("<f8", "(500,)", raw(times))}, {"x.npy", npy("<f8", "(500,)", raw(times))}}, false));
  const std::string first = folder.file("cut.npy", npy("<f8", "(500, 2)", raw(columns)));
  ReadOptions told;
  told.secondsPerTime = 1e-3;
  for (const std::string& path : {named, first}) {
    EXPECT_THAT(readAll(path).error, HasSubstr("its steps of 0.1 would be 10 Hz in seconds"));
    EXPECT_THAT(readAll(path).error, HasSubstr("--time-unit ms (10000 Hz)"));
    EXPECT_EQ(readAll(path, told).error, "");
    EXPECT_EQ(readAll(path, told).format.rate.value, 10'000.0);
    EXPECT_TRUE(readAll(path, told).format.notes.empty());
  }
}

TEST(NumpyArrays, WhatIsNoRecordingIsRefusedInOneLine) {
  const TempFolder folder;
  const auto errorOf = [&](const std::string& content) {
    return readAll(folder.file("x.npy", content), atOneKilohertz()).error;
  };
  const std::string bytes = raw(interleaved<double>());
  EXPECT_THAT(errorOf(npy("<c16", "(300,)", bytes)), HasSubstr("holds no array of real numbers"));
  EXPECT_THAT(errorOf(npy("|O", "(300,)", bytes)), HasSubstr("holds no array of real numbers"));
  EXPECT_THAT(errorOf(npy("<f8", "(10, 10, 6)", bytes)), HasSubstr("holds no array of real numbers"));
  EXPECT_THAT(errorOf(npy("<f8", "(301, 2)", bytes)), HasSubstr("promises more numbers than the file holds"));
  EXPECT_THAT(errorOf(npy("<f8", "(1099511627776, 1099511627776)", bytes)), testing::Not(testing::IsEmpty()));
  EXPECT_THAT(readAll(folder.file("x.npy", npy("<f8", "(600,)", raw(interleaved<double>())))).error,
              HasSubstr("--rate"));
  const std::string whole = zip({{"x.npy", npy("<f8", "(600,)", bytes)}}, true);
  for (std::size_t keep = 4; keep < whole.size(); keep += 37)
    EXPECT_NE(readAll(folder.file("cut.npz", whole.substr(0, keep)), atOneKilohertz()).error, "") << keep;
}

TEST(RefusedKinds, AreNamedWithTheWayOut) {
  const TempFolder folder;
  const auto errorOf = [&](const std::string& content) { return readAll(folder.file("recording", content)).error; };
  EXPECT_THAT(errorOf("PAR1" + std::string(200, '\1')),
              HasSubstr("the format Parquet, which is not read (write it as CSV"));
  EXPECT_THAT(errorOf("TDSh" + std::string(200, '\0')),
              HasSubstr("LabVIEW TDMS index, which is not read (open the .tdms"));
  EXPECT_THAT(errorOf(zip({{"cut.wav", "RIFF"}}, false)), HasSubstr("ZIP, which is not read (unpack it"));
  EXPECT_THAT(errorOf(std::string("\x1F\x8B\x08\x00", 4) + std::string(60, '\2')), HasSubstr("gzip"));
}

}  // namespace
}  // namespace stillcut::record
