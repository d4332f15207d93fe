#include "core/milling/identify/modal_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/milling/identify/modal_band.h"
#include "core/milling/identify/modal_measurement.h"
#include "core/session/open_recording.h"
#include "tests/support/temp_folder.h"

namespace stillcut::identify {
namespace {

using milling::Mode;

struct Noise {
  double relative = 0.0;  // of the largest value, per line and component
  unsigned seed = 1;
};

Mode mode(double frequency, double damping, double stiffness) {
  Mode m;
  m.frequency = Hertz(frequency);
  m.damping = damping;
  m.stiffness = stiffness;
  return m;
}

// Compliance of a sum of real modes at s = decay + i w.
Frf compliance(const std::vector<Mode>& modes, double from, double to, double step, Noise noise = {},
               double decay = 0.0) {
  Frf frf;
  frf.source = "synthetic";
  frf.addedDecay = decay;
  double largest = 0.0;
  for (double f = from; f <= to; f += step) {
    const std::complex<double> s(decay, kTwoPi * f);
    std::complex<double> h = 0.0;
    for (const Mode& m : modes) {
      const double w = kTwoPi * m.frequency.value;
      h += w * w / m.stiffness / (s * s + 2.0 * m.damping * w * s + w * w);
    }
    frf.frequency.push_back(f);
    frf.value.push_back(h);
    largest = std::max(largest, std::abs(h));
  }
  std::mt19937 random(noise.seed);
  std::normal_distribution<double> gauss(0.0, 1.0);
  for (auto& v : frf.value) {
    const double re = gauss(random);
    v += noise.relative * largest * std::complex<double>(re, gauss(random));
  }
  return frf;
}

void expectModes(const Result<ModalFit>& fit, const std::vector<Mode>& truth, double frequency, double damping,
                 double stiffness) {
  ASSERT_TRUE(fit.ok()) << fit.error().line();
  ASSERT_EQ(fit->modes.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Mode& got = fit->modes[i].mode;
    EXPECT_NEAR(got.frequency.value, truth[i].frequency.value, frequency * truth[i].frequency.value) << i;
    EXPECT_NEAR(got.damping, truth[i].damping, damping * truth[i].damping) << i;
    EXPECT_NEAR(got.stiffness, truth[i].stiffness, stiffness * truth[i].stiffness) << i;
  }
}

TEST(ModalFit, ExactDataGiveExactModes) {
  const std::vector<Mode> truth = {mode(400, 0.03, 1e7), mode(900, 0.015, 4e7), mode(1500, 0.05, 6e7)};
  const auto fit = fitModes(compliance(truth, 1, 2500, 1), {});
  expectModes(fit, truth, 1e-6, 1e-5, 1e-5);
  EXPECT_LT(fit->misfit, 1e-6);
  EXPECT_LT(fit->realMisfit, 1e-6);
  for (const IdentifiedMode& m : fit->modes) EXPECT_TRUE(m.caveat.empty()) << m.caveat;
}

TEST(ModalFit, NoiseIsAveragedOutAndNoModeIsInvented) {
  const std::vector<Mode> truth = {mode(400, 0.03, 1e7), mode(900, 0.015, 4e7), mode(1500, 0.03, 6e7)};
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto fit = fitModes(compliance(truth, 1, 2500, 1, {0.005, seed}), {});
    expectModes(fit, truth, 1e-3, 0.05, 0.05);
    // The stated deviations are honest: errors stay below five of them.
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const IdentifiedMode& m = fit->modes[i];
      EXPECT_LT(std::abs(m.mode.frequency.value - truth[i].frequency.value), 5.0 * m.frequencySd);
      EXPECT_LT(std::abs(m.mode.damping - truth[i].damping), 5.0 * m.dampingSd);
      EXPECT_LT(std::abs(m.mode.stiffness - truth[i].stiffness), 5.0 * m.stiffnessSd);
      EXPECT_LT(m.frequencySd, 1e-3 * m.mode.frequency.value);
    }
  }
}

TEST(ModalFit, CloselySpacedModesAreToldApart) {
  // 2 % apart with 2 % damping: half a bandwidth, one peak to the eye.
  const std::vector<Mode> truth = {mode(800, 0.02, 2e7), mode(816, 0.02, 3e7)};
  expectModes(fitModes(compliance(truth, 300, 1400, 0.5), {}), truth, 1e-4, 1e-3, 1e-3);
  const std::vector<Mode> wider = {mode(800, 0.015, 2e7), mode(832, 0.015, 3e7)};
  expectModes(fitModes(compliance(wider, 300, 1400, 0.5, {0.003, 3}), {}), wider, 2e-3, 0.05, 0.1);
}

