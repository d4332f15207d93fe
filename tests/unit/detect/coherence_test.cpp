// The coherence ratio against Xu 2003 written out plainly.
#include "core/detect/xu/coherence.h"

#include <random>

#include "core/dsp/kernels/choose.h"
#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

using Transform = std::vector<std::complex<double>>;

Transform noise(std::mt19937& engine, std::size_t bins) {
  std::normal_distribution<double> normal;
  Transform x(bins);
  for (auto& v : x) v = {normal(engine), normal(engine)};
  return x;
}

HarmonicMask openMask(int bins) {
  HarmonicMask mask;
  mask.prepare(bins, 1.0);
  mask.update(Hertz(4.0), Hertz(), 0.0, Hertz(bins));  // half width 0: everything above half the spindle is free
  return mask;
}

// One inner bin of a coherence that is the same everywhere.
double sharpen(double gamma, SharpenForm form) {
  const std::vector<double> coherence(20, gamma);
  const std::vector<double> weight(20, 1.0);
  std::vector<double> out(20, 0.0);
  dsp::kernels::SharpenRun run = sharpening(form);
  run.coherence = coherence.data();
  run.weight = weight.data();
  run.bins = 20;
  run.out = out.data();
  dsp::kernels::bestKernels().sharpen(run);
  for (std::size_t b = 2; b + 2 < 20; ++b) EXPECT_EQ(out[b], out[2]) << b;
  return out[2];
}

TEST(CoherenceRatio, SharpeningAndWindowAreThePapers) {
  EXPECT_NEAR(sharpen(0.5 + 1e-12, SharpenForm::Printed), 0.2865, 1e-4);
  EXPECT_NEAR(sharpen(0.5 - 1e-12, SharpenForm::Printed), 0.4346, 1e-4);
  EXPECT_NEAR(sharpen(0.9, SharpenForm::Printed), std::exp(-0.1 / 0.4), 1e-15);
  double before = 0.0;
  for (double g = 0.0; g <= 1.0; g += 0.001) {
    const double now = sharpen(g, SharpenForm::Monotone);
    EXPECT_GT(now, before);
    EXPECT_LT(now - before, g > 0.0 ? 0.003 : 1.0);  // no step
    before = now;
  }
  // Eq. 3-18 at its corners and in the middle of its flanks.
  const CoherenceBand band{Hertz(170.0), Hertz(250.0)};
  EXPECT_DOUBLE_EQ(band.weight(Hertz(100.0)), 0.1);
  EXPECT_DOUBLE_EQ(band.weight(Hertz(170.0)), 0.1);
  EXPECT_NEAR(band.weight(Hertz(178.5)), 0.55, 1e-12);
  EXPECT_DOUBLE_EQ(band.weight(Hertz(200.0)), 1.0);
  EXPECT_NEAR(band.weight(Hertz(233.0)), 1.0, 1e-12);
  EXPECT_NEAR(band.weight(Hertz(250.0)), 0.1, 1e-12);
}

TEST(CoherenceRatio, PaperFormIsTheSquaredCosineOfThePhaseDifference) {
  std::mt19937 engine(11);
  constexpr std::size_t kBins = 257;
  CoherenceRatio ratio;
  CoherenceRatio::Settings settings;
  settings.form = CoherenceForm::Paper;
  settings.sharpening = SharpenForm::Printed;
  settings.band = {Hertz(60.0), Hertz(180.0)};
  ratio.prepare(kBins, 1.0, settings);
  const HarmonicMask mask = openMask(kBins);
  for (int segment = 0; segment < 3; ++segment) {
    const Transform x = noise(engine, kBins);
    const Transform y = noise(engine, kBins);
    ratio.update(x, y);
    const CoherencePeak peak = ratio.peak(mask);
    std::vector<double> gamma(kBins);
    double largest = 0.0;
    for (std::size_t b = 0; b < kBins; ++b) {
      gamma[b] = std::pow(std::cos(std::arg(x[b]) - std::arg(y[b])), 2);
      EXPECT_NEAR(ratio.raw()[b], gamma[b], 1e-12);
    }
    for (std::size_t b = 2; b + 2 < kBins; ++b) {
      const double smooth = (gamma[b - 2] + gamma[b - 1] + gamma[b] + gamma[b + 1] + gamma[b + 2]) / 5.0;
      const double sharp = smooth > 0.5 ? std::exp(-(1 - smooth) / 0.4) : std::exp(-(1 - smooth) / 0.6);
      const auto f = static_cast<double>(b);
      const double trapezoid = f <= 60    ? 0.1
                               : f < 66   ? 0.1 + 0.9 * (f - 60) / 6
                               : f <= 174 ? 1.0
                               : f < 180  ? 0.1 + 0.9 * (180 - f) / 6
                                          : 0.1;
      if (mask.free(b)) {
        EXPECT_NEAR(ratio.ratio()[b], sharp * trapezoid, 1e-9) << b;
        largest = std::max(largest, sharp * trapezoid);
      }
    }
    EXPECT_NEAR(peak.gammaMax, largest, 1e-9);
  }
}

