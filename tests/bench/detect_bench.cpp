// What the detectors' methods cost per sample and channel at 25.6 kHz, double, one core (best_of.h), with every
// instruction set that the machine has.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/detect/caliskan/energy_chain.h"
#include "core/detect/caliskan/full_harmonic_kalman.h"
#include "core/detect/growth/new_line.h"
#include "core/detect/growth/order_pole.h"
#include "core/detect/liao/spectral.h"
#include "core/detect/van_dijk/parametric_recursions.h"
#include "core/detect/xu/coherence_ratio.h"
#include "core/dsp/frame_ring.h"
#include "core/dsp/harmonic_mask.h"
#include "core/dsp/kernels/choose.h"
#include "tests/bench/best_of.h"

namespace stillcut::detect {
namespace {

using dsp::kernels::InstructionSet;

constexpr double kRate = 25600.0;
constexpr std::size_t kFrames = 6400;

// A cut: harmonics of the spindle, chatter, something like noise.
std::vector<double> cut(Hertz spindle, double phase) {
  std::vector<double> x(kFrames);
  double noise = 0.3;
  for (std::size_t k = 0; k < kFrames; ++k) {
    const double t = static_cast<double>(k) / kRate;
    noise = 3.99 * noise * (1.0 - noise);
    x[k] = 0.1 * noise + 0.3 * std::sin(kTwoPi * 1234.0 * t);
    for (int n = 1; n <= 32; ++n) x[k] += std::cos(n * (kTwoPi * spindle.value * t + phase)) / n;
  }
  return x;
}

// Hops of an eighth of a turn, the energy ratio at the end of each.
void energyChain(benchmark::State& state, InstructionSet set) {
  const Hertz spindle(100.0);
  const std::vector<double> x = cut(spindle, 0.0);
  EnergyChain chain;
  chain.prepare({1, 32, 14, 2, Hertz(kRate), spindle * 0.5}, dsp::kernels::kernelsOf(set));
  chain.tune(spindle, 2.0 / 512.0);
  const double step = kTwoPi * spindle.value / kRate;
  constexpr std::size_t kHop = 32;
  bench::bestOf(state, {kFrames, 50.0, 1.0 / kRate}, [&] {
    double ratio = 0.0;
    for (std::size_t k = 0; k < kFrames; k += kHop) {
      chain.align(step * static_cast<double>(k), step);
      chain.process(x.data() + k, 0, kHop);
      chain.endHop();
      ratio += chain.ratio(0, -1);
    }
    benchmark::DoNotOptimize(ratio);
  });
}

void fullCovariance(benchmark::State& state, InstructionSet set) {
  const Hertz spindle(100.0);
  const std::vector<double> x = cut(spindle, 0.0);
  constexpr std::size_t kBlock = 256;
  FullHarmonicKalman kalman;
  kalman.prepare(1, 32, dsp::kernels::kernelsOf(set));
  kalman.setLambda(1e-5);
  std::vector<double> rest(kBlock);
  const double step = kTwoPi * spindle.value / kRate;
  bench::bestOf(state, {kFrames, 800.0, 1.0 / kRate}, [&] {
    for (std::size_t k = 0; k < kFrames; k += kBlock) {
      kalman.align(step * static_cast<double>(k), step);
      kalman.process(x.data() + k, 0, rest.data(), 0, kBlock);
    }
    benchmark::DoNotOptimize(rest.back());
  });
}

void parametric(benchmark::State& state, InstructionSet set) {
  const Hertz spindle(100.0);
  const std::vector<double> x = cut(spindle, 0.0);
  constexpr std::size_t kStep = 64;
  ParametricRecursions recursions;
  recursions.prepare(1, 32, {3e-5, 8e-4, 1.0}, dsp::kernels::kernelsOf(set));
  recursions.tune(32, 0.06, 1.0 - 1e-5);
  std::vector<double> rest(kStep);
  const double step = kTwoPi * spindle.value / kRate;
  bench::bestOf(state, {kFrames, 25.0, 1.0 / kRate}, [&] {
    ArCoefficients sum{};
    for (std::size_t k = 0; k < kFrames; k += kStep) {
      recursions.align(step * static_cast<double>(k), step);
      recursions.process(0, x.data() + k, rest.data(), kStep, 0.5, sum);
      recursions.advance(kStep);
    }
    benchmark::DoNotOptimize(sum);
  });
}

// Every frame into the ring; every hop one windowed transform, its power and the strongest line beside the harmonics.
void spectrum(benchmark::State& state) {
  constexpr int kWindow = 2048;
  constexpr std::size_t kHop = 256;
  const Hertz spindle(100.0);
  const std::vector<double> x = cut(spindle, 0.0);
  FrameRing ring;
  ring.prepare(1, kWindow);
  dsp::Spectrum transform;
  transform.prepare(kWindow, Hertz(kRate), dsp::WindowKind::Hann);
  const auto kernels = dsp::kernels::bestKernels();
  HarmonicMask mask;
  mask.prepare(transform.bins(), transform.binWidth());
  std::vector<double> power(static_cast<std::size_t>(transform.bins()));
  bench::bestOf(state, {kFrames, 12.0, 1.0 / kRate}, [&] {
    LineOutside line;
    for (std::size_t k = 0; k < kFrames; k += kHop) {
      ring.push(x.data() + k, 0, kHop);
      transform.transform(ring.newest(0));
      transform.powers(power);
      mask.update(spindle, Hertz(), 2.25, Hertz(0.45 * kRate));
      line = strongestOutside(power, mask, transform.binWidth(), 1.0, -1, kernels);
    }
    benchmark::DoNotOptimize(line);
  });
}

// Two transforms, their averages, the ratio and its peak.
void coherenceUpdate(benchmark::State& state) {
  constexpr int kSegment = 512;
  const Hertz spindle(100.0);
  const std::vector<double> x = cut(spindle, 0.0);
  const std::vector<double> y = cut(spindle, 0.4);
  dsp::Spectrum first;
  dsp::Spectrum second;
  for (dsp::Spectrum* s : {&first, &second}) s->prepare(kSegment, Hertz(kRate), dsp::WindowKind::Hann);
  HarmonicMask mask;
  mask.prepare(first.bins(), first.binWidth());
  CoherenceRatio ratio;
  ratio.prepare(first.bins(), first.binWidth(), {});
  constexpr std::size_t kHop = 128;
  constexpr std::size_t kTransforms = (kFrames - kSegment) / kHop;
  constexpr auto kUpdates = static_cast<double>(kTransforms);
  bench::bestOf(state, {kUpdates, 2000.0, kHop / kRate}, [&] {
    double sum = 0.0;
    for (std::size_t k = 0; k + kSegment < kFrames; k += kHop) {
      first.transform(std::span(x).subspan(k, kSegment));
      second.transform(std::span(y).subspan(k, kSegment));
      mask.update(spindle, Hertz(), 1.0, Hertz(0.45 * kRate));
      ratio.update(first.values(), second.values());
      sum += ratio.peak(mask).gammaMax;
    }
    benchmark::DoNotOptimize(sum);
  });
}

// Of one order of four teeth, twice a turn while that order grows; nothing is asked of it.
void polesFit(benchmark::State& state) {
  const Hertz spindle(100.0);
  const std::vector<double> x = cut(spindle, 0.0);
  NewLine vibration;
  vibration.prepare(1, static_cast<int>(NewLine::kTurnsBack * kRate / spindle.value), Hertz(kRate));
  vibration.push(x.data(), 0, kFrames);
  const double halfTurn = 0.5 * kRate / spindle.value;
  bench::bestOf(state, {1.0, 0.0, halfTurn / kRate}, [&] {
    OrderPole pole;
    benchmark::DoNotOptimize(pole.fit(vibration, 0, {4, 48}, 7, spindle));
    benchmark::DoNotOptimize(pole);
  });
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const InstructionSet set : dsp::kernels::availableSets()) {
    const std::string name(dsp::kernels::nameOf(set));
    benchmark::RegisterBenchmark(("energy-ratio chain N=32 M=14, " + name).c_str(), energyChain, set);
    benchmark::RegisterBenchmark(("full covariance N=32, " + name).c_str(), fullCovariance, set);
    benchmark::RegisterBenchmark(("NLMS 32 + Kalman AR(4), " + name).c_str(), parametric, set);
  }
  benchmark::RegisterBenchmark("spectrum 2048 hop 256", spectrum);
  benchmark::RegisterBenchmark("coherence 512, an update", coherenceUpdate);
  benchmark::RegisterBenchmark("energy-ratio, an order's pole", polesFit);
  return true;
}();

}  // namespace
}  // namespace stillcut::detect

BENCHMARK_MAIN();
