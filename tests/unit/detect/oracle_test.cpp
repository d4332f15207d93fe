// The parametric, spectral and coherence methods against their equations written out plainly, on simulated and real
// signals (oracle/sources.h). The energy-ratio chain: energy_chain_test.cpp.
#include <Eigen/Dense>
#include <complex>

#include "core/detect/liao/spectral.h"
#include "core/detect/van_dijk/parametric_recursions.h"
#include "core/detect/xu/coherence_ratio.h"
#include "core/dsp/kernels/choose.h"
#include "tests/unit/detect/oracle/sources.h"

namespace stillcut::detect::testing {
namespace {

constexpr int kHarmonics = 32;
constexpr double kMu = 0.05;
constexpr double kLambda = 0.99999;
constexpr double kRv = 3e-5;
constexpr double kRw = 8e-4;

// van Dijk 2010 eq. 19 on cos l phi, sin l phi of the integrated angle, then eq. 25 a to e with matrices.
class PlainParametric {
 public:
  double process(double x, double angle, int active, double scale) {
    Eigen::VectorXd phi = Eigen::VectorXd::Zero(2 * kHarmonics);
    for (int l = 1; l <= kHarmonics; ++l) {
      if (l > active) {
        periodic_.segment<2>(2 * l - 2).setZero();
        continue;
      }
      phi(2 * l - 2) = std::cos(l * angle);
      phi(2 * l - 1) = std::sin(l * angle);
    }
    const double rest = x - phi.dot(periodic_);
    periodic_ = (kLambda * periodic_ + 2.0 * kMu / active * rest * phi).eval();
    const double e = scale * rest;
    const double s = past_.dot(sigma_ * past_) + kRw;
    const Eigen::Vector4d gain = sigma_ * past_ / s;
    theta += gain * (e - past_.dot(theta));
    sigma_ += kRv * Eigen::Matrix4d::Identity() - gain * s * gain.transpose();
    past_ = Eigen::Vector4d(e, past_(0), past_(1), past_(2));
    return rest;
  }
  Eigen::Vector4d theta = Eigen::Vector4d::Zero();

