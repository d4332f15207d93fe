// The strongest line of the rest: chatter frequency and its doubt.
//
// The transform is hardly padded (9/8 of the window); values between its bins, four to a bin, are interpolated where
// they are wanted, by a sinc of 16 taps under a Hann window. The signal lies within one period of the transform and is
// windowed to nothing at its begin and padded at its end, so that the sinc's taper cuts into silence: the
// interpolated power is that of a transform padded to four times the length within 1e-3 of the line's.
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
  Hertz spread{};       // of the lines that may be the one (setSideLines()), by their power; 0: there is only one
};

class LineFinder {
 public:
  // window: samples; lines are looked for in low..high.
  void prepare(int channels, int window, Hertz rate);
  void reset();
  // rest[channel * stride + frame].
  void push(const double* rest, std::ptrdiff_t stride, std::size_t frames);
  // Strongest line over all channels, each normalised to its own power; nothing until the window is half full.
  FoundLine find(Hertz low, Hertz high);
  // Of a force, or of what is made of the cutting torque: nothing amplifies the mode's own frequency there, and teeth
  // that come and go make side lines of it, a tooth passing apart, that may be as strong. Of these find() gives the one
  // that is strongest in the force itself, and how far they leave it open. integrals: the signals hold the integral of
  // it (speed, current), which turns the order of the lines round. toothPassing 0: the mode itself is heard.
  void setSideLines(Hertz toothPassing, bool integrals) {
    tooth_ = toothPassing;
    integrals_ = integrals;
  }
  // In the spectrum of the last find(): the strongest within `reach` of `middle`. Empty where there is no peak.
  struct Peak {
    Hertz frequency{};
    double power = 0.0;  // in find()'s units, comparable with each other
  };
  Peak near(Hertz middle, Hertz reach) const;
  // Of the line that was followed, and the strongest one now: the former, where it still is a peak within `reach` and
  // the latter is another one and not much stronger.
  Hertz keep(Hertz followed, Hertz strongest, Hertz reach) const;
  // How many lines stand out whole tooth passings away from this one, or from its mirror image, and exactly there. The
  // tooth passing has to be known to a hundredth of a spindle order at the highest of them.
  int sideLines(Hertz line, Hertz toothPassing) const;

 private:
  struct SpectrumChannel {
    std::vector<double> ring;
    dsp::Spectrum spectrum;
    double share = 0.0;  // 1 / power of the newest window; 0: silent
  };
  double binWidth() const { return channels_.front().spectrum.binWidth(); }
  FoundLine look(Hertz low, Hertz high);
  void transform(std::size_t first, std::size_t last);
  double power(std::size_t place) const;
  std::size_t highest(std::size_t from, std::size_t to) const;
  Hertz refined(std::size_t place) const;
  void choose(FoundLine& found) const;
  template <class Use>
  void eachSideLine(Hertz line, Hertz tooth, const Use& use) const;
  bool standsOut(const Peak& peak) const;

  dsp::kernels::Kernels kernels_;
  std::size_t window_ = 0;
  std::size_t head_ = 0;
  std::size_t seen_ = 0;
  bool asked_ = false;    // since the last push(), with
  Hertz low_{}, high_{};  // ... these, and answered
  FoundLine found_;       // ... with this
  Hertz tooth_{};
  bool integrals_ = false;
  std::size_t lobe_ = 0;  // half width of what counts as the line, in places
  std::vector<SpectrumChannel> channels_;
  std::vector<double> power_;  // of every bin, all channels
  std::vector<double> now_;    // of one channel, scratch
};

}  // namespace stillcut::detect
