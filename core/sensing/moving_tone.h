// MovingTone: a tone that glides through the spectrum faster than anything that a cut makes: the drive of an axis,
// whose motor and screw follow the feed. The spindle's harmonics stand, or move with its speed; chatter grows where it
// is.
//
// Every 4 ms the power spectrum of the newest 32 ms is compared, bin by bin, with the most that the bin had a little
// earlier. The strongest bin that rose is the tone's place. Where these places lie on one straight line over time
// (least squares, to 0.6 bins), steeper than kLeastRate and longer than kLeastWay, a tone glides. Where it then stands
// still, it stands at the frequency that the drive has at full feed.
//
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/frame_ring.h"
#include "core/dsp/spectrum.h"

namespace stillcut::detect {

class MovingTone {
 public:
  // Hz a second. A spindle whose override moves by 10 % a second takes a line at 2 kHz along by 200.
  static constexpr double kLeastRate = 400.0;
  static constexpr double kLeastWay = 90.0;  // Hz: three bins
  static constexpr Seconds kWindow{0.032};   // a glide of 1 kHz in a second stays within a bin
  // From its first movement until it is called a glide, at most.
  static constexpr Seconds kRecognised{0.2};

  void prepare(Hertz rate);
  void reset() noexcept;
  // Conditioned samples of one channel. entering: a tool comes into the cut, where every harmonic rises, and what moves
  // must be followed for longer.
  void push(std::span<const double> x, bool entering = false) noexcept;

  bool glides() const noexcept { return gliding_; }
  // Where it glides, or where it came to stand; 0: there is none.
  Hertz frequency() const noexcept { return frequency_; }
  // A tone that glided has come to stand there, since the call before. Forgets that it did.
  bool takeArrived() noexcept;
  // Of the line within two bins of it that was not there before the last glide; itself, where there is none.
  Hertz lineNear(Hertz frequency) const noexcept;
  // Power of a line there.
  double power(Hertz frequency) const noexcept;

 private:
  static constexpr std::size_t kPlaces = 48;  // hops

  static constexpr std::size_t kDelay = 16;  // hops: "before" ends before what the newest spectrum holds of it

  void add(double x) noexcept;
  void look() noexcept;
  void follow() noexcept;
  void remember() noexcept;
  // Hz, between bins; 0: nothing there rose.
  double strongestAbove(std::span<const double> before, double from, double to) const noexcept;
  bool onTheWay(std::size_t places, double way) const noexcept;

  double rate_ = 0.0;               // Hz, after averaging
  int average_ = 1, averaged_ = 0;  // samples
  double sum_ = 0.0;
  std::size_t hop_ = 1, since_ = 0, looks_ = 0;  // averages; looks
  FrameRing heard_;
  std::vector<double> powers_, before_;
  std::vector<double> start_;    // before_, as it was before the glide
  std::vector<double> delayed_;  // [hop * bins + bin], a ring of the last spectra
  dsp::Spectrum spectrum_;
  std::array<double, kPlaces> places_{};  // Hz, newest last; 0: nothing rose
  bool entering_ = false;
  bool gliding_ = false, arrived_ = false;
  int still_ = 0, gone_ = 0;  // hops on end
  Hertz frequency_{};
};

}  // namespace stillcut::detect
