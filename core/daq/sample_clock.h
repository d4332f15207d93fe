// SampleClock: when samples were taken, from when their blocks were seen. A delay-locked loop of second order (F.
// Adriaensen, "Using a DLL to filter time", Linux Audio Conference 2005): the device counts, the clock of this computer
// corrects it slowly, and the jitter of a transport does not show.
//
// A block that is seen late is late alone: the next ones come in a burst and are on time again. A block that was lost
// leaves all that follow late by its length for good. So lateness that no block of the last half second was without is
// lost samples, which finds what a driver does not report (libiio drops them silently). A device that counts what it
// loses is believed: such lateness is then a rate that is not the told one, and time follows it.
// Thread: driver; real-time.
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut::daq {

class SampleClock {
 public:
  // countsLosses: the device tells what it has lost.
  void prepare(Hertz nominal, int blockFrames, bool countsLosses) noexcept;
  void reset() noexcept;

  // A block of `frames` of which the last was seen at `seen`. Returns when its first was taken.
  Instant stamp(int frames, Instant seen) noexcept;
  // Frames that are missing before the next block, told by the device itself.
  void skip(std::uint64_t frames) noexcept;
  // Frames lost without a word, as found by the last stamp(); they are counted into the time already.
  std::uint64_t lost() const noexcept { return lost_; }
  // As the loop has it.
  Hertz rate() const noexcept { return Hertz(period_ > 0.0 ? 1.0 / period_ : 0.0); }

 private:
  double nominal_ = 0.0;
  bool countsLosses_ = false;
  double block_ = 0.0;   // s
  double period_ = 0.0;  // s per frame
  bool started_ = false;
  Instant origin_{};
  double next_ = 0.0;   // s since the origin: when the frame after the last one is taken
  double since_ = 0.0;  // s since the start
  double least_ = 0.0;  // lateness, smallest of the half second
  double window_ = 0.0;
  bool any_ = false;
  std::uint64_t lost_ = 0;
  Instant last_{};
};

}  // namespace stillcut::daq
