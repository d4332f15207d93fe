#include "core/milling/identify/measurement_import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "core/base/units.h"
#include "core/formats/universal/uff58.h"
#include "core/milling/identify/unit_label.h"
#include "tests/support/uff_dataset.h"

namespace stillcut::identify {
namespace {

const Frf& frfOf(const Result<Measurement>& measured) {
  return std::get<Frf>(measured->data);
}
const HammerRecord& hammerOf(const Result<Measurement>& measured) {
  return std::get<HammerRecord>(measured->data);
}

TEST(UnitLabel, KnowsTheUsualSpellings) {
  EXPECT_DOUBLE_EQ(frfUnit("mm/N")->factor, 1e-3);
  EXPECT_EQ(frfUnit("(m/s^2)/N")->quantity, FrfQuantity::Accelerance);
  EXPECT_EQ(frfUnit("1/N*(m/s\xC2\xB2)")->quantity, FrfQuantity::Accelerance);
  EXPECT_EQ(frfUnit("m/s/N")->quantity, FrfQuantity::Mobility);
  EXPECT_NEAR(frfUnit("g/lbf")->factor, 9.80665 / 4.4482216, 1e-6);
  EXPECT_DOUBLE_EQ(responseUnit("\xC2\xB5m")->factor, 1e-6);
  EXPECT_DOUBLE_EQ(frfUnit("MM/N")->factor, 1e-3) << "universal files write capitals";
  EXPECT_DOUBLE_EQ(frfUnit("( g ) / ( lb )")->factor, frfUnit("g/lbf")->factor);
  EXPECT_FALSE(frfUnit("V/Pa"));
  EXPECT_FALSE(frfUnit("m"));
}

TEST(Import, TextOfFrequencyRealImaginaryIsCompliance) {
  const auto got = parseMeasurement("1.0e+000\t2.0e-007\t-1.0e-008\n2.0e+000\t3.0e-007\t-2.0e-008\n", "f.txt", {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(frfOf(got).quantity, FrfQuantity::Compliance);
  EXPECT_EQ(frfOf(got).value[1], std::complex<double>(3e-7, -2e-8));
  EXPECT_EQ(got->remarks.size(), 1u);  // says that it assumed the unit
}

TEST(Import, CsvHeaderGivesTheUnit) {
  const auto got =
      parseMeasurement("Frequency [Hz],Re [(mm/s^2)/N],Im [(mm/s^2)/N]\n1,2000,-1000\n2,3000,0\n", "f.csv", {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(frfOf(got).quantity, FrfQuantity::Accelerance);
  EXPECT_DOUBLE_EQ(frfOf(got).value[0].real(), 2.0);
  EXPECT_TRUE(got->remarks.empty());
}

TEST(Import, OptionsOverruleTheFile) {
  ImportOptions options;
  options.quantity = FrfQuantity::Mobility;
  options.scale = 1e-3;
  const auto got = parseMeasurement("1 5 5\n2 6 6\n", "f", options);
  ASSERT_TRUE(got.ok());
  EXPECT_EQ(frfOf(got).quantity, FrfQuantity::Mobility);
  EXPECT_DOUBLE_EQ(frfOf(got).value[0].real(), 5e-3);
  options.scale = 0.0;
  EXPECT_FALSE(parseMeasurement("1 5 5\n2 6 6\n", "f", options).ok());
}

TEST(Import, FineStepsAreAHammerRecord) {
  const auto got = parseMeasurement("time,acc (g),force (N)\n0,1,10\n0.001,2,20\n0.002,3,30\n", "h.csv", {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_NEAR(hammerOf(got).rate, 1000.0, 1e-9);
  EXPECT_EQ(hammerOf(got).force[2], 30.0);
  EXPECT_NEAR(hammerOf(got).response[2], 3 * 9.80665, 1e-12);
}

TEST(Import, AFineFrfWithItsHeaderIsNoHammerRecord) {
  const auto got = parseMeasurement("f [Hz],re,im\n1,2,3\n1.001,2,3\n", "f.csv", {});
  ASSERT_TRUE(got.ok());
  EXPECT_TRUE(std::holds_alternative<Frf>(got->data));
}

TEST(Import, BadTextIsOneClearLine) {
  const auto falls = parseMeasurement("2 1 1\n1 1 1\n", "f", {});
  ASSERT_FALSE(falls.ok());
  const auto back = parseMeasurement("1 1 1\n3 1 1\n2 1 1\n", "f", {});
  ASSERT_FALSE(back.ok());
  EXPECT_EQ(back.error().line(), "f: the frequency does not rise at row 3");
  const auto gap = parseMeasurement("0 1 1\n0.001 1 1\n0.002 1 1\n0.005 1 1\n", "h", {});
  ASSERT_FALSE(gap.ok());
  EXPECT_NE(gap.error().line().find("uneven"), std::string::npos);
  EXPECT_FALSE(parseMeasurement("freq,magnitude,phase\n1,2,3\n2,3,4\n", "f", {}).ok());
  EXPECT_FALSE(importMeasurement("/nowhere/at.all", {}).ok());
  EXPECT_FALSE(importMeasurement("/", {}).ok());
}

uff::Uff58Dataset uffFrf() {
  uff::Uff58Dataset set;
  set.function = uff::Uff58Function::FrequencyResponse;
  set.complex = true;
  set.abscissa = {uff::Uff58Quantity::Frequency, "Frequency", "Hz"};
  set.ordinate = {uff::Uff58Quantity::Acceleration, "Acceleration", "g"};
  set.denominator = {uff::Uff58Quantity::ExcitationForce, "Force", "N"};
  for (int i = 0; i < 20; ++i) {
    set.x.push_back(100.0 + i);
    set.y.emplace_back(0.5, -0.25 * i);
  }
  return set;
}

TEST(Import, UniversalFileUnitsBecomeSi) {
  const auto got = parseMeasurement(test::uffDataset(uffFrf(), uff::Uff58Form::BigEndian), "f.uff", {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(frfOf(got).quantity, FrfQuantity::Accelerance);
  EXPECT_NEAR(frfOf(got).value[3].real(), 0.5 * 9.80665, 1e-5);
  uff::Uff58Dataset odd = uffFrf();
  odd.ordinate.unit = "furlong";
  const auto refused = parseMeasurement(test::uffDataset(odd, uff::Uff58Form::Ascii), "f.uff", {});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("furlong"), std::string::npos);
  ImportOptions second;
  second.dataset = 1;
  EXPECT_FALSE(parseMeasurement(test::uffDataset(uffFrf(), uff::Uff58Form::Ascii), "f.uff", second).ok());
}

TEST(Import, TwoTimeResponsesAreAHammerRecord) {
  uff::Uff58Dataset force = uffFrf();
  force.function = uff::Uff58Function::TimeResponse;
  force.complex = false;
  force.ordinate = {uff::Uff58Quantity::ExcitationForce, "Force", "N"};
  for (std::size_t i = 0; i < force.x.size(); ++i) force.x[i] = 1e-3 * static_cast<double>(i);
  uff::Uff58Dataset response = force;
  response.ordinate = {uff::Uff58Quantity::Acceleration, "Acceleration", "m/s2"};
  const std::string file =
      test::uffDataset(response, uff::Uff58Form::Ascii) + test::uffDataset(force, uff::Uff58Form::Ascii);
  const auto got = parseMeasurement(file, "h.uff", {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_NEAR(hammerOf(got).rate, 1000.0, 1e-6);
  EXPECT_FALSE(parseMeasurement(test::uffDataset(force, uff::Uff58Form::Ascii), "h.uff", {}).ok());
}

TEST(Import, MobilityAndAcceleranceBecomeCompliance) {
  Frf frf;
  frf.quantity = FrfQuantity::Accelerance;
  frf.frequency = {0.0, 10.0};
  const double w = kTwoPi * 10.0;
  frf.value = {1.0, -w * w * 2e-6};
  const Frf compliance = toCompliance(frf);
  ASSERT_EQ(compliance.frequency.size(), 1u);  // 0 Hz cannot be integrated
  EXPECT_NEAR(std::abs(compliance.value[0] - 2e-6), 0.0, 1e-18);
  frf.quantity = FrfQuantity::Mobility;
  frf.value[1] = std::complex<double>(0.0, w * 3e-6);
  EXPECT_NEAR(std::abs(toCompliance(frf).value[0] - 3e-6), 0.0, 1e-18);
}

TEST(Import, RandomBytesNeverBreakTheReader) {
  std::mt19937 random(7);
  const std::string good = "1.0e+000\t2.0e-007\t-1.0e-008\n2.0e+000\t3.0e-007\t-2.0e-008\n";
  for (int trial = 0; trial < 5000; ++trial) {
    std::string bytes = good;
    for (int k = 0; k < 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    const auto got = parseMeasurement(bytes, "t", {});
    EXPECT_EQ(got ? std::string::npos : got.error().line().find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace stillcut::identify