 private:
  Eigen::VectorXd periodic_ = Eigen::VectorXd::Zero(2 * kHarmonics);
  Eigen::Vector4d past_ = Eigen::Vector4d::Zero();
  Eigen::Matrix4d sigma_ = Eigen::Matrix4d::Identity();
};

// By the definition of the transform, Hann-windowed.
std::vector<std::complex<double>> plainTransform(std::span<const double> x) {
  const std::size_t n = x.size();
  std::vector<std::complex<double>> turn(n);
  for (std::size_t k = 0; k < n; ++k) {
    turn[k] = std::polar(1.0, -kTwoPi * static_cast<double>(k) / static_cast<double>(n));
  }
  std::vector<std::complex<double>> bins(n / 2 + 1);
  for (std::size_t b = 0; b < bins.size(); ++b) {
    for (std::size_t k = 0; k < n; ++k) bins[b] += x[k] * (0.5 - 0.5 * turn[k].real()) * turn[b * k % n];
  }
  return bins;
}

class Oracle : public OnSources {};

TEST_P(Oracle, ParametricRecursionsAgreeWithEquations19And25) {
  STILLCUT_NEEDS_SOURCE(GetParam());
  const Recording recording = recordingOf(GetParam());
  double largest = 0.0;
  for (const float v : recording.channels[0]) largest = std::max(largest, std::abs(static_cast<double>(v)));
  const double scale = 3.0 / largest;
  ParametricRecursions recursions;
  recursions.prepare(1, kHarmonics, {kRv, kRw, 1.0}, dsp::kernels::bestKernels());
  PlainParametric plain;
  ArCoefficients sum{};
  int frames = 0;
  forEachBlock(GetParam(), recording, [&](const ConditionedBlock& block) {
    if (HasFatalFailure()) return;
    const int active = std::clamp(static_cast<int>(0.4 * recording.rate / block.spindle.value), 1, kHarmonics);
    recursions.tune(active, kMu, kLambda);
    for (int f = 0; f < block.frames; ++f) {
      const double x = block.samples[f];
      double rest = 0.0;
      recursions.align(block.angle[f], block.angleStep[f]);
      recursions.process(0, &x, &rest, 1, scale, sum);
      recursions.advance(1);
      ASSERT_NEAR(rest, plain.process(x, block.angle[f], active, scale), 1e-8 * largest) << "frame " << frames;
      for (std::size_t n = 0; n < kArOrder; ++n) {
        ASSERT_NEAR(recursions.theta(0)[n], plain.theta(static_cast<int>(n)), 1e-5) << "frame " << frames;
      }
      ++frames;
    }
  });
  EXPECT_GT(frames, 8000);
}

// Calls `look(start)` for stretches of `size` frames, twenty times, with both channels heard so far.
template <class Look>
void looks(const Source& source, std::size_t size, const Look& look) {
  std::array<std::vector<double>, 2> heard;
  int count = 0;
  const Recording recording = recordingOf(source);
  forEachBlock(source, recording, [&](const ConditionedBlock& block) {
    for (std::size_t c = 0; c < 2; ++c) {
      const auto in = block.channel(static_cast<int>(c));
      heard[c].insert(heard[c].end(), in.begin(), in.end());
    }
    if (heard[0].size() < size + static_cast<std::size_t>(count) * 3 * size / 2 || count >= 20) return;
    ++count;
    const std::size_t from = heard[0].size() - size;
    look(std::span<const double>(heard[0]).subspan(from), std::span<const double>(heard[1]).subspan(from),
         block.spindle);
  });
  EXPECT_GE(count, 6);
}

TEST_P(Oracle, SpectralLineIsThatOfThePlainTransform) {
  STILLCUT_NEEDS_SOURCE(GetParam());
  constexpr std::size_t kWindow = 1024;
  constexpr double kMaskBins = 2.25;
  const double rate = recordingOf(GetParam()).rate;
  dsp::Spectrum spectrum;
  spectrum.prepare(kWindow, Hertz(rate), dsp::WindowKind::Hann);
  HarmonicMask mask;
  mask.prepare(spectrum.bins(), spectrum.binWidth());
  std::vector<double> power(static_cast<std::size_t>(spectrum.bins()));
  looks(GetParam(), kWindow, [&](std::span<const double> x, std::span<const double>, Hertz spindle) {
    spectrum.transform(x);
    spectrum.powers(power);
    mask.update(spindle, Hertz(), kMaskBins, Hertz(0.45 * rate));
    const double perRoot = 2.0 / (0.5 * kWindow);  // of a line, by the window's sum
    const LineOutside found =
        strongestOutside(power, mask, spectrum.binWidth(), perRoot, 0, dsp::kernels::bestKernels());
    const auto plain = plainTransform(x);
    const double spacing = spindle.value / spectrum.binWidth();
    double most = 0.0;
    double loudest = 0.0;
    for (std::size_t b = 1; b + 1 < plain.size(); ++b) {
      const auto place = static_cast<double>(b);
      loudest = std::max(loudest, std::abs(plain[b]));
      const bool beside =
          std::abs(place - std::round(place / spacing) * spacing) >= std::min(kMaskBins, 0.45 * spacing);
      const bool inReach = place >= 0.5 * spacing && place * spectrum.binWidth() <= 0.45 * rate;
      const bool top = std::abs(plain[b]) >= std::abs(plain[b - 1]) && std::abs(plain[b]) >= std::abs(plain[b + 1]);
      if (beside && inReach && top) most = std::max(most, std::abs(plain[b]));
    }
    EXPECT_NEAR(found.amplitude, perRoot * most, 1e-9 * perRoot * loudest);
  });
}

TEST_P(Oracle, CoherenceIsEquation31AveragedOverSegments) {
  STILLCUT_NEEDS_SOURCE(GetParam());
  constexpr std::size_t kSegment = 512;
  constexpr std::size_t kBins = kSegment / 2 + 1;
  const double rate = recordingOf(GetParam()).rate;
  std::array<dsp::Spectrum, 2> spectra;
  for (dsp::Spectrum& s : spectra) s.prepare(kSegment, Hertz(rate), dsp::WindowKind::Hann);
  CoherenceRatio::Settings settings;
  CoherenceRatio ratio;
  ratio.prepare(kBins, spectra[0].binWidth(), settings);
  std::vector<double> gx(kBins, 0.0);
  std::vector<double> gy(kBins, 0.0);
  std::vector<std::complex<double>> gxy(kBins);
  int segments = 0;
  looks(GetParam(), kSegment, [&](std::span<const double> x, std::span<const double> y, Hertz) {
    spectra[0].transform(x);
    spectra[1].transform(y);
    ratio.update(spectra[0].values(), spectra[1].values());
    const auto px = plainTransform(x);
    const auto py = plainTransform(y);
    segments = std::min(segments + 1, settings.averages);
    double loudX = 0.0;
    double loudY = 0.0;
    for (std::size_t b = 0; b < kBins; ++b) {
      gx[b] += (std::norm(px[b]) - gx[b]) / segments;
      gy[b] += (std::norm(py[b]) - gy[b]) / segments;
      gxy[b] += (std::conj(px[b]) * py[b] - gxy[b]) / static_cast<double>(segments);
      loudX = std::max(loudX, gx[b]);
      loudY = std::max(loudY, gy[b]);
    }
    for (std::size_t b = 0; b < kBins; ++b) {
      if (gx[b] < 1e-18 * loudX || gy[b] < 1e-18 * loudY || !(gx[b] * gy[b] > 0.0)) continue;  // roundings alone
      EXPECT_NEAR(ratio.raw()[b], std::norm(gxy[b]) / (gx[b] * gy[b]), 1e-5) << b;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Sources, Oracle, ::testing::ValuesIn(sources()));

}  // namespace
}  // namespace stillcut::detect::testing
