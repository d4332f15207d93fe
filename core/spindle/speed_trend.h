// How does the speed drift that is found in one window after the other, while no lock on it has settled? Each window
// tells the speed of its middle: that of a drifting spindle is over when it is found, and the phases run away from
// whoever follows them there before they are known. What the windows say one after the other shows the drift itself:
// by a straight line through as many as lie within one, so that the first and the last have nothing in common, which
// goes further than a spindle under load wanders and than the windows scatter. Thread: worker; real-time.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/units.h"

namespace stillcut::detect {

class SpeedTrend {
 public:
  // looks: so many windows lie within one, 6 at most.
  void prepare(int looks) noexcept;
  void reset() noexcept {
    count_ = 0;
    unbroken_ = false;
  }
  // What a window says, and the time of its middle. One that says something else than the last one begins
  // anew, and so does one after a pause, as while a lock needed none.
  void add(Seconds middle, Hertz spindle) noexcept;
  // Here a lock began, on what was said last.
  void mark() noexcept { unbroken_ = true; }
  // Has what was said since then led on from there step by step? A comb that was followed and has moved does; one that
  // is made up of chatter is elsewhere at once.
  bool unbroken() const noexcept { return unbroken_; }
  // Relative, per second; 0: none is shown.
  double drift() const noexcept;

 private:
  static constexpr std::size_t kMost = 7;
  struct Said {
    double seconds = 0.0;
    double hertz = 0.0;
  };
  std::array<Said, kMost> said_{};
  std::size_t needed_ = kMost;
  std::size_t count_ = 0;
  bool unbroken_ = false;
};

}  // namespace stillcut::detect
