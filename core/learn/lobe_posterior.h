// What is known of a machine's stability from its prior and its judged cuts: guessed machines with weights, renewed
// after every cut (sequential Monte Carlo; MODEL.md). Same prior, cuts and seed give the same numbers.
// Thread: one. Allocates; not for the sample path: an update takes up to a second (tests/bench/learning).
#pragma once

#include <optional>
#include <vector>

#include "core/learn/guess_cloud.h"

namespace stillcut::learn {

// Speeds and depths that the learner looks at.
struct LearnRange {
  Rpm lowest{1000.0}, highest{20000.0};
  Metres deepest{0.020};
};
// Wide enough for the machine's own limits and for every cut.
LearnRange rangeOf(std::span<const CutEvidence> cuts, Rpm lowest, Rpm highest, Metres deepest);

class LobePosterior {
 public:
  LobePosterior(const MachinePrior& prior, const LearnRange& range, const LearnParams& params = {});

  // The next cut, in the order of time. Error: check() refuses it, or its speed lies outside the range.
  Status add(const CutEvidence& cut);

  const std::vector<CutEvidence>& cuts() const { return cuts_; }  // that count: since the last new start
  int forgotten() const { return forgotten_; }                    // cuts of before the last new start
  // Empty, or why the learner began anew.
  const Message& startedAnew() const { return startedAnew_; }
  // Probability that the last cut came out as it did, as it was expected before; 1 before the first.
  double lastExpected() const { return lastExpected_; }

  const GuessCloud& guesses() const { return cloud_; }
  const SpeedGrid& grid() const { return grid_; }
  const LearnRange& range() const { return range_; }
  const LearnParams& params() const { return params_; }
  // The shape of an engagement, made when it is asked for first: its limits are worked out for every guess.
  std::size_t shapeOf(const milling::Engagement& engagement, int teeth);
  const Shape& shape(std::size_t i) const { return shapes_[i]; }

 private:
  void beginAnew(std::size_t keep);
  std::size_t cutsOfAnother();  // how many newest cuts speak for another tool; 0: none

  MachinePrior prior_;
  LearnRange range_;
  LearnParams params_;
  SpeedGrid grid_;
  Random random_;
  GuessCloud cloud_;
  GuessCloud fresh_;  // of the prior, never updated
  std::vector<Shape> shapes_;
  std::vector<CutEvidence> cuts_;
  std::vector<std::size_t> shapeOfCut_;
  std::vector<double> expected_;  // ln of the predictive probability of each cut
  double lastExpected_ = 1.0;
  int forgotten_ = 0;
  Message startedAnew_;
};

}  // namespace stillcut::learn
