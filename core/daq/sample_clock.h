// SampleClock: when samples were taken, from when their blocks were seen. A delay-locked loop of second order (F.
// Adriaensen, "Using a DLL to filter time", Linux Audio Conference 2005): the device counts, the clock of this computer
// corrects it slowly, and the jitter of a transport does not show.
//
// No sample is seen before it was taken, and a transport can only make it late. So what counts of every half second of
// arrivals is its least late block; a stall that is followed by a burst is over in one window, and nothing was lost.
//   Late in two windows by the same:  samples were lost without a word (libiio drops them silently); or, where the
//                                     device counts what it loses, the transport has become longer: time jumps.
//   Later, or earlier, in each:       the rate is another one. The median over some windows is the rate then, and
//                                     time jumps to it once; it is never a row of losses.
// What a device tells of losses is believed as far as the time that has gone by has room for it.
// Thread: driver; real-time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut::daq {

class SampleClock {
 public:
  // countsLosses: the device tells what it has lost. lossUnit: ... but for multiples of so many frames (a counter of
  // few bits); 1 for a device that tells nothing.
  void prepare(Hertz nominal, int blockFrames, bool countsLosses, std::uint64_t lossUnit = 1) noexcept;

  // Before stamp(), what is known of the samples missing before its block:
  void skip(std::uint64_t frames) noexcept { told_ = frames; }  // the device says so many
  void doubt() noexcept { doubtful_ = true; }                   // some, perhaps none
  void cut() noexcept { cut_ = true; }                          // the stream was interrupted: all that time shows

  // A block of `frames` of which the last was seen at `seen`. Returns when its first was taken.
  Instant stamp(int frames, Instant seen) noexcept;
  // Of the last stamp(): frames missing before it, reported or found, and counted into the time.
  std::uint64_t lost() const noexcept { return lost_; }
  // Of the last stamp(): time does not go on from the block before.
  bool jumped() const noexcept { return jumped_; }
  // Enough has arrived to tell whether the rate is the nominal one; rate() is the one that was found.
  bool settled() const noexcept { return settled_; }
  // As the loop has it.
  Hertz rate() const noexcept { return Hertz(period_ > 0.0 ? 1.0 / period_ : 0.0); }

 private:
  struct Arrival {
    double at = 0.0;      // s since the origin
    double frames = 0.0;  // counted until then, lost ones included
  };
  static constexpr std::size_t kWindows = 5;

  void take(int frames, double at) noexcept;
  void lose(double seconds) noexcept;
  void note(double at, double late) noexcept;
  void judge() noexcept;
  double arrivalPeriod() const noexcept;

  double nominal_ = 0.0;
  bool countsLosses_ = false;
  std::uint64_t lossUnit_ = 1;
  double block_ = 0.0;                // s
  double latest_ = 0.0;               // s: what is later is no jitter
  double base_ = 0.0, period_ = 0.0;  // s per frame: nominal or found; of the loop, near it
  bool started_ = false;
  Instant origin_{};
  double next_ = 0.0;             // s since the origin: when the frame after the last one is taken
  double counted_ = 0.0;          // frames until next_
  double since_ = 0.0;            // s since the start or the last cut
  double at_ = 0.0, late_ = 0.0;  // of the block before
  // The window that runs, and what was before it.
  bool any_ = false, follows_ = false;
  double windowBegin_ = 0.0, least_ = 0.0, leastBefore_ = 0.0;
  Arrival first_, before_;  // the least late of the window, and of the one before
  double firstLate_ = 0.0;  // against base_
  std::array<double, kWindows> periods_{};
  std::size_t windows_ = 0;
  bool settled_ = false;

  std::uint64_t told_ = 0, lost_ = 0;
  bool doubtful_ = false, cut_ = false, jumped_ = false;
  Instant last_{};
};

}  // namespace stillcut::daq
