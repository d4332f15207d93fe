// MATLAB files as recordings. The files are written by matio, for versions 5 (plain and compressed) and 7.3.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>
#include <sys/resource.h>
#include <zlib.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

class MatWriter {
 public:
  MatWriter(const std::string& path, mat_ft version, matio_compression compression)
      : mat_(Mat_CreateVer(path.c_str(), nullptr, version)), compression_(compression) {}
  ~MatWriter() { Mat_Close(mat_); }
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;

  template <class T>
  void array(const char* name, matio_classes kind, matio_types type, std::vector<T> values, std::size_t rows) {
    std::array<std::size_t, 2> dims{rows, values.size() / rows};
    write(Mat_VarCreate(name, kind, type, 2, dims.data(), values.data(), 0));
  }
  // A struct of one element with vectors and single numbers as its fields.
  void record(const char* name, std::vector<std::pair<const char*, std::vector<double>>> fields) {
    std::vector<const char*> names;
    for (const auto& field : fields) names.push_back(field.first);
    std::array<std::size_t, 2> one{1, 1};
    matvar_t* made = Mat_VarCreateStruct(name, 2, one.data(), names.data(), static_cast<unsigned>(names.size()));
    for (auto& [field, values] : fields) {
      std::array<std::size_t, 2> dims{values.size(), 1};
      Mat_VarSetStructFieldByName(made, field, 0,
                                  Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims.data(), values.data(), 0));
    }
    write(made);
  }
  void text(const char* name, std::string letters) {
    std::array<std::size_t, 2> dims{1, letters.size()};
    write(Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UINT8, 2, dims.data(), letters.data(), 0));
  }

 private:
  void write(matvar_t* variable) {
    EXPECT_EQ(Mat_VarWrite(mat_, variable, compression_), 0);
    Mat_VarFree(variable);
  }
  mat_t* mat_;
  matio_compression compression_;
};

std::vector<double> wave(std::size_t n, double step) {
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = std::sin(step * static_cast<double>(i));
  return values;
}

ReadOptions atOneKilohertz() {
  ReadOptions options;
  options.rate = Hertz(1000.0);
  return options;
}

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string inflated(const std::string& packed) {
  std::string whole(1U << 20U, '\0');
  uLongf bytes = whole.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(whole.data()), &bytes, reinterpret_cast<const Bytef*>(packed.data()),
                       packed.size()),
            Z_OK);
  whole.resize(bytes);
  return whole;
}

std::string deflated(const std::string& whole) {
  std::string packed(compressBound(whole.size()), '\0');
  uLongf bytes = packed.size();
  EXPECT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &bytes, reinterpret_cast<const Bytef*>(whole.data()),
                     whole.size()),
            Z_OK);
  packed.resize(bytes);
  return packed;
}

// The most this process has ever held.
double peakMegabytes() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

struct Kind {
  mat_ft version;
  matio_compression compression;
};

class MatKinds : public testing::TestWithParam<Kind> {};