TEST(CoherenceRatio, WelchFormIsTheAveragedCoherence) {
  std::mt19937 engine(13);
  constexpr std::size_t kBins = 129;
  constexpr int kSegments = 8;
  CoherenceRatio ratio;
  CoherenceRatio::Settings settings;
  settings.averages = kSegments;
  ratio.prepare(kBins, 1.0, settings);
  std::vector<Transform> xs;
  std::vector<Transform> ys;
  for (int k = 0; k < kSegments; ++k) {
    xs.push_back(noise(engine, kBins));
    ys.push_back(noise(engine, kBins));
    ys.back()[40] = 2.0 * xs.back()[40] * std::polar(1.0, 0.7);  // coherent at one bin, at any phase
    ratio.update(xs.back(), ys.back());
    if (k == 0) {
      for (const double g : ratio.raw()) EXPECT_NEAR(g, 1.0, 1e-12);  // one segment: 1 everywhere
    }
  }
  double mean = 0.0;
  for (std::size_t b = 0; b < kBins; ++b) {
    std::complex<double> cross = 0.0;
    double gx = 0.0;
    double gy = 0.0;
    for (std::size_t k = 0; k < kSegments; ++k) {
      cross += std::conj(xs[k][b]) * ys[k][b];
      gx += std::norm(xs[k][b]);
      gy += std::norm(ys[k][b]);
    }
    EXPECT_NEAR(ratio.raw()[b], std::norm(cross) / (gx * gy), 1e-12);
    if (b != 40) mean += ratio.raw()[b] / (kBins - 1);
  }
  EXPECT_NEAR(ratio.raw()[40], 1.0, 1e-12);
  EXPECT_NEAR(mean, 1.0 / kSegments, 0.03);  // independent noise: 1/K on average
}

// Two channels that hear the same chatter and each its own noise.
Recording twoChannels(const CutSignal& s) {
  Recording r = makeCut(s);
  r.channels.push_back(r.channels[0]);
  std::mt19937 engine(99);
  std::normal_distribution<float> normal(0.0F, 0.07F);
  for (auto& channel : r.channels) {
    for (float& v : channel) v += normal(engine);
  }
  return r;
}

TEST(Coherence, WarnsOrAlarmsAfterGrowthBeganAndNamesTheLine) {
  CutSignal s;
  s.growthStart = 1.5;
  s.seconds = 2.2;
  s.noise = 0.01;
  RunOptions options;
  options.teeth = 4;
  options.rpm = 6060.0;
  const RunResult r = run(twoChannels(s), options, "coherence");
  EXPECT_GT(r.firstAlarm, s.growthStart);
  EXPECT_LT(r.firstAlarm, s.growthStart + 0.2);
  double firstWarning = -1.0;
  for (const Verdict& v : r.verdicts) {
    if (v.earlyWarning && firstWarning < 0.0) firstWarning = sinceEpoch(v.time).value;
    EXPECT_FALSE(v.earlyWarning && v.alarming());
  }
  if (firstWarning >= 0.0) {
    EXPECT_GT(firstWarning, s.growthStart);
    EXPECT_LT(firstWarning, r.firstAlarm);
    EXPECT_GT(r.at(r.firstAlarm).indicators[3], 0.0);  // lead time
  }
  EXPECT_NEAR(r.verdicts.back().frequency.value, s.chatterHertz, 0.005 * s.chatterHertz);
  EXPECT_GT(r.verdicts.back().indicators[0], 0.8);
}

TEST(Coherence, EnergyIsTheResultantMeanMagnitude) {
  CutSignal s;
  s.seconds = 1.0;
  const Recording recording = twoChannels(s);
  RunOptions options;
  options.teeth = 4;
  options.rpm = 6000.0;
  double x = 0.0;
  double y = 0.0;
  long frames = 0;
  options.onBlock = [&](const ConditionedBlock& block, const Verdict&) {
    if (sinceEpoch(block.end()).value < 0.5) return;
    for (const double v : block.channel(0)) x += std::abs(v);
    for (const double v : block.channel(1)) y += std::abs(v);
    frames += block.frames;
  };
  const RunResult r = run(recording, options, "coherence");
  const double expected = std::hypot(x / static_cast<double>(frames), y / static_cast<double>(frames));
  EXPECT_NEAR(r.verdicts.back().indicators[1], expected, 0.1 * expected);  // 15 ms against half a second
}

TEST(Coherence, OneChannelIsInvalidWithItsReason) {
  CutSignal s;
  s.seconds = 0.5;
  RunOptions options;
  options.teeth = 4;
  options.rpm = 6000.0;
  const RunResult r = run(makeCut(s), options, "coherence");
  for (const Verdict& v : r.verdicts) {
    EXPECT_FALSE(v.valid);
    EXPECT_EQ(v.reason.code, ReasonCode::NeedsTwoChannels);
  }
}

}  // namespace
}  // namespace stillcut::detect::testing