TEST(ModalFit, ModesOutsideTheBandGoIntoTheResiduals) {
  const std::vector<Mode> all = {mode(150, 0.02, 3e7), mode(700, 0.03, 1e7), mode(2500, 0.02, 2e7)};
  ModalOptions options;
  options.from = 450;
  options.to = 1100;
  expectModes(fitModes(compliance(all, 1, 4000, 1), options), {all[1]}, 1e-3, 0.01, 0.01);
}

TEST(ModalFit, AStiffModeBesideASoftOneIsKept) {
  const std::vector<Mode> truth = {mode(500, 0.02, 5e6), mode(1100, 0.02, 1e8)};
  expectModes(fitModes(compliance(truth, 1, 2000, 1, {0.0005, 2}), {}), truth, 1e-3, 0.05, 0.05);
}

TEST(ModalFit, NumberOfModesCanBeAskedFor) {
  const std::vector<Mode> truth = {mode(400, 0.03, 1e7), mode(900, 0.015, 4e7), mode(1500, 0.05, 6e7)};
  ModalOptions options;
  options.modes = 1;
  options.from = 200;
  options.to = 2000;
  const auto one = fitModes(compliance(truth, 1, 2500, 1), options);
  ASSERT_TRUE(one.ok());
  ASSERT_EQ(one->modes.size(), 1u);
  EXPECT_NEAR(one->modes[0].mode.frequency.value, 400.0, 10.0);  // the softest
  EXPECT_GT(one->misfit, 0.1);
  options.modes = 9;
  const auto many = fitModes(compliance(truth, 1, 2500, 1), options);
  ASSERT_TRUE(many.ok());
  EXPECT_GE(many->modes.size(), 3u);
  EXPECT_LT(many->misfit, 1e-4);
}

TEST(ModalFit, AnyQuantityGivesTheSameModes) {
  const std::vector<Mode> truth = {mode(400, 0.03, 1e7), mode(900, 0.015, 4e7)};
  Frf frf = compliance(truth, 1, 1500, 1);
  frf.quantity = FrfQuantity::Accelerance;
  for (std::size_t i = 0; i < frf.value.size(); ++i) frf.value[i] *= -std::pow(kTwoPi * frf.frequency[i], 2);
  expectModes(fitModes(frf, {}), truth, 1e-5, 1e-4, 1e-4);
}

TEST(ModalFit, DampingOfTheExponentialWindowIsTakenOff) {
  const std::vector<Mode> truth = {mode(400, 0.02, 1e7), mode(900, 0.015, 4e7)};
  // 30 1/s on 400 Hz is 0.012 of damping, more than half of the mode's own.
  expectModes(fitModes(compliance(truth, 1, 1500, 1, {}, 30.0), {}), truth, 1e-5, 1e-3, 1e-3);
}

TEST(ModalFit, AComplexShapeIsDoubted) {
  Frf frf = compliance({mode(400, 0.02, 1e7)}, 1, 1000, 1);
  for (auto& v : frf.value) v *= std::polar(1.0, -0.7);
  const auto fit = fitModes(frf, {});
  ASSERT_TRUE(fit.ok()) << fit.error().line();
  EXPECT_NE(fit->modes[0].caveat.find("degrees off real"), std::string::npos) << fit->modes[0].caveat;
  EXPECT_GT(fit->realMisfit, 0.1);
}

TEST(ModalFit, OpposedSensorsAreNamed) {
  Frf frf = compliance({mode(400, 0.02, 1e7)}, 1, 1000, 1);
  for (auto& v : frf.value) v = -v;
  const auto fit = fitModes(frf, {});
  ASSERT_FALSE(fit.ok());
  EXPECT_EQ(
      fit.error().line(),
      "synthetic: force and response point against each other (if the sensor sat on the other side, turn the response "
      "with --flip)");
}

TEST(ModalFit, NonsenseIsOneClearLine) {
  const Frf good = compliance({mode(400, 0.02, 1e7)}, 1, 1000, 1);
  EXPECT_FALSE(fitModes(Frf{}, {}).ok());
  Frf noise = compliance({mode(400, 0.02, 1e12)}, 1, 1000, 1, {5.0, 1});
  EXPECT_FALSE(fitModes(noise, {}).ok());
  Frf zero = good;
  for (auto& v : zero.value) v = 0.0;
  EXPECT_FALSE(fitModes(zero, {}).ok());
  Frf nan = good;
  nan.value[400] = NAN;
  ModalOptions band;
  band.from = 200;
  band.to = 600;
  EXPECT_FALSE(fitModes(nan, band).ok());
  ModalOptions options;
  options.from = 800;
  options.to = 300;
  EXPECT_FALSE(fitModes(good, options).ok());
  options.to = 801;
  EXPECT_FALSE(fitModes(good, options).ok());
  options = {};
  options.modes = -1;
  EXPECT_FALSE(fitModes(good, options).ok());
  options.modes = 99;
  EXPECT_FALSE(fitModes(good, options).ok());
}

