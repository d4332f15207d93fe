// DivergenceWatch: tells when an adaptive loop runs away or is at its end, from what goes out and what comes back.
// Energies are summed over windows of 4 ms. Given up when
//   Diverging:  error and output both grew by 30 % in each of four windows in a row, the error is twice (in amplitude)
//               what it was in any window of the quarter second before, and the output is above a tenth of its limit:
//               growth from outside has no reason to follow the output, but for a while, through what was learned, it
//               does; so it does when a tool enters at once, at the beginning of the stroke
//   Saturated:  more than half of the last three windows' samples were cut off at a limit, and the error is twice that
//               too: the output is at its end and nothing gets better. Or more than half of a quarter second's were,
//               and the error of late is twice the quietest of the last half minute, or has half as much power again
//               as before the output began: the end of a runaway that was too slow to be seen from window to window,
//               as with a wrong sign and a small step, or whose stroke is too short to make the error twice as loud
//   Worse:      now, and in more than half of a quarter second, the error had twice the power of what the controller's
//               own model says it would be without output. Not sooner: in air the loop learns from the sensor's noise,
//               and when the tool enters it takes some 50 ms to learn the cut instead; what grows is caught by the
//               rules above. Not while the output is below a hundredth of its limit: nothing is at stake.
//   DeadSensor: the reading has not changed at all for 5 ms while something goes out
//   Silenced:   it went on steadily and then fell by 20 dB at once for three windows, while the output went on as it
//               was: no control does that, but a cable that breaks leaves the converter's noise
// so that at the latest 16 ms of growth, 12 ms of saturation or 16 ms of silence pass, 132 ms of a steady vibration
// that is worse than without, and 250 ms at the end of a stroke. Thread: one, real-time.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/realtime.h"
#include "core/base/units.h"

namespace stillcut::safety {

enum class LoopHealth { Fine, Diverging, Saturated, Worse, DeadSensor, Silenced };

class DivergenceWatch {
 public:
  // `amplitude`: the largest output.
  void prepare(Hertz rate, double amplitude) noexcept;
  // The output begins; what was listened to counts.
  void reset() noexcept;
  // Once a sample while nothing goes out.
  void listen(double error) STILLCUT_RT;
  // Once a sample: the error read, what it would be without output (the error itself when nobody knows), what was
  // written, and whether a limit had cut it off.
  LoopHealth watch(double error, double without, double output, bool limited) STILLCUT_RT;

 private:
  static constexpr std::size_t kWindows = 64;  // a quarter second
  static constexpr std::size_t kGrowing = 4;
  struct Window {
    double error = 0.0, without = 0.0, output = 0.0;
    int limited = 0;
  };
  LoopHealth judge() STILLCUT_RT;
  bool atEnd(std::size_t windows) const STILLCUT_RT;
  bool louderThanBefore() const STILLCUT_RT;
  bool growing() const STILLCUT_RT;
  bool loud() const STILLCUT_RT;
  bool silenced() const STILLCUT_RT;
  bool worse() const STILLCUT_RT;
  const Window& back(std::size_t windows) const STILLCUT_RT { return ring_[(newest_ + kWindows - windows) % kWindows]; }

  std::array<Window, kWindows> ring_{};
  std::size_t newest_ = 0;
  std::size_t filled_ = 0;
  Window open_;
  int length_ = 20;  // samples in a window
  int count_ = 0;
  int still_ = 0;  // samples without any change
  int silence_ = 25;
  double usual_ = 0.0, quietest_ = 0.0;  // error of a window: of late, and the least of that
  double forgets_ = 1.0;                 // the least, and what was before, from window to window
  double before_ = 0.0;                  // error of a window before the output began
  std::size_t heard_ = 0;                // windows of it, up to a quarter second
  double slight_ = 0.0;                  // energy of an output in a window that does no harm
  double atStake_ = 0.0;                 // and of one that may run away
  double last_ = 0.0;
};

}  // namespace stillcut::safety
