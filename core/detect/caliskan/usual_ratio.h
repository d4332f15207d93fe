// The energy ratio that a channel has anyway, while all of them together are calm: along the tool, or far from the cut,
// a sensor may hear little but noise and lines of the machine, and its ratio is high at any time. What it is used to
// proves nothing. Not in Caliskan 2018. Thread: worker; real-time.
#pragma once

namespace stillcut::detect {

class UsualRatio {
 public:
  void reset() { *this = {}; }
  // A part of a turn of a cut in which there is no chatter.
  void learn(double ratio, double turns);
  // From which ratio on it is more than usual. part: of the chatter ratio and of the rise, where it is asked for less.
  double limit(double chatterRatio, double part) const;

 private:
  double seen_ = 0.0;  // turns
  double mean_ = 0.0;
  double lowest_ = 0.0;  // of the means: what grows unheard does not become usual
};

}  // namespace stillcut::detect
