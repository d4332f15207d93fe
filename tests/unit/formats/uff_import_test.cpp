// Universal files as recordings: what one dataset parser reads from memory comes from the file, whatever its length.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/formats/universal/uff58.h"
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"
#include "tests/support/uff_dataset.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;
using uff::Uff58Form;

uff::Uff58Dataset channel(const std::string& name, int points, double rate, int seed) {
  uff::Uff58Dataset set;
  set.function = uff::Uff58Function::TimeResponse;
  set.responseName = name;
  set.abscissa = {uff::Uff58Quantity::Time, "Time", "s"};
  set.ordinate = {uff::Uff58Quantity::Acceleration, "Acceleration", "g"};
  for (int i = 0; i < points; ++i) {
    set.x.push_back(i / rate);
    set.y.emplace_back(std::sin(0.01 * i * seed) + 2.0, 0.0);
  }
  return set;
}

TEST(UffImport, ChannelsComeFromEveryFormWhateverTheLength) {
  const TempFolder folder;
  constexpr int kPoints = 30'000;  // longer than the window over the file
  const uff::Uff58Dataset one = channel("Spindle x", kPoints, 44'100.0, 1);
  const uff::Uff58Dataset two = channel("Table", kPoints, 44'100.0, 2);
  uff::Uff58Dataset frf = channel("FRF", 5, 1.0, 1);
  frf.function = uff::Uff58Function::FrequencyResponse;
  for (const Uff58Form form : {Uff58Form::Ascii, Uff58Form::LittleEndian, Uff58Form::BigEndian}) {
    const std::string path =
        folder.file("cut.uff", test::uffDataset(one, form) + test::uffDataset(frf, form) + test::uffDataset(two, form));
    const WholeRecording all = readAll(path);
    ASSERT_EQ(all.error, "");
    EXPECT_EQ(all.format.rate.value, 44'100.0) << "the step has six digits: a whole number is meant";
    ASSERT_EQ(all.format.channels.size(), 2U);
    EXPECT_EQ(all.format.channels[0].info.name, "Spindle x");
    EXPECT_EQ(all.format.channels[0].info.axis, "x");
    EXPECT_EQ(all.format.channels[0].info.quantity, SensorQuantity::Acceleration);
    EXPECT_DOUBLE_EQ(all.format.channels[1].info.scale, 9.80665);
    EXPECT_THAT(all.format.skipped, testing::ElementsAre("FRF"));
    ASSERT_EQ(all.values[1].size(), std::size_t{kPoints});
    for (std::size_t i = 0; i < kPoints; ++i) {
      ASSERT_NEAR(all.values[0][i], 9.80665 * one.y[i].real(), 1e-4) << i;  // six digits
      ASSERT_NEAR(all.values[1][i], 9.80665 * two.y[i].real(), 1e-4) << i;
    }
  }
}

TEST(UffImport, ChannelsThatDoNotFitTogetherAreRefused) {
  const TempFolder folder;
  const std::string one = test::uffDataset(channel("a", 50, 1000.0, 1), Uff58Form::Ascii);
  const auto errorOf = [&](const std::string& content) { return readAll(folder.file("x.uff", content)).error; };
  EXPECT_THAT(errorOf(one + test::uffDataset(channel("b", 51, 1000.0, 1), Uff58Form::Ascii)),
              HasSubstr("dataset 2: has 51 samples, those before 50"));
  EXPECT_THAT(errorOf(one + test::uffDataset(channel("b", 50, 2000.0, 1), Uff58Form::Ascii)),
              HasSubstr("another sampling rate"));
  uff::Uff58Dataset uneven = channel("a", 50, 1000.0, 1);
  uneven.even = false;
  EXPECT_THAT(errorOf(test::uffDataset(uneven, Uff58Form::Ascii)), HasSubstr("not evenly spaced"));
}

TEST(UffImport, TruncationIsFoundBeforeTheFirstBlock) {
  const TempFolder folder;
  const std::string whole = test::uffDataset(channel("a", 500, 1000.0, 1), Uff58Form::LittleEndian);
  for (const std::size_t keep : {whole.size() - 4, whole.size() / 2, std::size_t{700}, std::size_t{20}}) {
    const auto reader = openRecording(folder.file("cut.uff", whole.substr(0, keep)));
    EXPECT_FALSE(reader.ok()) << keep;
  }
}

}  // namespace
}  // namespace stillcut::record
