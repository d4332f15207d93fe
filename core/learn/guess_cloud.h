// Guessed machines with their weights and their limits over the speed: what the posterior is made of.
// Thread: one. Allocates.
#pragma once

#include <span>
#include <vector>

#include "core/learn/likelihood.h"
#include "core/learn/machine_prior.h"
#include "core/learn/random.h"

namespace stillcut::learn {

struct Guess {
  std::vector<double> numbers;                  // standard normal before the first cut
  std::vector<std::vector<LimitPoint>> limits;  // one table per shape
  double past = 0.0;                            // log-likelihood of what its weight already holds,
  double now = 0.0;                             // and of what it is to hold
};

class GuessCloud {
 public:
  // `count` guesses from the prior, with equal weights.
  GuessCloud(const MachinePrior& prior, const SpeedGrid& grid, double deepest, int count, Random& random);

  std::size_t size() const { return guesses_.size(); }
  const Guess& operator[](std::size_t i) const { return guesses_[i]; }
  std::span<const double> weights() const { return weights_; }  // sum to 1
  double effective() const;                                     // fraction of equal weights, 0 .. 1
  Dynamics machine(std::size_t i) const { return prior_.machineAt(guesses_[i].numbers); }

  void addShape(const Shape& shape);
  // ln of the mean likelihood of `term`, by today's weights.
  double logPredictive(const Term& term, const LearnParams& params) const;
  // ln of the mean likelihood of all `terms` together, by equal weights.
  double logEvidence(std::span<const Term> terms, const LearnParams& params) const;
  // Weights as `terms` ask for; where too few guesses remain, they are resampled and moved, in steps.
  void update(std::span<const Term> terms, const LearnParams& params, Random& random);

 private:
  // Where a step stands between what the weights held before (0) and what is asked of them (1).
  struct Target {
    std::span<const Term> terms;
    double exponent = 0.0;
  };
  struct Proposal {
    std::vector<double> numbers;
    double logPrior = 0.0;  // ln of the prior's ratio, new over old, as far as it counts
  };

  double effectiveAfter(double exponent) const;  // fraction of equal weights after that much of the gains
  double stepWithin(double left, double leastEffective) const;
  void reweight(double exponent);
  void resample(Random& random);
  void move(const Target& target, const LearnParams& params, Random& random);
  void propose(std::size_t i, std::span<const Term> terms, Random& random, Proposal& out) const;
  bool leap(std::span<const Term> terms, Random& random, Proposal& out) const;
  void fill(Guess& guess) const;

  MachinePrior prior_;
  SpeedGrid grid_;
  double deepest_;
  std::vector<Shape> shapes_;
  std::vector<Guess> guesses_;
  std::vector<double> weights_;
  std::vector<double> spread_;  // of the guesses, each number
  std::vector<Term> past_;      // what the weights hold
};

}  // namespace stillcut::learn
