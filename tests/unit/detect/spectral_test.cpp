// The spectral detector's line against a plain discrete Fourier transform.
#include "core/detect/liao/spectral.h"

#include <complex>

#include "core/dsp/kernels/choose.h"
#include "core/sensing/conditioner.h"
#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

TEST(HarmonicMask, FreesOnlyWhatLiesBetweenTheHarmonics) {
  HarmonicMask mask;
  mask.prepare(501, 1.0);
  mask.update(Hertz(50.0), Hertz(0.5), 4.0, Hertz(450.0));
  for (std::size_t b = 0; b < 501; ++b) {
    const double order = std::round(static_cast<double>(b) / 50.0);
    const double distance = std::abs(static_cast<double>(b) - 50.0 * order);
    const bool inReach = b >= 25 && b <= 450;
    // The doubt widens the mask with the order.
    EXPECT_EQ(mask.free(b), inReach && distance >= 4.0 + 0.5 * order) << b;
  }
}

TEST(StrongestOutside, IsNeitherAHarmonicNorItsFlank) {
  HarmonicMask mask;
  mask.prepare(501, 1.0);
  mask.update(Hertz(50.0), Hertz(), 2.0, Hertz(450.0));
  std::vector<double> power(501, 1e-6);
  power[100] = 100.0;  // harmonic with a flank that reaches beyond the mask
  power[101] = power[99] = 25.0;
  power[102] = power[98] = 5.0;
  power[173] = 2.0;
  power[172] = power[174] = 0.5;
  const LineOutside line = strongestOutside(power, mask, 1.0, 2.0, 0, dsp::kernels::bestKernels());
  EXPECT_EQ(line.bin, 173U);
  EXPECT_NEAR(line.frequency.value, 173.0, 1e-9);
  EXPECT_NEAR(line.amplitude, 2.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(line.part, 3.0 / 163.0, 1e-3);
  EXPECT_NEAR(line.severity, 3.0 / 153.0, 1e-3);  // to the harmonics under the mask
}

// A line whose lower neighbour lies under the mask of a harmonic is found between the bins all the same.
TEST(StrongestOutside, PlacesALineBesideTheMask) {
  for (const double shift : {-0.45, -0.2, 0.0, 0.3, 0.45}) {
    for (const double side : {1.0, -1.0}) {
      HarmonicMask mask;
      mask.prepare(501, 1.0);
      mask.update(Hertz(50.0), Hertz(), 2.25, Hertz(450.0));
      std::vector<double> power(501, 1e-9);
      const double line = 200.0 + side * 3.0 + shift;
      for (std::size_t b = 190; b < 210; ++b) {
        const double d = static_cast<double>(b) - line;
        const double sinc = std::abs(d) < 1e-9 ? 1.0 : std::sin(0.5 * kTwoPi * d) / (0.5 * kTwoPi * d);
        power[b] += std::pow(std::abs(d * d - 1.0) < 1e-9 ? 0.5 : sinc / (1.0 - d * d), 2.0);  // of a Hann window
        const double h = static_cast<double>(b) - 200.0;
        power[b] += std::abs(h) < 2.0 ? 100.0 * std::pow(1.0 - 0.5 * std::abs(h), 4.0) : 0.0;
      }
      const LineOutside found = strongestOutside(power, mask, 1.0, 1.0, 0, dsp::kernels::bestKernels());
      EXPECT_NEAR(found.frequency.value, line, 0.05) << shift << " " << side;
    }
  }
}

// Newest window, Hann, by the definition of the transform; the largest local maximum between the harmonics.
struct PlainLine {
  double frequency = 0.0;
  double amplitude = 0.0;
};

PlainLine plainLine(const std::vector<double>& x, double rate, double spindle, double doubt, double maskBins) {
  const auto n = x.size();
  const double width = rate / static_cast<double>(n);
  const auto bins = static_cast<std::size_t>(0.45 * rate / width) + 2;
  std::vector<double> amplitude(bins, 0.0);
  for (std::size_t b = 0; b < bins; ++b) {
    std::complex<double> sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const double hann = 0.5 - 0.5 * std::cos(kTwoPi * static_cast<double>(k) / static_cast<double>(n));
      sum += x[k] * hann * std::polar(1.0, -kTwoPi * static_cast<double>((b * k) % n) / static_cast<double>(n));
    }
    amplitude[b] = 2.0 * std::abs(sum) / (0.5 * static_cast<double>(n));
  }
  PlainLine best;
  for (std::size_t b = 1; b + 1 < bins; ++b) {
    const double f = static_cast<double>(b) * width;
    const double order = std::round(f / spindle);
    const bool beside = std::abs(f - order * spindle) >= maskBins * width + order * doubt;
    const bool top = amplitude[b] >= amplitude[b - 1] && amplitude[b] >= amplitude[b + 1];
    if (f > 0.5 * spindle && beside && top && amplitude[b] > best.amplitude) best = {f, amplitude[b]};
  }
  return best;
}

