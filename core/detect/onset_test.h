// Growth above a learned floor, as a sequential test: is the vibration that does not repeat from turn to turn growing
// out of what it was while the cut was stable?
//
// The statistic is u = ln(E_d / E_x): energy of the turn difference over the energy of the vibration. In a stable cut
// its mean and scatter are learned: falling at once, rising slowly and by bounded steps, so that growth does not become
// its own floor, and frozen while an alarm lasts. The evidence adds up the
// excess over kDrift scatters per turn (a one-sided CUSUM, Page 1954): a burst far above the floor is believed within a
// fraction of a turn, a small excess must last.
// No threshold is set by hand; what an amplitude has to reach at least is the resolution at which chatter is spoken of.
// Thread: worker; real-time.
#pragma once

namespace stillcut::detect {

class OnsetTest {
 public:
  struct Limits {
    double smallestRatio = 0.0;  // E_d / E_x below which nothing is called growth
    double evidence = 4.0;       // sum of excess scatters at which growth is believed
  };

  void prepare(const Limits& limits) noexcept { limits_ = limits; }
  void reset() noexcept;
  // ratio: E_d / E_x of the last turn; turns: length of this step. learn: the cut is steady and nobody alarms.
  void update(double ratio, double turns, bool learn) noexcept;

  bool learned() const noexcept { return learnedTurns_ >= kLearnTurns; }
  bool alarm() const noexcept { return alarm_; }
  double evidence() const noexcept { return evidence_; }
  // Learned floor of E_d / E_x (geometric mean) and its scatter in nepers of energy.
  double floor() const noexcept;
  double scatter() const noexcept;
  double learnedTurns() const noexcept { return learnedTurns_; }
  static constexpr double kLearnTurns = 8.0;

 private:
  void follow(double u, double turns) noexcept;

  Limits limits_;
  double mean_ = 0.0;
  double variance_ = 0.0;
  double learnedTurns_ = 0.0;
  double evidence_ = 0.0;
  double calmTurns_ = 0.0;
  bool alarm_ = false;
};

}  // namespace stillcut::detect
