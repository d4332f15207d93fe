// A tone of a known level, as a calibrator gives it, and everything else that may be heard in its place.
#include "core/daq/calibrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace stillcut::daq {
namespace {

constexpr Hertz kRate{25600.0};

// Tone of `rms`, noise and hum beside it, an offset; [device units].
std::vector<float> heard(double rms, double frequency, double noise = 0.0, double offset = 0.0, double seconds = 4.0) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<float> x(static_cast<std::size_t>(seconds * kRate.value));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) / kRate.value;
    x[i] = static_cast<float>(offset + noise * normal(engine) +
                              std::numbers::sqrt2 * rms * std::sin(2.0 * std::numbers::pi * frequency * t + 0.3));
  }
  return x;
}

std::string lineOf(const std::vector<float>& x, const CalibratorTone& tone = {}) {
  const auto found = calibrate(x, kRate, tone);
  return found ? "" : found.error().line();
}

TEST(Calibrator, GivesTheScaleWhateverTheFrequencyIsOffBy) {
  for (const double f : {1000.0, 1000.3, 981.7, 1046.0}) {
    const auto found = calibrate(heard(0.02, f, 0.002, 0.4), kRate, {Hertz(1000.0), 1.0});
    ASSERT_TRUE(found) << found.error().line();
    EXPECT_NEAR(found->frequency.value, f, 0.02);
    EXPECT_NEAR(found->scale, 50.0, 0.1);
    EXPECT_LT(std::abs(found->scale - 50.0), 5.0 * found->scaleSd);
    EXPECT_NEAR(found->pure, 1.0 / 1.01, 0.002);
  }
}

TEST(Calibrator, ALowShakerOnAShortRecordingIsFoundAsWell) {
  const auto found = calibrate(heard(0.1, 159.15, 0.0, 0.0, 2.0), kRate, {Hertz(159.2), 10.0});
  ASSERT_TRUE(found) << found.error().line();
  EXPECT_NEAR(found->scale, 100.0, 0.05);
}

TEST(Calibrator, SamplesThatAllMissTheTopAreNoLimit) {
  const auto found = calibrate(heard(0.1, 3200.0), kRate, {Hertz(3200.0), 1.0});  // eight to a turn
  ASSERT_TRUE(found) << found.error().line();
  EXPECT_NEAR(found->scale, 10.0, 0.01);
}

TEST(Calibrator, SaysWhatIsWrong) {
  EXPECT_EQ(lineOf(heard(0.02, 1000.0, 0.0, 0.0, 1.5)), "calibrator: too short (two seconds of the tone are needed)");
  EXPECT_EQ(lineOf(std::vector<float>(80000, 0.25F)), "calibrator: there is no signal (is the sensor connected?)");
  EXPECT_NE(lineOf(heard(0.02, 250.0)).find("is a tone near 1000 Hz"), std::string::npos);
  EXPECT_NE(lineOf(heard(0.02, 1000.0, 0.02)).find("only 50"), std::string::npos);
  EXPECT_NE(lineOf(heard(0.02, 1000.0), {Hertz(12500.0), 1.0}).find("cannot be measured at 2.56e+04"),
            std::string::npos);
  EXPECT_NE(lineOf(heard(0.02, 1000.0), {Hertz(1000.0), 0.0}).find("above zero"), std::string::npos);
}

TEST(Calibrator, AToneThatIsCutOffOrMovesIsRefused) {
  std::vector<float> cut = heard(0.1, 1000.0, 1e-4);
  for (float& v : cut) v = std::clamp(v, -0.135F, 0.135F);  // of 0.1414
  EXPECT_NE(lineOf(cut).find("cut off"), std::string::npos) << lineOf(cut);
  std::vector<float> coarse = heard(0.1, 1000.0);
  for (float& v : coarse) v = std::round(v * 350.0F) / 350.0F;  // 50 steps from the middle to the top
  EXPECT_EQ(lineOf(coarse), "");
  std::vector<float> moved = heard(0.1, 1000.0);
  for (std::size_t i = moved.size() / 2; i < moved.size(); ++i) moved[i] *= 0.8F;
  EXPECT_NE(lineOf(moved).find("the level moves by 1"), std::string::npos) << lineOf(moved);
}

TEST(Calibrator, LevelsAreRead) {
  EXPECT_NEAR(*levelFrom("94 dB", SensorQuantity::Sound), 1.0024, 1e-4);
  EXPECT_NEAR(*levelFrom("1 g", SensorQuantity::Acceleration), 9.80665, 1e-9);
  EXPECT_EQ(*levelFrom("10", SensorQuantity::Acceleration), 10.0);
  EXPECT_EQ(*levelFrom("200N", SensorQuantity::Force), 200.0);
  EXPECT_EQ(levelFrom("94 dB", SensorQuantity::Acceleration).error().line(),
            "the calibrator's level: '94 dB' is none (rms in m/s\u00b2, or as \"1 g\")");
  for (const char* bad : {"", "x", "-1", "0", "nan", "1 mile"})
    EXPECT_FALSE(levelFrom(bad, SensorQuantity::Sound)) << bad;
}

TEST(Calibrator, AChannelGetsItsSensitivityWhereItHasOne) {
  Calibration found;
  found.scale = 98.0665;
  ChannelInfo bare;
  applyCalibration(found, bare);
  EXPECT_EQ(bare.scale, 98.0665);
  EXPECT_EQ(bare.sensitivity, 0.0);
  ChannelInfo sheet;  // 1 V of full scale
  sheet.sensitivity = 102.0;
  sheet.volts = 1.0;
  applyCalibration(found, sheet);
  EXPECT_NEAR(sheet.sensitivity, 100.0, 1e-9);
  EXPECT_NEAR(scaleOf(sheet.quantity, sheet.sensitivity, sheet.volts), sheet.scale, 1e-12);
}

}  // namespace
}  // namespace stillcut::daq