// Through a speed change, at a look long after it: window and mask of the detector against the plain transform.
TEST(Spectral, AgreesWithThePlainTransform) {
  CutSignal s;
  s.rate = 8000.0;
  s.seconds = 2.0;
  s.growthStart = 1.4;
  s.chatterHertz = 933.0;
  Recording recording = makeCut(s);
  // Air first: five lines alone do not make a cut of what was there from the start.
  for (std::size_t f = 0; f < recording.frames() / 8; ++f) recording.channels[0][f] *= 0.03F;
  SpectralDetector detector;
  RunOptions options;
  options.teeth = 4;
  options.rpm = 6000.0;
  options.blockFrames = 40;
  options.machine = [](double t) {
    MachineState m;
    m.valid = m.linkUp = true;
    m.actualSpeed = Rpm(t < 0.3 ? 6030.0 : 6000.0);
    return m;
  };
  std::vector<double> heard;
  double before = -1.0;
  int compared = 0;
  options.onBlock = [&](const ConditionedBlock& block, const Verdict& v) {
    heard.insert(heard.end(), block.channel(0).begin(), block.channel(0).end());
    const auto n = static_cast<std::size_t>(detector.window());
    // Looks fall on whole hops, here on the ends of blocks: window 2240, hop 280, blocks of 40.
    const bool fresh = v.indicators[0] != before && v.indicators[0] > 0.0;
    before = v.indicators[0];
    if (!fresh || heard.size() < n || sinceEpoch(v.time).value < 1.55 || ++compared > 4) return;
    const std::vector<double> window(heard.end() - static_cast<std::ptrdiff_t>(n), heard.end());
    const PlainLine plain = plainLine(window, s.rate, block.spindle.value, block.spindleSd.value, 2.25);
    EXPECT_NEAR(v.indicators[0], plain.amplitude, 1e-6 * plain.amplitude);
    EXPECT_NEAR(v.indicators[1], plain.frequency, 0.5 * s.rate / static_cast<double>(n) + 1e-9);
  };
  const RunResult r = run(recording, options, detector);
  EXPECT_EQ(detector.window(), 2240);
  EXPECT_GE(compared, 4);
  EXPECT_GT(r.firstAlarm, s.growthStart);
  EXPECT_LT(r.firstAlarm, s.growthStart + 0.25);
  EXPECT_NEAR(r.verdicts.back().frequency.value, s.chatterHertz, 0.005 * s.chatterHertz);
}

TEST(Spectral, AFixedThresholdIsAnAmplitude) {
  CutSignal s;
  s.growthStart = 1.0;
  s.seconds = 1.6;
  RunOptions options;
  options.teeth = 4;
  options.rpm = 6000.0;
  options.params = {{"spectral.threshold", 2.0}};
  const RunResult r = run(makeCut(s), options, "spectral");
  ASSERT_GT(r.firstAlarm, s.growthStart);
  EXPECT_GT(r.at(r.firstAlarm).indicators[0], 2.0);
}

}  // namespace
}  // namespace stillcut::detect::testing
