#include "core/learn/next_cut.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stillcut::learn {
namespace {

constexpr int kSpeeds = 40;  // looked at, for trial and advice
constexpr int kDepths = 12;
constexpr int kValued = 60;                // candidates whose value is worked out, the most telling ones
constexpr double kFrequencyBin = 0.06;     // of ln f: chatter frequencies that are distinguished
constexpr double kPricePerChatter = 0.03;  // of the removal, for a trial that chatters
constexpr double kPricePerBit = 0.03;      // of the removal, for each later cut of a series

double entropy(double p) {
  return p <= 0.0 || p >= 1.0 ? 0.0 : -(p * std::log2(p) + (1.0 - p) * std::log2(1.0 - p));
}

// How each guess sees one candidate.
struct Candidate {
  Term term;
  std::vector<double> chatter;  // probability, by guess
  double mean = 0.0;            // of it
  double bits = 0.0;
};

class Search {
 public:
  Search(LobePosterior& posterior, const TrialLimits& limits, std::size_t shape)
      : posterior_(posterior),
        guesses_(posterior.guesses()),
        limits_(limits),
        shape_(shape),
        distribution_(std::log(posterior.range().deepest.value)) {
    const GuessCloud& g = guesses_;
    for (int s = 0; s < kSpeeds; ++s) {
      speeds_.push_back(limits.lowest.value + (limits.highest - limits.lowest).value * s / (kSpeeds - 1));
      for (std::size_t i = 0; i < g.size(); ++i) {
        logLimits_.push_back(limitAt(g[i].limits[shape], posterior.grid(), speeds_.back()).logDepth);
      }
    }
  }

  LearnedAdvice best(const std::vector<double>& weights) {
    LearnedAdvice advice;
    for (std::size_t s = 0; s < speeds_.size(); ++s) {
      distribution_.clear();
      for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] > 0.0) distribution_.add(logLimits_[s * weights.size() + i], weights[i]);
      }
      distribution_.finish(posterior_.shape(shape_).marginSd);
      const double depth = std::min(distribution_.depthAtRisk(limits_.risk), limits_.deepest.value);
      if (depth * speeds_[s] <= advice.removal) continue;
      advice = {Rpm(speeds_[s]), Metres(depth), distribution_.stableAt(std::log(depth)), depth * speeds_[s]};
    }
    return advice;
  }

  Candidate look(double speed, double depth) const {
    Candidate c;
    c.term.shape = shape_;
    c.term.speed = speed;
    c.term.logDepth = std::log(depth);
    c.term.marginSd = posterior_.shape(shape_).marginSd;
    c.term.speedSd = posterior_.params().speedSd;
    double within = 0.0;
    std::map<int, double> frequencies;
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      const double stray = posterior_.params().strayChatter;
      const double p =
          stray + (1.0 - 2.0 * stray) * probabilityOfChatter(c.term, guesses_[i].limits[shape_], posterior_.grid());
      c.chatter.push_back(p);
      const double weight = guesses_.weights()[i];
      c.mean += weight * p;
      within += weight * entropy(p);
      frequencies[binOf(i, speed)] += weight * p;
    }
    c.bits = entropy(c.mean) - within;
    for (const auto& [bin, mass] : frequencies) {
      if (mass > 0.0) c.bits -= mass * std::log2(mass / c.mean);
    }
    return c;
  }

  NextCut value(const Candidate& c, const LearnedAdvice& now) {
    NextCut next;
    next.speed = Rpm(c.term.speed);
    next.depth = Metres(std::exp(c.term.logDepth));
    next.probabilityStable = 1.0 - c.mean;
    next.bits = c.bits;
    next.now = now;
    next.removalNow = now.removal;
    std::vector<double> weights(guesses_.size());
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = guesses_.weights()[i] * (1.0 - c.chatter[i]);
    next.ifStable = best(weights);
    next.removalExpected = (1.0 - c.mean) * next.ifStable.removal;
    addChatter(c, next);
    return next;
  }

 private:
  int binOf(std::size_t guess, double speed) const {
    const double f = limitAt(guesses_[guess].limits[shape_], posterior_.grid(), speed).frequency;
    return f > 0.0 ? static_cast<int>(std::floor(std::log(f) / kFrequencyBin)) : -1;
  }

  // Chatter tells its frequency: the guesses that foresee another one fall away.
  void addChatter(const Candidate& c, NextCut& next) {
    std::map<int, std::vector<double>> weightsOf;
    std::map<int, double> mass;
    for (std::size_t i = 0; i < guesses_.size(); ++i) {
      const int bin = binOf(i, c.term.speed);
      auto& weights = weightsOf[bin];
      weights.resize(guesses_.size(), 0.0);
      weights[i] = guesses_.weights()[i] * c.chatter[i];
      mass[bin] += weights[i];
    }
    double largest = 0.0;
    double seen = 0.0;
    double sum = 0.0;
    for (const auto& [bin, weights] : weightsOf) {
      if (mass[bin] < 0.02 * c.mean) continue;
      const LearnedAdvice advice = best(weights);
      sum += mass[bin] * advice.removal;
      seen += mass[bin];
      if (mass[bin] <= largest) continue;
      largest = mass[bin];
      next.ifChatter = advice;
    }
    if (seen > 0.0) next.removalExpected += c.mean * sum / seen;
  }

  LobePosterior& posterior_;
  const GuessCloud& guesses_;
  const TrialLimits& limits_;
  std::size_t shape_;
  std::vector<double> speeds_;
  std::vector<float> logLimits_;  // [speed * guesses + guess]
  LimitDistribution distribution_;
};

