// Spectra of a stretch of a recording: what is asked, and what is answered. Plain values: any thread.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/units.h"

namespace stillcut {

enum class SpectraWindow : std::uint8_t { Hann, FlatTop, Rectangular };

struct SpectraRequest {
  int channel = 0;
  int length = 2048;  // samples of one spectrum
  SpectraWindow window = SpectraWindow::Hann;
  double overlap = 0.5;  // of one spectrum with the next, 0 .. 0.95
  Seconds from{}, to{};  // since the first sample
  int columns = 1000;    // at most; where more spectra are due, the strongest of a column counts
  bool operator==(const SpectraRequest&) const = default;
};

struct Spectra {
  SpectraRequest request;
  double binWidth = 0.0;        // [Hz]
  int bins = 0;                 // of each column
  int columns = 0;              // 0: nothing to see
  Seconds first{};              // middle of the first column
  Seconds step{};               // from one column to the next
  std::vector<float> level_dB;  // rms of a line re 1 SI unit, column by column; not a number: samples are missing
  std::int64_t firstSample = 0;
  std::vector<float> samples;  // of the stretch [SI units], where they are few; else empty

  const float* column(int k) const { return level_dB.data() + static_cast<std::ptrdiff_t>(k) * bins; }
  // The column whose middle is nearest.
  int columnAt(Seconds t) const {
    const double k = step.value > 0.0 ? (t.value - first.value) / step.value + 0.5 : 0.0;
    if (!(k > 0.0)) return 0;
    return k >= columns ? columns - 1 : static_cast<int>(k);
  }
};

}  // namespace stillcut
