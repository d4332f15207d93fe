// DriveTone: takes the tone of an axis drive out of one channel. It glides up as the axis accelerates, stands while it
// moves at constant feed, and glides down again (moving_tone.h): what glided to where it stands is the machine's, and
// no chatter, however far from the spindle's harmonics.
//
// While the tone stands its complex amplitude z is followed by least mean squares and its wave subtracted:
//     e = x - 2 Re(z r),   z += mu e conj(r),   r = e^{j phi},   phi += 2 pi f / F_s,   mu = 1 / (0.02 s F_s)
// a notch of 8 Hz on either side; f follows the rotation of z from hop to hop, as feed and load pull at it. While it
// glides nothing can be judged: its line is in every comparison of one revolution with the next.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <complex>
#include <span>

#include "core/base/units.h"
#include "core/sensing/moving_tone.h"

namespace stillcut::detect {

class DriveTone {
 public:
  void prepare(Hertz rate);
  void reset() noexcept;
  // Conditioned samples of one channel, in place. entering: the tool comes into the cut.
  void process(std::span<double> x, bool entering = false) noexcept;
  // A tone glides, has just come to stand, or has just left: what the samples hold is no cut alone.
  bool unsettled() const noexcept { return unsettled_ > 0 || watch_.glides(); }
  // One was received in the last minute: what seems to grow may be the next one, until it is seen to stand.
  bool expected() const noexcept { return expected_ > 0; }
  // Of the tone that glides or stands; 0: there is none.
  Hertz frequency() const noexcept {
    return standing_ ? Hertz(frequency_) : unsettled() ? watch_.frequency() : Hertz(0.0);
  }
  bool standing() const noexcept { return standing_; }

 private:
  void arrive() noexcept;
  void creep() noexcept;
  void watchPower(long samples) noexcept;
  long settles() const noexcept;
  void cancel(std::span<double> x) noexcept;

  double rate_ = 0.0;
  MovingTone watch_;
  bool standing_ = false;
  long unsettled_ = 0, expected_ = 0;  // samples left
  double frequency_ = 0.0;             // Hz
  double arrived_ = 0.0;               // power of its line as it came to stand
  long since_ = 0, weak_ = 0;          // samples since it arrived; in which it was weak
  std::complex<double> rotor_ = 1.0, amplitude_, before_;
  long sinceBefore_ = 0;
};

}  // namespace stillcut::detect
