// One-sided calibrated spectrum of one windowed segment.
// Thread: prepare() allocates; the rest is real-time, one thread at a time.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/fft.h"
#include "core/dsp/kernels/kernels.h"
#include "core/dsp/window.h"

namespace stillcut::dsp {

class Spectrum {
 public:
  // segment samples per transform, zero-padded to at least `padded` (rounded up to a good size; 0: no padding).
  void prepare(int segment, Hertz rate, WindowKind window, int padded = 0);

  int segment() const { return static_cast<int>(window_.size()); }
  int bins() const { return fft_.bins(); }
  double binWidth() const { return binWidth_; }  // [Hz]

  // Transforms exactly segment() samples, oldest first.
  void transform(std::span<const double> samples) noexcept;
  // The same from the two parts of a ring.
  void transform(std::span<const double> older, std::span<const double> newer) noexcept;

  std::span<const std::complex<double>> values() const { return values_; }
  // |X|^2 of every bin.
  void powers(std::span<double> out) const noexcept;
  // Power spectral density [unit^2/Hz]: its sum times binWidth() is the mean square of the windowed signal divided by
  // the mean square of the window (Parseval).
  double density(int bin) const noexcept;
  // Amplitude (peak, not rms) of a line at the bin's centre.
  double amplitude(int bin) const noexcept;

 private:
  kernels::Kernels kernels_;
  RealFft fft_;
  std::vector<double> window_;
  WindowSums sums_;
  double rate_ = 0.0;
  double binWidth_ = 0.0;
  std::span<const std::complex<double>> values_;
};

}  // namespace stillcut::dsp
