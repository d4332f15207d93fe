// Sums of tones: what every made signal consists of besides its noise.
// Thread: any; no state.
#pragma once

#include <span>
#include <vector>

namespace stillcut::field {

struct Tone {
  double amplitude = 1.0;
  double hertz = 0.0;
  double phase = 0.0;  // rad at the first sample
};

// x += amplitude * cos(2 pi hertz t + phase), times `envelope` sample by sample where there is one.
void addTone(std::span<double> x, double rate, const Tone& tone, std::span<const double> envelope = {});

// 0 before `at`, 1 after `at + length`, a straight line between (s).
double ramp(double time, double at, double length);

// `f(t)` of every sample.
template <class F>
std::vector<double> sampled(std::size_t frames, double rate, F f) {
  std::vector<double> y(frames);
  for (std::size_t i = 0; i < frames; ++i) y[i] = f(static_cast<double>(i) / rate);
  return y;
}

std::vector<float> inSinglePrecision(std::span<const double> x);

// As a sound card of 16 bits stores it: in steps of 1/32767, limited to full scale.
std::vector<float> inSixteenBits(std::span<const double> x);

}  // namespace stillcut::field
