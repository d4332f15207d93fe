// The numbers of the learner, each with unit, reason and what a quarter more or less does (tests/bench/learning).
// Plain values: any thread.
#pragma once

#include <cstdint>

namespace stillcut::learn {

struct LearnParams {
  // Guessed machines held at once. More: smoother probabilities, time in proportion.
  int guesses = 600;
  // Standard deviation of ln(depth/limit) at which a cut goes from stable to chatter: error of the zeroth order in
  // slots and half immersions (a tenth), depth and immersion as programmed against as cut, the verdict's own border.
  double marginSd = 0.13;
  // The same for a cut that engages a small part of the time, where flip lobes are missing: marginSd rises to this at
  // an engagement of zero.
  double interruptedSd = 0.30;
  // Relative error of where the lobes stand along the speed [1], of a machine that does not change.
  double speedSd = 0.012;
  // What a machine drifts by from cut to cut, as a standard deviation of ln f after one cut [1]; grows with the root of
  // the cuts in between. 0.006 is 5 % after some 70 cuts.
  double driftPerCut = 0.006;
  // The same of ln(limit): an edge that wears, another blank.
  double wearPerCut = 0.012;
  // Fraction of stable cuts that chatter for another cause: clamping, a thin wall, a bearing.
  double strayChatter = 0.03;
  // Relative error of a predicted chatter frequency [1]: it rises with the depth beyond the limit.
  double frequencySd = 0.025;
  // How much of the error two cuts with the same numbers share, 0 .. 1: ten of the same say no more than 1/sharedError.
  double sharedError = 0.4;
  // Below this fraction of equal weights the guesses are resampled and moved.
  double leastEffective = 0.5;
  // Moves of every guess after a resampling.
  int moves = 3;
  // Log of the odds at which newer cuts speak for another tool rather than for the one learned: 1 : 200.
  double changedOdds = 5.3;
  int changedMostCuts = 6;  // newest cuts looked at for that
  std::uint64_t seed = 1;
};

}  // namespace stillcut::learn
