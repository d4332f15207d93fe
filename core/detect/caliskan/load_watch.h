// Does the load change so quickly that what an order does is the load's?
//
// A load that changes modulates every order of the forced vibration: symmetric side lines, locked to the order. Where
// it changes within a few turns, as on a slow spindle, they are as broad as chatter's line, and an order on a mode
// changes by more than the load does, and in phase as well: a share s of the load makes s p / (1 - s g) of it, whose
// logarithm changes by ds / s / (1 - s g), up to five times as much as the load's at 80 % of the limit. Chatter beside
// an order turns it and grows whether the load changes or not. So the load is measured where that line is not: on the
// tooth passings but the two that it lies between, whichever two leave the least; in size and phase, for an arc that
// moves may change their pattern and not what they are in all. While it changes quickly, and some turns after, an order
// must change by more than that from one turn to the next. What changes by a few per cent a turn is slow for the turn
// difference but where it begins; but runout on a mode may be most of the vibration, and then all of the news, and the
// turning of that order, may be no more than five times the load's change. Chatter beside a tooth passing has side
// lines beside all of them and moves them all: what lasts for longer than a load can change is none. Of a tool with one
// tooth, where any chatter does that, nothing is said. Not in Caliskan 2018.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "core/detect/caliskan/energy_chain.h"
#include "core/detect/growth/new_line.h"

namespace stillcut::detect {

class LoadWatch {
 public:
  void prepare(int teeth);
  void reset();
  // One turn: what the harmonic filter holds of a channel; where that changes quickly, windows without its leakage do.
  // noise: its power in one order of a window of two turns, over that of all forced vibration. Where tooth passings
  // cancel, as at full immersion, noise is most of what they change by.
  void endTurn(const EnergyChain& chain, const NewLine& vibration, int channel, Hertz spindle, double noise);

  // The load has changed by so much from one turn to the next that an order's change of size may be its doing.
  bool changesQuickly() const { return most() > kQuickly; }
  // ... and is: that of the order next to `order`, which may be a fraction.
  bool explains(const NewLine& vibration, int channel, double order, Hertz spindle) const;
  // The most that it may change any order by in a turn, relative.
  double mostOfAnOrder() const;
  // All of the news (turn_difference.h), over the vibration's energy, may be the load's, whether it changes quickly or
  // not: a mode on an order near the limit may make most of the vibration.
  bool explainsNews(double news) const;
  // ... of the turn difference, which hears only what the load's change changes by.
  bool explainsDifference(double difference) const;

 private:
  static constexpr std::size_t kTeeth = 6;  // passings that tell the load
  static constexpr std::size_t kTurns = 6;  // for which a change is remembered: the filters' and the windows' memory
  // Of the amplitude in a turn: what is slower leaves less in the turn difference than the smallest onset, 3 %, for at
  // five times the load that is twenty times the change's square and twice as much again by its own curvature.
  static constexpr double kQuickly = 0.05;
  static constexpr int kMostTurns = 32;                       // by as much as that in each: fivefold
  using Passings = std::array<std::complex<double>, kTeeth>;  // amplitudes
  double bounded(double change);
  static double angleOf(const Passings& now, const Passings& before, std::size_t skip);
  static double least(const Passings& now, const Passings& before, double noise);
  double most() const;
  double mostBent() const;

  int teeth_ = 0;
  Passings before_{};                         // a turn ago
  std::vector<std::complex<double>> orders_;  // of now
  int quickTurns_ = 0;                        // but for shorter pauses than the memory
  std::size_t calmTurns_ = 0;
  std::array<double, kTurns> changes_{};
  std::array<double, kTurns> bends_{};  // of the change, from turn to turn
  std::size_t newest_ = 0;
};

}  // namespace stillcut::detect