TEST_P(MatKinds, VectorsAreChannelsWithUnitsAndRateBesideThem) {
  const TempFolder folder;
  const std::string path = folder / "cut.mat";
  constexpr std::size_t kFrames = 5000;
  {
    MatWriter mat(path, GetParam().version, GetParam().compression);
    mat.array("accel_x", MAT_C_DOUBLE, MAT_T_DOUBLE, wave(kFrames, 0.1), kFrames);
    mat.array("fz", MAT_C_INT16, MAT_T_INT16, std::vector<std::int16_t>(kFrames, -7), 1);
    mat.array("fs", MAT_C_DOUBLE, MAT_T_DOUBLE, std::vector<double>{25'600.0}, 1);
    mat.array("calibration", MAT_C_DOUBLE, MAT_T_DOUBLE, wave(12, 1.0), 3);
    mat.text("accel_x_unit", "mm/s^2");
    mat.text("fz_unit", "kN");
  }
  const WholeRecording all = readAll(path);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.rate.value, 25'600.0);
  ASSERT_EQ(all.format.channels.size(), 2U);
  EXPECT_EQ(all.format.channels[0].info.name, "accel_x");
  EXPECT_EQ(all.format.channels[1].info.quantity, SensorQuantity::Force);
  EXPECT_THAT(all.format.skipped, testing::Contains("calibration"));
  ASSERT_EQ(all.values[0].size(), kFrames);
  const std::vector<double> expected = wave(kFrames, 0.1);
  for (std::size_t i = 0; i < kFrames; ++i) {
    ASSERT_NEAR(all.values[0][i], 1e-3 * expected[i], 1e-10) << i;
    ASSERT_EQ(all.values[1][i], -7000.0) << i;
  }
}

TEST_P(MatKinds, FieldsOfAStructAreChannelsByTheirPath) {
  const TempFolder folder;
  const std::string path = folder / "cut.mat";
  constexpr std::size_t kFrames = 5000;
  {
    MatWriter mat(path, GetParam().version, GetParam().compression);
    mat.record("rec", {{"x", wave(kFrames, 0.1)}, {"y", wave(kFrames, 0.2)}, {"fs", {10'000.0}}});
  }
  const WholeRecording all = readAll(path);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.rate.value, 10'000.0);
  ASSERT_EQ(all.format.channels.size(), 2U);
  EXPECT_EQ(all.format.channels[1].info.name, "y");
  ASSERT_EQ(all.values[1].size(), kFrames);
  for (std::size_t i = 0; i < kFrames; ++i) ASSERT_NEAR(all.values[1][i], std::sin(0.2 * static_cast<double>(i)), 1e-6);
  const WholeRecording one = readAll(path + ":/rec/y");
  ASSERT_EQ(one.error, "");
  ASSERT_EQ(one.format.channels.size(), 1U);
  EXPECT_EQ(one.format.channels[0].info.name, "y");
}

TEST_P(MatKinds, AFirstColumnThatGrowsEvenlyIsTheTime) {
  const TempFolder folder;
  const std::string path = folder / "txy.mat";
  constexpr std::size_t kFrames = 4000;
  std::vector<double> values(kFrames);
  for (std::size_t i = 0; i < kFrames; ++i) values[i] = static_cast<double>(i) / 10'000.0;
  for (const double step : {0.1, 0.2}) {
    const std::vector<double> more = wave(kFrames, step);
    values.insert(values.end(), more.begin(), more.end());
  }
  {
    MatWriter mat(path, GetParam().version, GetParam().compression);
    mat.array("data", MAT_C_DOUBLE, MAT_T_DOUBLE, values, kFrames);
  }
  WholeRecording all = readAll(path);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.rate.value, 10'000.0);
  ASSERT_EQ(all.format.channels.size(), 2U);
  EXPECT_NEAR(all.values[0][50], std::sin(5.0), 1e-6);
  all = readAll(path, atOneKilohertz());
  EXPECT_EQ(all.format.rate.value, 1000.0);
  EXPECT_EQ(all.format.channels.size(), 2U) << "a time is no channel, whatever rate is told";
}

TEST_P(MatKinds, ColumnsOfAMatrixAreChannelsAndTimesGiveTheRate) {
  const TempFolder folder;
  const std::string path = folder / "cut.mat";
  std::vector<double> times(400);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = 3.0 + static_cast<double>(i) / 48'000.0;
  std::vector<float> both(800);  // column by column
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = static_cast<float>(i);
  {
    MatWriter mat(path, GetParam().version, GetParam().compression);
    mat.array("t", MAT_C_DOUBLE, MAT_T_DOUBLE, times, 400);
    mat.array("data", MAT_C_SINGLE, MAT_T_SINGLE, both, 400);
  }
  const WholeRecording all = readAll(path);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.rate.value, 48'000.0);
  ASSERT_EQ(all.values.size(), 2U);
  EXPECT_EQ(all.values[1][399], 799.0);
  EXPECT_EQ(all.values[0][1], 1.0);
  ReadOptions second;
  second.channels = {1};
  EXPECT_EQ(readAll(path, second).values.at(0).at(0), 400.0);
  EXPECT_EQ(readAll(path + ":/data").format.channels.size(), 0U) << "without the times beside it there is no rate";
  second.rate = Hertz(1000.0);
  EXPECT_EQ(readAll(path + ":/data", second).values.at(0).at(0), 400.0);
}

TEST_P(MatKinds, TruncationIsOneLine) {
  const TempFolder folder;
  const std::string path = folder / "cut.mat";
  {
    MatWriter mat(path, GetParam().version, GetParam().compression);
    mat.array("fs", MAT_C_DOUBLE, MAT_T_DOUBLE, std::vector<double>{1000.0}, 1);
    std::vector<double> noise(3000);
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = std::sin(1e6 * static_cast<double>(i * i));
    mat.array("x", MAT_C_DOUBLE, MAT_T_DOUBLE, noise, 1);
  }
  std::ifstream in(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  for (std::size_t keep = 10; keep < whole.size(); keep += 97) {
    const WholeRecording all = readAll(folder.file("half.mat", whole.substr(0, keep)));
    EXPECT_NE(all.error, "") << keep << " of " << whole.size();
    EXPECT_EQ(all.error.find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Versions, MatKinds,
                         testing::Values(Kind{MAT_FT_MAT5, MAT_COMPRESSION_NONE},
                                         Kind{MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
                                         Kind{MAT_FT_MAT73, MAT_COMPRESSION_NONE}));

TEST(MatImport, ALyingLengthIsRefusedBeforeMemoryIsTaken) {
  const TempFolder folder;
  const std::string path = folder / "cut.mat";
  {
    MatWriter mat(path, MAT_FT_MAT5, MAT_COMPRESSION_NONE);
    mat.array("x", MAT_C_DOUBLE, MAT_T_DOUBLE, wave(300, 0.1), 300);
  }
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::string dims("\x2c\x01\x00\x00", 4);  // 300
  const std::size_t at = bytes.find(dims, 128);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 4, std::string("\xff\xff\xff\x7f", 4));
  EXPECT_THAT(readAll(folder.file("lie.mat", bytes)).error, HasSubstr("'x' promises more numbers than the file holds"));
}

// The name's own length: matio would take four gigabytes for it.
TEST(MatImport, ALengthThatLiesInsideAnArrayIsRefused) {
  const TempFolder folder;
  const std::string path = folder / "cut.mat";
  {
    MatWriter mat(path, MAT_FT_MAT5, MAT_COMPRESSION_NONE);
    mat.array("a_long_name", MAT_C_DOUBLE, MAT_T_DOUBLE, wave(300, 0.1), 300);
  }
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::size_t name = bytes.find("a_long_name");
  ASSERT_NE(name, std::string::npos);
  bytes.replace(name - 4, 4, std::string("\xff\xff\xff\xea", 4));
  EXPECT_THAT(readAll(folder.file("lie.mat", bytes)).error, HasSubstr("variable 0: a length inside it is wrong"));
}

// The same lie, packed: what comes out of a variable has to be there as well.
TEST(MatImport, ALengthThatLiesInsideACompressedVariableIsRefusedInBoundedMemory) {
  const TempFolder folder;
  const std::string path = folder / "cut.mat";
  {
    MatWriter mat(path, MAT_FT_MAT5, MAT_COMPRESSION_ZLIB);
    mat.array("a_long_name", MAT_C_DOUBLE, MAT_T_DOUBLE, wave(300, 0.1), 300);
  }
  ASSERT_EQ(readAll(path + ":/a_long_name", atOneKilohertz()).error, "");
  const std::string bytes = contentOf(path);
  const std::string whole = inflated(bytes.substr(136));
  const std::size_t name = whole.find("a_long_name");
  ASSERT_NE(name, std::string::npos);
  struct Lie {
    std::size_t at;
    std::string length;
  };
  // The name's length, and with it the array's own: both would have to be believed for four gigabytes.
  const std::string huge("\xf0\xff\xff\xea", 4), array("\xff\xff\xff\xef", 4);
  for (const std::vector<Lie>& lies : {std::vector<Lie>{{name - 4, huge}}, {{name - 4, huge}, {4, array}}}) {
    const double before = peakMegabytes();
    std::string changed = whole;
    for (const Lie& lie : lies) changed.replace(lie.at, 4, lie.length);
    const std::string packed = deflated(changed);
    const auto length = static_cast<std::uint32_t>(packed.size());
    std::string lying = bytes.substr(0, 128);
    lying.append("\x0f\x00\x00\x00", 4);
    lying.append(reinterpret_cast<const char*>(&length), 4);
    lying.append(packed);
    const WholeRecording all = readAll(folder.file("lie.mat", lying), atOneKilohertz());
    EXPECT_THAT(all.error, HasSubstr("variable 0: a length inside it is wrong"));
    EXPECT_LT(peakMegabytes() - before, 64.0);
  }
}

}  // namespace
}  // namespace stillcut::record
