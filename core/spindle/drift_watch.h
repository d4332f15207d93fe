// Does a spindle that is followed turn by turn drift? A drift is what successive stretches of turns show: each turns
// faster (or slower) than the one before by about as much, and all together further than a spindle under load wanders
// and than the turns scatter. What beats, steps or turns the phases once does not go on like that. Thread: worker;
// real-time.
#pragma once

#include <array>
#include <optional>

namespace stillcut::detect {

class DriftWatch {
 public:
  static constexpr int kStretch = 6;  // turns
  static constexpr int kStretches = 4;
  static constexpr int kTurns = kStretch * kStretches;

  void reset() noexcept { count_ = 0; }
  // Where the spindle was at this time: angle [rad] since anywhere, in the middle of one turn after the other.
  void add(double seconds, double angle) noexcept;

  struct Drift {
    double omega = 0.0;  // rad/s, at the time of the last turn
    double alpha = 0.0;  // rad/s^2
  };
  // wander: growth of the speed's variance of a spindle that does not drift [rad^2/s^3].
  std::optional<Drift> shown(double wander) const noexcept;
  // The speed stands still, as far as a spindle's does: what was shown is over.
  bool over(double wander) const noexcept;

 private:
  struct Turn {
    double seconds = 0.0;
    double angle = 0.0;
  };
  struct Stretch {
    double seconds = 0.0;   // its middle
    double omega = 0.0;     // rad/s
    double variance = 0.0;  // of omega, by how far the turns lie beside it
  };
  const Turn& turn(int index) const noexcept;
  Stretch stretch(int index) const noexcept;

  std::array<Turn, kTurns> turns_{};
  int next_ = 0;
  int count_ = 0;
};

}  // namespace stillcut::detect
