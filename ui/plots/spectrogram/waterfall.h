// Where the bins of a spectrum lie on the axis of the waterfall. On the order axis every spectrum is stretched by its
// own spindle speed against the newest, so that the teeth stay under each other when the speed moves. Any thread.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/model/snapshot.h"

namespace stillcut::ui {

struct WaterfallScale {
  Hertz low{}, high{};    // ends of the axis, of the newest spectrum
  double binWidth = 1.0;  // [Hz]
  double stretch = 1.0;   // of this spectrum's frequencies

  // Along the axis, 0 .. 1 between its ends.
  double shareOf(double bin) const { return (bin * binWidth * stretch - low.value) / (high.value - low.value); }
  int first() const { return clamped(std::floor(low.value / (binWidth * stretch))); }
  int last() const { return std::max(first() + 1, clamped(std::ceil(high.value / (binWidth * stretch)))); }

 private:
  static int clamped(double bin) { return static_cast<int>(std::clamp(bin, 0.0, kSpectrumBins - 1.0)); }
};

inline double waterfallStretch(bool orders, Hertz spindle, Hertz newest) {
  return orders && spindle.value > 0.0 && newest.value > 0.0 ? newest / spindle : 1.0;
}

}  // namespace stillcut::ui
