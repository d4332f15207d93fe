// HDF5 files of other programs: by path, by folder, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/storage/hdf5_file.h"
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

class Hdf5Maker {
 public:
  explicit Hdf5Maker(const std::string& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}

  Hdf5Id folder(const char* path) {
    return Hdf5Id(H5Gcreate2(file_.get(), path, plan().get(), H5P_DEFAULT, H5P_DEFAULT));
  }
  Hdf5Id set(const char* path, std::vector<hsize_t> shape, const std::vector<float>& values,
             std::vector<hsize_t> chunk = {}) {
    const Hdf5Id space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
    const Hdf5Id storage(H5Pcreate(H5P_DATASET_CREATE));
    if (!chunk.empty()) {
      H5Pset_chunk(storage.get(), static_cast<int>(chunk.size()), chunk.data());
      H5Pset_deflate(storage.get(), 1);
    }
    Hdf5Id made(H5Dcreate2(file_.get(), path, H5T_NATIVE_FLOAT, space.get(), plan().get(), storage.get(), H5P_DEFAULT));
    if (!values.empty()) {
      EXPECT_GE(H5Dwrite(made.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    }
    return made;
  }

 private:
  static Hdf5Id plan() {
    Hdf5Id links(H5Pcreate(H5P_LINK_CREATE));
    H5Pset_create_intermediate_group(links.get(), 1);
    return links;
  }
  Hdf5Id file_;
};

std::vector<float> ramp(std::size_t n) {
  std::vector<float> values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<float>(i);
  return values;
}

// As a logger leaves it that was killed while others could read: copied while it is still open.
TEST(Hdf5Import, AFileThatItsWriterLeftOpenIsReadOrSaysWhatToDo) {
  const TempFolder folder;
  for (const bool shared : {true, false}) {
    const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    const std::string path = folder / "open.h5";
    const Hdf5Id file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
    const hsize_t length = 2000;
    {
      const Hdf5Id space(H5Screate_simple(1, &length, nullptr));
      const Hdf5Id set(
          H5Dcreate2(file.get(), "x", H5T_NATIVE_FLOAT, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      ASSERT_GE(H5Dwrite(set.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, ramp(2000).data()), 0);
      writeNumber(set.get(), "fs", 8000.0);
    }
    if (shared) {
      ASSERT_GE(H5Fstart_swmr_write(file.get()), 0);
    }
    H5Fflush(file.get(), H5F_SCOPE_GLOBAL);
    const std::string left = folder / "left.h5";
    std::filesystem::copy_file(path, left, std::filesystem::copy_options::overwrite_existing);
    const WholeRecording all = readAll(left);
    if (shared) {
      ASSERT_EQ(all.error, "");
      EXPECT_EQ(all.values[0].size(), 2000U);
      ASSERT_EQ(all.format.notes.size(), 1U);
      EXPECT_THAT(text(all.format.notes[0]), HasSubstr("was not closed by its writer"));
    } else {
      EXPECT_THAT(all.error, HasSubstr("was not closed by its writer (close it there, or run h5clear -s"));
    }
  }
}

TEST(Hdf5Import, ADataSetByPathWithUnitAndRateFromAttributes) {
  const TempFolder folder;
  const std::string path = folder / "daq.h5";
  {
    Hdf5Maker file(path);
    const Hdf5Id side = file.set("run1/daq/vib", {2000, 2}, ramp(4000), {512, 2});
    writeText(side.get(), "units", "g");
    const Hdf5Id above(file.folder("run2"));
    writeNumber(above.get(), "sample_rate", 51'200.0);
    file.set("run2/mic", {3000}, ramp(3000));
    const Hdf5Id wide = file.set("run2/forces", {3, 3000}, ramp(9000));
    writeText(wide.get(), "unit", "N");
  }
  ReadOptions options;
  options.rate = Hertz(1000.0);
  const WholeRecording side = readAll(path + ":/run1/daq/vib", options);
  ASSERT_EQ(side.error, "");
  ASSERT_EQ(side.values.size(), 2U);
  EXPECT_FLOAT_EQ(static_cast<float>(side.values[1][1999]), 3999.0F * 9.80665F);
  const WholeRecording run = readAll(path + ":/run2");
  ASSERT_EQ(run.error, "");
  EXPECT_EQ(run.format.rate.value, 51'200.0);
  ASSERT_EQ(run.format.channels.size(), 4U);
  EXPECT_EQ(run.format.channels[0].info.quantity, SensorQuantity::Force);
  EXPECT_EQ(run.format.channels[3].info.quantity, SensorQuantity::Sound);
  EXPECT_EQ(run.values[2][0], 6000.0);
  EXPECT_THAT(readAll(path).error, HasSubstr("holds 3 data sets in several places"));
  EXPECT_THAT(readAll(path + ":/run3").error, HasSubstr("there is no such data set"));
  EXPECT_THAT(readAll(path + ":/run1/daq/vib").error, HasSubstr("the sampling rate is not known"));
}

TEST(Hdf5Import, TimesThatAreTooSlowInSecondsAreAskedFor) {
  const TempFolder folder;
  const std::string path = folder / "ms.h5";
  {
    Hdf5Maker file(path);
    std::vector<float> times = ramp(2000);
    for (float& t : times) t *= 0.1F;
    file.set("time", {2000}, times);
    file.set("x", {2000}, ramp(2000));
  }
  EXPECT_THAT(readAll(path).error, HasSubstr("--time-unit ms (10000 Hz)"));
  ReadOptions told;
  told.secondsPerTime = 1e-3;
  EXPECT_EQ(readAll(path, told).error, "");
  EXPECT_EQ(readAll(path, told).format.rate.value, 10'000.0);
}

TEST(Hdf5Import, LyingSizesAreRefused) {
  const TempFolder folder;
  const std::string path = folder / "lie.h5";
  {
    Hdf5Maker file(path);
    file.set("huge", {hsize_t{1} << 40U}, {}, {1024});
  }
  EXPECT_THAT(readAll(path).error, HasSubstr("promises more samples than the file holds"));
  const std::string big = folder / "chunk.h5";
  {
    Hdf5Maker file(big);
    file.set("huge", {hsize_t{1} << 25U}, {}, {hsize_t{1} << 25U});
  }
  EXPECT_THAT(readAll(big).error, HasSubstr("pieces of more than 64 MB"));
}

TEST(Hdf5Import, ASampleThatIsNoNumberIsAGapAndAnInfiniteOneIsNamed) {
  const TempFolder folder;
  const std::string path = folder / "nan.h5";
  const auto make = [&path](float first, float second) {
    Hdf5Maker file(path);
    for (const auto& [name, value] : {std::pair("x", first), std::pair("y", second)}) {
      std::vector<float> values = ramp(100);
      values[42] = value;
      const Hdf5Id set = file.set(name, {100}, values);
      writeNumber(set.get(), "fs", 100.0);
    }
  };
  ReadOptions options;
  options.rate = Hertz(100.0);
  make(NAN, NAN);
  const WholeRecording gapped = readAll(path, options);
  EXPECT_EQ(gapped.error, "");
  EXPECT_EQ(gapped.values.at(0).size(), 99U);
  make(NAN, 1.0F);
  EXPECT_EQ(readAll(path, options).error, "");
  EXPECT_EQ(readAll(path, options).values.at(1).size(), 99U);
  make(INFINITY, INFINITY);
  EXPECT_THAT(readAll(path, options).error, HasSubstr("sample 42 of 'x' is not a finite number"));
}

}  // namespace
}  // namespace stillcut::record
