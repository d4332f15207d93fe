// The strongest line of the rest: chatter frequency and its doubt.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/spectrum.h"

namespace stillcut::detect {

struct FoundLine {
  Hertz frequency{};
  double purity = 0.0;  // part of the power within the line's main lobe
};

class LineFinder {
 public:
  // window: samples; lines are looked for in low..high.
  void prepare(int channels, int window, Hertz rate);
  void reset() noexcept;
  void push(const double* rest) noexcept;
  // Strongest line over all channels, each normalised to its own power; nothing until the window is half full.
  FoundLine find(Hertz low, Hertz high) noexcept;
  // In the spectrum of the last find(): the strongest within `reach` of `middle`. Empty where there is no peak.
  struct Peak {
    Hertz frequency{};
    double power = 0.0;  // in find()'s units, comparable with each other
  };
  Peak near(Hertz middle, Hertz reach) const noexcept;

 private:
  Hertz refined(std::size_t peak) const noexcept;

  int channels_ = 0;
  std::size_t window_ = 0;
  std::size_t head_ = 0;
  std::size_t seen_ = 0;
  dsp::Spectrum spectrum_;
  std::vector<double> ring_;
  std::vector<double> unrolled_;
  std::vector<double> power_;
  std::vector<double> now_;  // of one channel, scratch
};

}  // namespace stillcut::detect
