// Tap tests as users have them, with the modes of the structure known: every file gives them, or asks for what it does
// not say.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/milling/identify/modal_measurement.h"
#include "core/session/open_recording.h"

namespace stillcut::identify {
namespace {

struct Case {
  const char* file;
  void (*give)(ModalRequest&) = [](ModalRequest&) {};
};

std::string pathOf(const std::string& file) {
  return std::string(STILLCUT_SHARED_DIR "/cases_lobes/") + file;
}

ModalRequest request() {
  ModalRequest r;
  r.import.open = [](const std::string& path, const record::ReadOptions& o) { return record::openRecording(path, o); };
  return r;
}

void expectMode(const IdentifiedMode& got, double frequency, double damping, double stiffness) {
  EXPECT_NEAR(got.mode.frequency.value, frequency, 0.002 * frequency);
  EXPECT_NEAR(got.mode.damping, damping, 0.02 * damping);
  EXPECT_NEAR(got.mode.stiffness, stiffness, 0.01 * stiffness);
}

void expectX(const ModalFit& fit) {
  ASSERT_EQ(fit.modes.size(), 3u);
  expectMode(fit.modes[0], 800.0, 0.03, 1.2e7);
  expectMode(fit.modes[1], 1700.0, 0.02, 3e7);
  expectMode(fit.modes[2], 2900.0, 0.015, 8e7);
}

void expectY(const ModalFit& fit) {
  ASSERT_EQ(fit.modes.size(), 2u);
  expectMode(fit.modes[0], 760.0, 0.035, 1e7);
  expectMode(fit.modes[1], 1650.0, 0.025, 2.5e7);
}

class TapFiles : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(pathOf(GetParam().file))) GTEST_SKIP() << "absent: " << pathOf(GetParam().file);
  }
};

TEST_P(TapFiles, GiveTheModesAlongX) {
  ModalRequest r = request();
  GetParam().give(r);
  const auto got = identifyModes({pathOf(GetParam().file)}, r);
  ASSERT_TRUE(got.ok()) << got.error().line();
  expectX(got->axes.front().fit);
}

void inAxisX(ModalRequest& r) {
  r.import.axes = {Axis::X};
}
void siUnits(ModalRequest& r) {
  r.import.forceUnit = "N";
  r.import.responseUnit = "m/s^2";
}
void sensitivities(ModalRequest& r) {
  r.import.forceSensitivity = "2.25mV/N";
  r.import.responseSensitivity = "100mV/g";
}

INSTANTIATE_TEST_SUITE_P(
    Cases, TapFiles,
    testing::Values(Case{"tap_newton_g.lvm"}, Case{"tap_lbf_g.csv"}, Case{"tap_kN.csv"}, Case{"tap_time_ms.csv"},
                    Case{"tap_volts.csv", sensitivities}, Case{"tap_velocity.csv"},
                    Case{"tap_force_accY_accX.csv", inAxisX}, Case{"tap_force_y_x.uff"}, Case{"tap_force_negative.csv"},
                    Case{"tap.mat", siUnits}, Case{"frf.mat"}, Case{"frf_units_in_dataset164_mm.uff"},
                    Case{"frf_cross_before_direct.uff"}, Case{"frf_response_minus_x.uff"}, Case{"frf_xx_and_yy.uff"},
                    Case{"frf_cutpro_mmN.frf"}, Case{"frf_kHz.csv"}, Case{"frf_rad_s.csv"},
                    Case{"frf_x_and_y_columns.csv"}, Case{"frf_mag_phase.csv"}, Case{"frf_re_im_mag_phase_coh.csv"},
                    Case{"frf_complex_i.csv"}, Case{"frf_complex_python.csv"}, Case{"frf_decimal_comma.csv"},
                    Case{"frf_pulse_78_header_lines.txt"}, Case{"frf_latin1_unit.csv"}, Case{"frf_1_per_kg.csv"}),
    [](const auto& it) {
      std::string name = it.param.file;
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
      return name;
    });

TEST(TapFilesTogether, XAndYInOneGo) {
  for (const char* file :
       {"frf_xx_and_yy.uff", "frf_x_and_y_columns.csv", "tap_force_accY_accX.csv", "tap_force_y_x.uff"}) {
    if (!std::filesystem::exists(pathOf(file))) GTEST_SKIP() << "absent: " << file;
    ModalRequest r = request();
    r.import.axes = {Axis::X, Axis::Y};
    const auto got = identifyModes({pathOf(file)}, r);
    ASSERT_TRUE(got.ok()) << got.error().line();
    ASSERT_EQ(got->axes.size(), 2u) << file;
    expectX(got->axes[0].fit);
    expectY(got->axes[1].fit);
  }
}

TEST(TapFilesTogether, WhatAFileDoesNotSayIsAskedFor) {
  for (const auto& [file, option] :
       {std::pair{"tap_volts.csv", "--force-sensitivity"}, std::pair{"tap.mat", "--force-unit"},
        std::pair{"tap_force_accY_accX.csv", "--axis"}}) {
    if (!std::filesystem::exists(pathOf(file))) GTEST_SKIP() << "absent: " << file;
    const auto got = identifyModes({pathOf(file)}, request());
    ASSERT_FALSE(got.ok());
    EXPECT_NE(got.error().line().find(option), std::string::npos) << got.error().line();
  }
}

TEST(TapFilesTogether, ThreeFilesOfOneHitEachAreAveraged) {
  const std::vector<std::string> files{pathOf("h10_hit1.csv"), pathOf("h10_hit2.csv"), pathOf("h10_hit3.csv")};
  if (!std::filesystem::exists(files[0])) GTEST_SKIP() << "absent: " << files[0];
  const auto got = identifyModes(files, request());
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(got->axes[0].hits.size(), 3u);
  EXPECT_GT(got->axes[0].fit.modes[0].coherence, 0.99);
  expectX(got->axes[0].fit);
  const auto one = identifyModes({files[0]}, request());
  ASSERT_TRUE(one.ok());
  EXPECT_LT(got->axes[0].fit.misfit, 0.8 * one->axes[0].fit.misfit) << "noise is averaged out";
}

TEST(TapFilesTogether, BothModesOfAWideFileAreKept) {
  const std::string file = pathOf("frf_100Hz_and_3000Hz.csv");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "absent: " << file;
  const auto got = identifyModes({file}, request());
  ASSERT_TRUE(got.ok()) << got.error().line();
  ASSERT_EQ(got->axes[0].fit.modes.size(), 2u);
  expectMode(got->axes[0].fit.modes[0], 100.0, 0.04, 3.6e6);
  expectMode(got->axes[0].fit.modes[1], 3000.0, 0.02, 2e7);
}

}  // namespace
}  // namespace stillcut::identify