Status checkLimits(const TrialLimits& limits) {
  const bool speeds = limits.lowest.value > 0.0 && limits.highest > limits.lowest && isFinite(limits.highest);
  if (!speeds) return Error{message("limits"), message("the highest speed must lie above the lowest, both above 0")};
  if (!(limits.deepest.value > 0.0) || !isFinite(limits.deepest)) {
    return Error{message("limits"), message("the largest depth must lie above 0")};
  }
  if (!(limits.risk > 0.0 && limits.risk < 1.0)) {
    return Error{message("limits"), message("the risk must lie between 0 and 1")};
  }
  return Done{};
}

}  // namespace

Result<NextCut> nextCut(LobePosterior& posterior, const TrialLimits& limits) {
  if (Status ok = checkLimits(limits); !ok) return ok.error();
  const std::size_t shape = posterior.shapeOf(limits.engagement, limits.teeth);
  Search search(posterior, limits, shape);
  const std::vector<double> today(posterior.guesses().weights().begin(), posterior.guesses().weights().end());
  const LearnedAdvice now = search.best(today);
  const double shallowest = std::min(0.5 * now.depth.value, 0.25 * limits.deepest.value);
  std::vector<Candidate> candidates;
  for (int s = 0; s < kSpeeds; ++s) {
    const double speed = limits.lowest.value + (limits.highest - limits.lowest).value * s / (kSpeeds - 1);
    for (int d = 0; d < kDepths; ++d) {
      const double depth = shallowest * std::pow(limits.deepest.value / shallowest, d / (kDepths - 1.0));
      Candidate c = search.look(speed, depth);
      if (c.mean <= limits.mostChatter) candidates.push_back(std::move(c));
    }
  }
  // Where even the shallowest trial would probably chatter, it is the one to make.
  if (candidates.empty()) candidates.push_back(search.look(now.speed.value, shallowest));
  const auto valued = std::min<std::size_t>(kValued, candidates.size());
  std::ranges::partial_sort(candidates, candidates.begin() + static_cast<std::ptrdiff_t>(valued), {},
                            [](const Candidate& c) { return -c.bits; });
  NextCut chosen;
  double most = -1e300;
  for (std::size_t i = 0; i < valued; ++i) {
    const NextCut next = search.value(candidates[i], now);
    const double score = next.removalExpected / now.removal - kPricePerChatter * (1.0 - next.probabilityStable) +
                         kPricePerBit * (limits.cutsLeft - 1) * next.bits;
    if (score <= most) continue;
    most = score;
    chosen = next;
  }
  return chosen;
}

}  // namespace stillcut::learn
