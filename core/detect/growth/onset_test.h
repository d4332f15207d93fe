// Growth above a learned floor, as a sequential test: is the vibration that does not repeat from turn to turn growing
// out of what it was while the cut was stable?
//
// The statistic is r = E_d / E_x, energy of the turn difference over the energy of the vibration, one turn at a time.
// In a stable cut it is the energy of noise, and noise in a narrow band (a lightly damped mode shaken by the chips) has
// few degrees of freedom: bursts of five times the mean are ordinary there, and unheard of in broad noise. So r is
// taken as Gamma-distributed, and mean, shape k = mean^2 / variance and correlation time are learned. The evidence is
// the CUSUM (Page 1954) of the log-likelihood ratio of kGrowth times the learned mean against the mean itself,
//   k (r / mean (1 - 1 / a) - ln a)  per correlation time, a = kGrowth;
// by Lorden (1971) a limit h lets a stable cut pass at least e^h correlation times on average before a false alarm:
// h = 12 is 160 000, 15 three million, and growth must show as a line between the harmonics as well. Steps of less than
// a turn may count by themselves: growth shows half a turn sooner than in the mean over the turn. They scatter more,
// and not alike where the noise lies in a part of the turn; then what holds an alarm back is that the mean must stand
// out too. Until much is learned, k counts as 1 and the mean as high as its own doubt allows. The floor falls as soon
// as the short mean lies below it for certain, rises slowly and by bounded steps so that growth does not become its own
// floor, and is frozen while an alarm lasts. Where the tool leaves the cut the vibration falls and what does not repeat
// stays, so that their ratio rises without anything growing: the energy is compared with no less vibration than the
// floor was learned in. Thread: worker; real-time.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/units.h"

namespace stillcut::detect {

class OnsetTest {
 public:
  struct Limits {
    double smallestRatio = 0.0;  // E_d / E_x below which nothing is called growth
    double evidence = 12.0;      // log-likelihood ratio [nepers] at which growth is believed
  };

  void prepare(const Limits& limits) { limits_ = limits; }
  void reset();
  // How fast one turn follows the other: the floor's memory is at least a second, for chatter grows in time and not in
  // turns, and on a fast spindle would become its own floor.
  void setSpindle(Hertz spindle);
  // ratio: E_d / E_x of the last turn; turns: length of this step. learn: the cut is steady and nobody alarms. energy:
  // E_d itself, in any unit; 0 where it is not known. newest: the part of `ratio` that is of this step, times as many
  // steps as it is of: evidence counts it at once and not half a turn later; none where ratio is of this step alone.
  void update(double ratio, double turns, bool learn, double energy = 0.0, std::optional<double> newest = std::nullopt);

  // What was learned was learned of something that may be so much larger now without having grown. Returns by how much
  // it counts as more: in all by no more than a hundred times until it is learned anew, which is what a mode damped by
  // 1 % makes of an order that comes from 10 % beside it.
  double raise(double factor);

  bool learned() const { return learnedTurns_ >= kLearnTurns; }
  bool alarm() const { return alarm_; }
  // ... and what made it is there now: an alarm outlasts it by some turns.
  bool grown() const { return alarm_ && standsOut_; }
  double evidence() const { return evidence_; }
  double evidenceLimit() const { return limits_.evidence; }
  // Learned floor of E_d / E_x (mean), the shape k of its distribution, and its correlation time in turns.
  double floor() const { return mean_; }
  double shape() const;
  double correlation() const;
  // E_d / E_x from which the newest turn is growth, at the floor of now.
  double leastGrowth() const { return std::max(kGrowth * mean_, limits_.smallestRatio); }
  // Mean of the energies that the floor was learned with.
  double floorEnergy() const { return meanEnergy_; }
  static constexpr double kLearnTurns = 8.0;
  static constexpr double kGrowth = 4.0;  // in energy: twice the amplitude, or it is not worth the word

 private:
  void follow(double ratio, double turns, double energy);
  double doubt(double turns) const;

  Limits limits_;
  double memoryTurns_ = 40.0;
  double mean_ = 0.0;
  double meanEnergy_ = 0.0;
  double shortMean_ = 0.0;
  double raised_ = 1.0;         // since that was learned
  double variance_ = 1.0;       // relative, of the ratio
  double shortVariance_ = 0.0;  // relative, of the short mean
  double learnedTurns_ = 0.0;
  double evidence_ = 0.0;
  double calmTurns_ = 0.0;
  bool alarm_ = false;
  bool standsOut_ = false;  // the newest turn, by kGrowth
};

}  // namespace stillcut::detect
