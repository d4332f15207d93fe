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
    EXPECT_EQ(text(all.format.skippedWhy.at(0)), "it holds a frequency response");
    ASSERT_EQ(all.values[1].size(), std::size_t{kPoints});
    for (std::size_t i = 0; i < kPoints; ++i) {
      ASSERT_NEAR(all.values[0][i], 9.80665 * one.y[i].real(), 1e-4) << i;  // six digits
      ASSERT_NEAR(all.values[1][i], 9.80665 * two.y[i].real(), 1e-4) << i;
    }
  }
}

TEST(UffImport, WhatIsNoRecordingSaysWhatItIsAndWhereItGoes) {
  const TempFolder folder;
  uff::Uff58Dataset set = channel("x", 5, 1.0, 1);
  const auto refusal = [&](uff::Uff58Function function, uff::Uff58Quantity abscissa) {
    set.function = function;
    set.abscissa.quantity = abscissa;
    return readAll(folder.file("x.uff", test::uffDataset(set, Uff58Form::Ascii))).error;
  };
  const auto frf = refusal(uff::Uff58Function::FrequencyResponse, uff::Uff58Quantity::Frequency);
  EXPECT_THAT(frf, HasSubstr("is no recording: it holds a frequency response"));
  EXPECT_THAT(frf, HasSubstr("stillcut-cli modal"));
  for (const auto function : {uff::Uff58Function::AutoSpectrum, uff::Uff58Function::PowerSpectralDensity,
                              uff::Uff58Function::Spectrum, uff::Uff58Function::General}) {
    const auto spectrum = refusal(function, uff::Uff58Quantity::Frequency);
    EXPECT_THAT(spectrum, HasSubstr("it holds a spectrum (export the samples over time"));
  }
  EXPECT_THAT(refusal(uff::Uff58Function::TimeResponse, uff::Uff58Quantity::Frequency), HasSubstr("holds a spectrum"))
      << "over frequencies it is none of time, whatever it is called";
  EXPECT_THAT(refusal(uff::Uff58Function::General, uff::Uff58Quantity::Unknown), HasSubstr("a function of type 0"));
}

TEST(UffImport, OfSeveralRatesThatWithMostNumbersIsReadAndTheOthersAreNamed) {
  const TempFolder folder;
  for (const uff::Uff58Dataset& other : {channel("b", 40, 1000.0, 1), channel("b", 50, 2000.0, 1)}) {
    const std::string both = test::uffDataset(channel("a", 50, 1000.0, 1), Uff58Form::Ascii) +
                             test::uffDataset(other, Uff58Form::Ascii) +
                             test::uffDataset(channel("c", 50, 1000.0, 2), Uff58Form::Ascii);
    const WholeRecording all = readAll(folder.file("x.uff", both));
    ASSERT_EQ(all.error, "");
    EXPECT_EQ(all.format.rate.value, 1000.0);
    ASSERT_EQ(all.format.channels.size(), 2U);
    EXPECT_EQ(all.format.channels[1].info.name, "c");
    EXPECT_THAT(all.format.skipped, testing::ElementsAre("b"));
    ASSERT_EQ(all.format.notes.size(), 1U);
    EXPECT_THAT(text(all.format.notes[0]), HasSubstr("channel 'b' is left out"));
  }
}

TEST(UffImport, WrittenAbscissaeGiveTheRateWhereTheyAreEven) {
  const TempFolder folder;
  for (const Uff58Form form : {Uff58Form::Ascii, Uff58Form::LittleEndian}) {
    uff::Uff58Dataset set = channel("a", 4000, 10'000.0, 1);
    set.even = false;
    WholeRecording all = readAll(folder.file("x.uff", test::uffDataset(set, form)));
    ASSERT_EQ(all.error, "");
    EXPECT_EQ(all.format.rate.value, 10'000.0);
    ASSERT_EQ(all.values[0].size(), 4000U);
    EXPECT_NEAR(all.values[0][77], 9.80665 * set.y[77].real(), 1e-4);
    set.abscissa.unit = "ms";
    EXPECT_NEAR(readAll(folder.file("x.uff", test::uffDataset(set, form))).format.rate.value, 1e7, 1.0);
    for (std::size_t i = 2000; i < set.x.size(); ++i) set.x[i] += 0.01;
    all = readAll(folder.file("x.uff", test::uffDataset(set, form)));
    EXPECT_THAT(all.error, HasSubstr("not evenly spaced")) << "a gap that the format cannot tell";
  }
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