TEST(ModalBand, SpansTheResonancesAndNotTheNoise) {
  Frf frf = compliance({mode(400, 0.03, 1e7), mode(900, 0.02, 4e7)}, 1, 4000, 1, {1e-4, 5});
  // Drift at low frequency and noise at high frequency, as an integrated accelerometer gives them.
  std::mt19937 random(3);
  std::normal_distribution<double> gauss(0.0, 1.0);
  for (std::size_t i = 0; i < frf.value.size(); ++i) {
    const double f = frf.frequency[i];
    frf.value[i] += 1e-3 / (f * f * f) * gauss(random);
    if (f > 2500) frf.value[i] += 2e-7 * gauss(random);
  }
  const auto band = resonantBand(frf, findResonances(frf), {});
  ASSERT_TRUE(band.ok()) << band.error().line();
  EXPECT_NEAR(band->from, 220.0, 5.0);
  EXPECT_NEAR(band->to, 1080.0, 10.0);
}

TEST(ModalBand, IsChosenByTheNegativeRealPart) {
  // In mobility the mode at 100 Hz is a tenth of the other; in the compliance that limits the cut it is the deepest.
  const std::vector<Mode> truth = {mode(100, 0.04, 3.6e6), mode(3000, 0.02, 2e7)};
  const auto fit = fitModes(compliance(truth, 10, 3600, 1, {0.001, 4}), {});
  expectModes(fit, truth, 1e-3, 0.02, 0.02);
  EXPECT_NEAR(fit->modes[0].depth, 1.0 / (4 * 3.6e6 * 0.04 * 1.04), 0.02 * fit->modes[0].depth);
}

bool said(const ModalFit& fit, const std::string& words) {
  return std::any_of(fit.remarks.begin(), fit.remarks.end(),
                     [&](const Message& m) { return text(m).find(words) != std::string::npos; });
}

TEST(ModalBand, WhatIsLeftOutIsNamedWithItsSize) {
  ModalOptions options;
  options.from = 1000;
  const auto fit = fitModes(compliance({mode(400, 0.03, 1e7), mode(1500, 0.02, 3e7)}, 10, 2500, 1), options);
  ASSERT_TRUE(fit.ok()) << fit.error().line();
  ASSERT_EQ(fit->modes.size(), 1u);
  EXPECT_TRUE(said(*fit, "a resonance at 399 Hz"));
  EXPECT_TRUE(said(*fit, "is 100 % of the deepest"));
  EXPECT_TRUE(said(*fit, "what was left out at 399 Hz is deeper than every mode found"));
  EXPECT_EQ(fit->missing, 0.0) << "somebody has chosen the band";
  EXPECT_NEAR(fit->measuredDepth, 1.0 / (4 * 1e7 * 0.03), 0.05 * fit->measuredDepth);
}

// Noise of a weak hit on an accelerometer: in the compliance it rises steeply to low frequencies.
Frf weakHit(double noise, unsigned seed) {
  Frf frf = compliance({mode(540, 0.028, 8.5e6), mode(1320, 0.022, 2.4e7)}, 1, 4000, 1);
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0.0, 1.0);
  for (std::size_t i = 0; i < frf.value.size(); ++i) {
    const double f = frf.frequency[i] / 540.0;
    const double re = gauss(random);
    frf.value[i] += noise / (f * f) * std::complex<double>(re, gauss(random));
  }
  return frf;
}

TEST(ModalBand, ANoisyPeakThatIsTheDeepestIsFittedAndNamed) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto fit = fitModes(weakHit(1.2e-7, seed), {});
    ASSERT_TRUE(fit.ok()) << seed << fit.error().line();
    ASSERT_EQ(fit->modes.size(), 2u) << seed;
    EXPECT_NEAR(fit->modes[0].mode.frequency.value, 540.0, 3.0);
    EXPECT_NEAR(fit->modes[0].depth, 1.02e-6, 0.1e-6);
    EXPECT_TRUE(said(*fit, "Hz is noisy: hit harder, or average more hits")) << seed;
  }
}

