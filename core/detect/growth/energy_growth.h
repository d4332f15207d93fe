// Growth of what does not repeat from turn to turn (turn_difference.h) over the vibration, for one channel, hop by hop:
// eighths of a turn.
// Thread: worker; real-time.
#pragma once

#include <array>
#include <span>

#include "core/base/units.h"
#include "core/detect/growth/onset_test.h"

namespace stillcut::detect {

inline constexpr int kHopsPerTurn = 8;

class EnergyGrowth {
 public:
  static constexpr int kLevelHops = 8 * kHopsPerTurn;
  static constexpr int kLeapHops = 3 * kHopsPerTurn;  // after a leap two turns are compared with it

  struct Statistic {
    double arrival = 1.0;     // part of the power of a line that it passes during the line's first turn
    bool atOnce = true;       // evidence counts every hop as it comes, not the whole turn up to it: half a turn sooner
    double risingPart = 0.0;  // of the vibration's energy, that growth which no spectrum is waited for has to hold
  };
  void prepare(const OnsetTest::Limits& limits, const Statistic& statistic) {
    onset_.prepare(limits);
    statistic_ = statistic;
  }
  // Forgets the levels, after a gap; what was learned stays.
  void restart();
  void relearn() {
    onset_.reset();
    unheardTurns_ = unheardLevel_ = 0.0;
  }
  void setSpindle(Hertz spindle) { onset_.setSpindle(spindle); }

  // Some frames: the vibration and what is new in it.
  void add(std::span<const double> x, std::span<const double> unrepeated);
  // windowHops: newest hops over which the energies are averaged; length: of the hop.
  void endHop(int windowHops, Seconds length);
  // Before test(): what leaps in one statistic of a channel has leapt in the other, whose floor may hide it.
  void leapWith(const EnergyGrowth& other);
  // Tests the level of the last hop; learn: the cut is steady and nobody alarms.
  void test(int windowHops, bool learn);
  // Grown, but not growing, for long, and nobody alarms: that is a new level, whose floor is to be learned.
  bool standsStill() const { return unheardTurns_ > kNewLevelTurns; }

  // E_d / E_x of the newest window.
  double changed() const { return changed_; }
  // E_d of the newest window, per hop.
  double energy() const { return energy_; }
  // E_x of the newest eight turns, per hop.
  double level() const { return level_; }
  // E_x of the last turn over that of the newest eight: what grows adds to a vibration, so of one that falls it is not
  // believed. The tool leaves, or the sensor loses its seat: then its own loss is what does not repeat.
  double levelTrend() const;
  // Exponential growth shows before any spectrum can: three turns in a row, each well above the one before. Less than
  // that is no proof: where a tool comes to the end of the work a forced vibration changes within a turn. A knock
  // rises once and decays. Forced vibration that begins to change, as where a ramp of the width of cut begins, rises
  // ever less steeply; growth out of a floor is a sum of exponentials, whose logarithm is convex: the ratios rise.
  // Forced vibration that changes by a share e in a turn leaves e^2 here, but changes the whole energy by 2 e: the
  // energy must grow by no more than what is new explains.
  bool rising() const;
  // Growth, and neither a blow nor what rings down after one: a vibration that grows passes through every level between
  // its noise and what it is now; a blow, or a tooth that leaves the material at once, leaps over them. What is there
  // after a leap has grown only where it exceeds the leap; where it neither does nor calms down the load has changed,
  // and the floor of the new one is learned. Where a forced vibration begins to change by the same in each turn, the
  // turn difference holds a bump of two turns: growth is always more than what was there in them.
  bool steadyGrowth() const;
  // ... and it grows on: a burst of narrow-band noise stands at its height for some turns, a line that has come does
  // not.
  bool growsOn() const { return changedIn(0, kHopsPerTurn) > kGrowsOn * changedIn(kHopsPerTurn, kHopsPerTurn); }
  // Turns since the last leap, no further than kLevelHops.
  double turnsSinceLeap() const { return static_cast<double>(sinceLeap_) / kHopsPerTurn; }
  const OnsetTest& onset() const { return onset_; }

 private:
  struct Energies {
    double all = 0.0;
    double changed = 0.0;  // of the turn difference
  };
  const Energies& ago(int hops) const {
    return hops_[static_cast<std::size_t>((newest_ - hops + kLevelHops) % kLevelHops)];
  }
  void watchStanding(bool unheard);
  double changedIn(int from, int hops) const;
  bool grows() const;
  bool steepens(int hops, double scatter) const;
  bool leaps(Seconds length) const;
  bool leaps(int hops, double limit) const;
  bool leapt() const { return sinceLeap_ < kLeapHops; }
  bool explainsEnergy() const;

  static constexpr double kNewLevelTurns = 24.0;
  static constexpr double kGrowsOn = 1.25;  // energy, from turn to turn
  Statistic statistic_;
  double unheardTurns_ = 0.0;  // grown, and nobody alarms, to
  double unheardLevel_ = 0.0;  // ... this
  Energies sums_;              // this hop
  std::array<Energies, kLevelHops> hops_{};
  int newest_ = 0;
  double changed_ = 0.0;
  double energy_ = 0.0;  // E_d of the newest window, per hop
  double level_ = 0.0;
  double leap_ = 0.0;           // E_d of the leap that nothing has come of yet; 0: none
  int sinceLeap_ = kLevelHops;  // hops, no further than kLevelHops
  OnsetTest onset_;
};

}  // namespace stillcut::detect
