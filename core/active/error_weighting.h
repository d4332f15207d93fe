// What the controller is to care about most: a filter of peaks, run over the error and over the filtered reference
// alike, so that the gradient is that of the weighted error's square (filtered error LMS: Kuo and Morgan 1996,
// section 3.3). Without it LMS quietens whatever is loudest and little of what is faint beside it: on Ford's stable cut
// the least mean square of 35 taps takes 10 dB off at 1000 Hz along y, weighted there 24 dB (his figure is 16). Thread:
// one; everything but prepare() is real-time.
#pragma once

#include <span>
#include <vector>

#include "core/base/realtime.h"
#include "core/base/units.h"

namespace stillcut::active {

struct Emphasis {
  std::vector<Hertz> lines;  // empty: no weighting
  double gain = 20.0;        // of the weighting at a line, amplitudes; 1 far from every line
  Hertz width{40.0};         // of each peak
};

// Of a band of width B no more can be foreseen over a time t than exp(-pi B t) of its amplitude (a resonance of that
// half-power width): what the loop cannot foresee it adds to. The same emphasis, no wider than where 80 % is foreseen.
Emphasis foreseen(Emphasis emphasis, Seconds ahead);

class ErrorWeighting {
 public:
  // A line at or above half the rate has no effect.
  void prepare(const Emphasis& emphasis, Hertz rate);
  void reset() noexcept;
  double process(double x) STILLCUT_RT {
    for (Peak& p : peaks_) {
      const double y = p.b0 * x + p.state1;
      p.state1 = p.b1 * x - p.a1 * y + p.state2;
      p.state2 = p.b2 * x - p.a2 * y;
      x = y;
    }
    return x;
  }

 private:
  struct Peak {
    double b0, b1, b2, a1, a2;
    double state1 = 0.0, state2 = 0.0;
  };
  std::vector<Peak> peaks_;
};

}  // namespace stillcut::active