TEST(ModalBand, APeakBuriedInNoiseIsNamedAndNothingIsPromised) {
  int named = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto fit = fitModes(weakHit(4.5e-7, seed), {});
    if (!fit.ok()) continue;
    if (fit->modes.front().mode.frequency.value < 700.0) continue;
    const bool deeper = said(*fit, "deeper than every mode found");
    EXPECT_EQ(said(*fit, "left out: a noisy peak at 5"), deeper) << seed;
    EXPECT_EQ(fit->missing > 0.0, deeper) << seed;
    if (!deeper) continue;
    EXPECT_NEAR(fit->missing, 540.0, 30.0);
    ++named;
    EXPECT_GT(fit->measuredDepth, 0.8e-6) << "outside of the band, where the hammer reached";
  }
  EXPECT_GE(named, 3);
}

TEST(ModalBand, NoiseAloneIsNoNoisyPeak) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Frf frf = weakHit(1e-7, seed);
    for (const Resonance& r : findResonances(frf)) {
      const bool near = std::abs(r.frequency - 540.0) < 30.0 || std::abs(r.frequency - 1320.0) < 30.0;
      EXPECT_TRUE(near || !r.fitted()) << seed << " " << r.frequency;
    }
  }
}

TEST(ModalBand, WhatLiesBeyondTheHammersReachIsNamed) {
  Frf frf = compliance({mode(540, 0.028, 8.5e6), mode(1320, 0.022, 2.4e7)}, 1, 4000, 1, {1e-3, 1});
  frf.usableTo = 1000.0;
  const auto fit = fitModes(frf, {});
  ASSERT_TRUE(fit.ok()) << fit.error().line();
  ASSERT_EQ(fit->modes.size(), 1u);
  EXPECT_TRUE(said(*fit, "not looked at: a peak at 132"));
  EXPECT_TRUE(said(*fit, "above 1000 Hz, where the hit has no force left"));
}

TEST(ModalBand, AFreeEndIsThatOfTheResonancesOnItsSide) {
  const Frf frf = compliance({mode(400, 0.03, 1e7), mode(1500, 0.02, 3e7)}, 10, 2500, 1);
  ModalOptions above;
  above.from = 1000;
  const auto high = fitModes(frf, above);
  ASSERT_TRUE(high.ok()) << high.error().line();
  EXPECT_NEAR(high->to, 1800.0, 10.0);
  ModalOptions below;
  below.to = 800;
  const auto low = fitModes(frf, below);
  ASSERT_TRUE(low.ok()) << low.error().line();
  EXPECT_NEAR(low->from, 220.0, 5.0);
  ModalOptions flank;  // no resonance above 1600 Hz: the end of the measurement
  flank.from = 1600;
  const auto end = fitModes(frf, flank);
  EXPECT_TRUE(end.ok() ? end->to == 2500.0 : end.error().line().find("physical mode") != std::string::npos);
}

TEST(ModalFit, TheMisfitStatedIsThatOfTheModesWritten) {
  // A stiff mode above the band gives a residual that a file of modes does not hold.
  const std::vector<Mode> truth = {mode(400, 0.03, 1e7), mode(6000, 0.02, 1.5e7)};
  ModalOptions options;
  options.from = 200;
  options.to = 800;
  const Frf frf = compliance(truth, 10, 1000, 1);
  const auto fit = fitModes(frf, options);
  ASSERT_TRUE(fit.ok()) << fit.error().line();
  EXPECT_LT(fit->realMisfit, 0.001);
  double off = 0.0;
  double whole = 0.0;
  const Frf alone = compliance({fit->modes[0].mode}, 10, 1000, 1);
  for (std::size_t i = 0; i < frf.value.size(); ++i) {
    if (frf.frequency[i] < 200 || frf.frequency[i] > 800) continue;
    off += std::norm(alone.value[i] - frf.value[i]);
    whole += std::norm(frf.value[i]);
  }
  EXPECT_GT(fit->writtenMisfit, 0.05);
  EXPECT_NEAR(fit->writtenMisfit, std::sqrt(off / whole), 1e-6);
}

class TapTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(path())) GTEST_SKIP() << "reference recording absent: " << path();
  }
  std::string path() const { return std::string(STILLCUT_SHARED_DIR "/recordings/tap_test/") + GetParam(); }

  // Neither file says a unit.
  static ModalRequest units() {
    ModalRequest request;
    request.import.unit = "m/N";
    request.import.forceUnit = "N";
    request.import.responseUnit = "m/s^2";
    request.import.open = [](const std::string& file, const record::ReadOptions& o) {
      return record::openRecording(file, o);
    };
    return request;
  }

  static void expectFive(const ModalFit& fit) {
    ASSERT_EQ(fit.modes.size(), 5u);
    const auto& m = fit.modes;
    EXPECT_NEAR(m[0].mode.frequency.value, 1074.0, 0.005 * 1074.0);
    EXPECT_NEAR(m[0].mode.damping, 0.032, 0.0032);
    EXPECT_NEAR(m[0].mode.stiffness, 2.4e7, 2.4e6);
    EXPECT_NEAR(m[1].mode.frequency.value, 1260.0, 0.01 * 1260.0);
    EXPECT_NEAR(m[2].mode.frequency.value, 1980.0, 0.005 * 1980.0);
    EXPECT_NEAR(m[2].mode.damping, 0.050, 0.0050);
    EXPECT_NEAR(m[3].mode.frequency.value, 2604.0, 0.005 * 2604.0);
    EXPECT_NEAR(m[3].mode.damping, 0.0225, 0.00225);
    EXPECT_NEAR(m[4].mode.frequency.value, 2729.0, 0.005 * 2729.0);
    EXPECT_NEAR(m[4].mode.damping, 0.023, 0.0023);
    EXPECT_LT(fit.misfit, 0.08);
  }
};

TEST_P(TapTest, FiveModesInTheStatedBand) {
  ModalRequest request = units();
  request.fit.from = 600;
  request.fit.to = 3100;
  const auto got = identifyModes({path()}, request);
  ASSERT_TRUE(got.ok()) << got.error().line();
  expectFive(got->axes[0].fit);
}

TEST_P(TapTest, FiveModesWithoutABand) {
  const auto got = identifyModes({path()}, units());
  ASSERT_TRUE(got.ok()) << got.error().line();
  const AxisModes& axis = got->axes[0];
  expectFive(axis.fit);
  if (!axis.fromHammer) return;
  ASSERT_EQ(axis.hits.size(), 1u);
  EXPECT_NEAR(axis.hits[0].peakForce, 249.7, 0.1);
  EXPECT_FALSE(axis.hits[0].doubleHit);
  EXPECT_FALSE(axis.hits[0].forceOverload || axis.hits[0].responseOverload);
}

TEST_P(TapTest, TurnedAccelerometerIsNamedAndTurnedBack) {
  ModalRequest request = units();
  request.hammer.flipResponse = true;
  const auto got = identifyModes({path()}, request);
  ASSERT_FALSE(got.ok());
  EXPECT_NE(got.error().line().find("flip"), std::string::npos) << got.error().line();
}

// The label of a column may be wrong by a thousand: the numbers are given, and doubted.
TEST(ModalFit, AStiffnessThatNoToolHasIsDoubted) {
  const record::TempFolder folder;
  const Frf tip = compliance({{Hertz(900.0), 0.03, 2e7}}, 200.0, 2000.0, 1.0);
  for (const char* unit : {"m/N", "um/N"}) {
    std::string text = std::string("frequency (Hz),real (") + unit + "),imag (" + unit + ")\n";
    for (std::size_t k = 0; k < tip.frequency.size(); ++k) {
      char line[96];
      std::snprintf(line, sizeof line, "%.1f,%.9g,%.9g\n", tip.frequency[k], tip.value[k].real(), tip.value[k].imag());
      text += line;
    }
    folder.file("frf.csv", text);
    const auto got = identifyModes({folder / "frf.csv"}, {});
    ASSERT_TRUE(got.ok()) << got.error().line();
    bool doubted = false;
    for (const Message& remark : got->axes[0].remarks)
      doubted = doubted || remark.form.find("units right") != std::string::npos;
    EXPECT_EQ(doubted, std::string(unit) == "um/N");
  }
}

// A recording of a cut, taken for a tap test: no mode in it, and one line that says so.
TEST(ModalFit, WhatDoesNotResonateIsOneLine) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss(0.0, 1.0);
    Frf frf;
    for (int k = 1; k < 2000; ++k) {
      frf.frequency.push_back(2.0 * k);
      frf.value.emplace_back(1e-8 * gauss(random), -1e-8 * std::abs(gauss(random)));
    }
    ModalOptions options;
    options.from = 100.0;
    options.to = 3000.0;
    const auto got = fitModes(frf, options);
    EXPECT_EQ((got.ok() ? std::string() : got.error().line()).find('\n'), std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, TapTest,
                         testing::Values("Point_1_Channel_1_CH1.txt", "impact_time_Point1_Channel1_CH1.txt"),
                         [](const auto& it) { return std::string(it.index == 0 ? "compliance" : "hammer"); });

}  // namespace
}  // namespace stillcut::identify
