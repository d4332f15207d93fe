// The coherence ratio of two channels as Xu 2003 makes it from spectra: coherence (eq. 3-1 or 3-5), smoothed over +-2
// bins (3-17a), sharpened (3-17b), windowed (3-18).
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/harmonic_mask.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

enum class CoherenceForm {
  Welch,  // |mean Gxy|^2 / (mean Gx mean Gy), eq. 3-1 with averages: one segment alone would give 1 everywhere
  Paper,  // Re(Gxy)^2 / (Gx Gy) of one transform, eq. 3-5: the squared cosine of the phase difference
};
enum class SharpenForm {
  Monotone,  // the branches of eq. 3-17b made to meet at 0.5
  Printed,   // eq. 3-17b: 0.435 up to 0.5, then 0.287
};

// eq. 3-17a and b of the inner bins, times weight.
dsp::kernels::SharpenRun sharpening(SharpenForm form);

// The trapezoid of eq. 3-18: 0.1 below low, 1 in the band, 0.1 above high; ramps 17 of 170 and 250 Hz in proportion.
// low = 0: no window, 1 everywhere.
struct CoherenceBand {
  Hertz low{};   // the paper's flanks: 170 .. 187
  Hertz high{};  // 233 .. 250
  double weight(Hertz f) const;
};

struct CoherencePeak {
  double gammaMax = 0.0;  // largest ratio between the harmonics
  Hertz frequency{};      // where ratio times cross spectrum is largest
  double purity = 0.0;    // of the cross spectrum at that line
};

class CoherenceRatio {
 public:
  struct Settings {
    CoherenceForm form = CoherenceForm::Welch;
    SharpenForm sharpening = SharpenForm::Monotone;
    CoherenceBand band;
    int averages = 6;  // memory of the Welch averages, in segments taken
  };
  void prepare(int bins, double binWidth, const Settings& settings);
  void reset();
  // One pair of transforms of the same stretch.
  void update(std::span<const std::complex<double>> x, std::span<const std::complex<double>> y);
  CoherencePeak peak(const HarmonicMask& mask);

  std::span<const double> raw() const { return std::span(raw_).first(bins_); }  // before smoothing
  std::span<const double> ratio() const { return ratio_; }  // smoothed, sharpened, windowed; after peak()
  int segments() const { return segments_; }

 private:
  Settings settings_;
  int segments_ = 0;
  dsp::kernels::Kernels kernels_;
  double binWidth_ = 1.0;
  std::size_t bins_ = 0;
  std::array<double, 2 * dsp::kernels::kLanes> x_{}, y_{};  // the transforms' last bins
  std::vector<double> gx_, gy_, crossRe_, crossIm_, cross_, raw_, weight_, ratio_;
};

}  // namespace stillcut::detect
