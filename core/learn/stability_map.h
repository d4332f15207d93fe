// The posterior as a shop reads it: how probable a stable cut is at each speed and depth, the depth that keeps a wanted
// risk, and the best cut within limits. Thread: one; some milliseconds, and some 30 ms more for an engagement that was
// not asked for before. Allocates.
#pragma once

#include <vector>

#include "core/learn/lobe_posterior.h"

namespace stillcut::learn {

struct MapRequest {
  milling::Engagement engagement;
  int teeth = 2;
  Rpm lowest{}, highest{};
  Metres deepest{};
  int speeds = 160;
  int depths = 80;
};

struct StabilityMap {
  std::vector<Rpm> speeds;
  std::vector<Metres> depths;      // equal steps up to the deepest
  std::vector<float> probability;  // of a stable cut, [speed * depths.size() + depth]

  float at(std::size_t speed, std::size_t depth) const { return probability[speed * depths.size() + depth]; }
};

// ln of the limit at one speed as a distribution: what map, advice and the next cut are read from.
class LimitDistribution {
 public:
  static constexpr int kBins = 260;
  LimitDistribution(double logDeepest);

  void clear();
  void add(double logLimit, double weight);
  // Softens by `sd` and sums up.
  void finish(double sd);
  double stableAt(double logDepth) const;  // probability that the limit lies deeper
  double depthAtRisk(double risk) const;   // [m]: the limit lies higher with this probability

 private:
  double logHighest_, logLowest_;
  std::vector<double> mass_, below_;
};

// Of the limit at one speed.
LimitDistribution limitDistribution(LobePosterior& posterior, std::size_t shape, Rpm speed);

StabilityMap stabilityMap(LobePosterior& posterior, const MapRequest& request);

// The limit over the speeds of the request as quantiles.
struct LimitQuantiles {
  std::vector<Rpm> speeds;
  std::vector<Metres> low, median, high;  // limit lies below with 10, 50, 90 %
  std::vector<Metres> atRisk;
};
LimitQuantiles limitQuantiles(LobePosterior& posterior, const MapRequest& request, double risk);

// The cut that removes most while it chatters with no more than `risk`.
struct LearnedAdvice {
  Rpm speed{};
  Metres depth{};
  double probabilityStable = 0.0;
  double removal = 0.0;  // depth times speed [m rev/min]: to compare, at one feed per tooth and immersion
};
LearnedAdvice learnedAdvice(LobePosterior& posterior, const MapRequest& request, double risk);

}  // namespace stillcut::learn
