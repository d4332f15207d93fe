#include "core/learn/guess_cloud.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stillcut::learn {
namespace {

constexpr int kMostSteps = 12;    // between one update and the next
constexpr double kLeaps = 0.2;    // fraction of the moves
constexpr double kLeapSd = 0.06;  // of ln f about a chatter frequency: modes lie a little below it

double effectiveShare(std::span<const double> weights) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double w : weights) {
    sum += w;
    squares += w * w;
  }
  return sum * sum / (squares * static_cast<double>(weights.size()));
}

double logMeanExp(std::span<const double> logs, std::span<const double> weights) {
  const double top = *std::ranges::max_element(logs);
  double sum = 0.0;
  for (std::size_t i = 0; i < logs.size(); ++i) sum += weights[i] * std::exp(logs[i] - top);
  return top + std::log(sum);
}

}  // namespace

GuessCloud::GuessCloud(const MachinePrior& prior, const SpeedGrid& grid, double deepest, int count, Random& random)
    : prior_(prior), grid_(grid), deepest_(deepest) {
  const auto size = static_cast<std::size_t>(count);
  guesses_.resize(size);
  weights_.assign(size, 1.0 / count);
  for (Guess& g : guesses_) {
    g.numbers.resize(static_cast<std::size_t>(prior.dimensions()));
    for (double& z : g.numbers) z = random.normal();
  }
}

double GuessCloud::effective() const {
  return effectiveShare(weights_);
}

void GuessCloud::addShape(const Shape& shape) {
  shapes_.push_back(shape);
  for (Guess& g : guesses_) {
    g.limits.emplace_back();
    fillLimits(prior_.machineAt(g.numbers), shape.force, shape.teeth, grid_, deepest_, g.limits.back());
  }
}

void GuessCloud::fill(Guess& guess) const {
  const Dynamics machine = prior_.machineAt(guess.numbers);
  guess.limits.resize(shapes_.size());
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    fillLimits(machine, shapes_[s].force, shapes_[s].teeth, grid_, deepest_, guess.limits[s]);
  }
}

double GuessCloud::logPredictive(const Term& term, const LearnParams& params) const {
  std::vector<double> logs(size());
  for (std::size_t i = 0; i < size(); ++i) {
    logs[i] = logLikelihood(term, guesses_[i].limits[term.shape], grid_, params);
  }
  return logMeanExp(logs, weights_);
}

double GuessCloud::logEvidence(std::span<const Term> terms, const LearnParams& params) const {
  std::vector<double> logs(size());
  for (std::size_t i = 0; i < size(); ++i) logs[i] = logLikelihood(terms, guesses_[i].limits, grid_, params);
  return logMeanExp(logs, std::vector<double>(size(), 1.0 / static_cast<double>(size())));
}

void GuessCloud::update(std::span<const Term> terms, const LearnParams& params, Random& random) {
  for (Guess& g : guesses_) g.now = logLikelihood(terms, g.limits, grid_, params);
  double done = 0.0;
  for (int step = 0; step < kMostSteps && done < 1.0; ++step) {
    const bool last = step + 1 == kMostSteps;
    const double by = last ? 1.0 - done : stepWithin(1.0 - done, params.leastEffective);
    reweight(by);
    done += by;
    if (done >= 1.0 - 1e-9 && effective() >= params.leastEffective) break;
    resample(random);
    for (int i = 0; i < params.moves; ++i) move({terms, done}, params, random);
  }
  for (Guess& g : guesses_) g.past = g.now;
  past_.assign(terms.begin(), terms.end());
}

double GuessCloud::effectiveAfter(double exponent) const {
  double top = -1e300;
  for (const Guess& g : guesses_) top = std::max(top, g.now - g.past);
  std::vector<double> after(size());
  for (std::size_t i = 0; i < size(); ++i) {
    after[i] = weights_[i] * std::exp(exponent * (guesses_[i].now - guesses_[i].past - top));
  }
  return effectiveShare(after);
}

// The largest part of what is left after which enough guesses still count.
double GuessCloud::stepWithin(double left, double leastEffective) const {
  if (effectiveAfter(left) >= leastEffective) return left;
  double low = 0.0;
  double high = left;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (effectiveAfter(middle) >= leastEffective ? low : high) = middle;
  }
  return high;
}

void GuessCloud::reweight(double exponent) {
  double top = -1e300;
  for (const Guess& g : guesses_) top = std::max(top, g.now - g.past);
  double sum = 0.0;
  for (std::size_t i = 0; i < size(); ++i) {
    weights_[i] *= std::exp(exponent * (guesses_[i].now - guesses_[i].past - top));
    sum += weights_[i];
  }
  for (double& w : weights_) w /= sum;
}

// Systematic: a guess with the weight of three is kept three times, within one.
void GuessCloud::resample(Random& random) {
  const double step = 1.0 / static_cast<double>(size());
  double mark = step * random.uniform();
  double reached = weights_[0];
  std::size_t from = 0;
  std::vector<Guess> kept;
  kept.reserve(size());
  for (std::size_t i = 0; i < size(); ++i, mark += step) {
    while (reached < mark && from + 1 < size()) reached += weights_[++from];
    kept.push_back(guesses_[from]);
  }
  guesses_ = std::move(kept);
  weights_.assign(size(), step);
  spread_.assign(guesses_.front().numbers.size(), 0.0);
  for (std::size_t d = 0; d < spread_.size(); ++d) {
    double mean = 0.0;
    double square = 0.0;
    for (const Guess& g : guesses_) {
      mean += step * g.numbers[d];
      square += step * g.numbers[d] * g.numbers[d];
    }
    spread_[d] = std::sqrt(std::max(1e-4, square - mean * mean));
  }
}

// Three ways to a new guess: along the difference of two others, which knows how the numbers hang together (ter Braak
// 2006); one number by its spread; one number afresh, which leaps between lobes.
void GuessCloud::propose(std::size_t i, std::span<const Term> terms, Random& random, Proposal& out) const {
  const std::vector<double>& old = guesses_[i].numbers;
  const auto dimensions = static_cast<int>(old.size());
  out.numbers = old;
  if (random.uniform() < kLeaps && leap(terms, random, out)) return;
  const double way = random.uniform();
  if (way < 0.6) {
    const auto a = static_cast<std::size_t>(random.below(static_cast<int>(size())));
    const auto b = static_cast<std::size_t>(random.below(static_cast<int>(size())));
    const double length = (way < 0.06 ? 1.0 : 2.38 / std::sqrt(2.0 * dimensions)) * random.uniform(0.4, 1.0);
    for (std::size_t d = 0; d < old.size(); ++d) {
      out.numbers[d] += length * (guesses_[a].numbers[d] - guesses_[b].numbers[d]) + 0.02 * random.normal();
    }
  } else {
    const auto d = static_cast<std::size_t>(random.below(dimensions));
    if (way > 0.85) {
      out.numbers[d] = random.normal();
      out.logPrior = 0.0;
      return;
    }
    out.numbers[d] += 1.5 * spread_[d] * random.normal();
  }
  out.logPrior = 0.0;
  for (std::size_t d = 0; d < old.size(); ++d) {
    out.logPrior += 0.5 * (old[d] * old[d] - out.numbers[d] * out.numbers[d]);
  }
}

// A mode is put next to a chatter frequency that was measured: where little is known few guesses begin there, and none
// would find it by small steps. The number that all modes share is drawn afresh about that place, whatever it was.
bool GuessCloud::leap(std::span<const Term> terms, Random& random, Proposal& out) const {
  const auto& heard = terms[static_cast<std::size_t>(random.below(static_cast<int>(terms.size())))];
  const double spread = prior_.shared.frequency;
  if (!(heard.frequency > 0.0) || !(spread > kLeapSd)) return false;
  const auto mode = static_cast<std::size_t>(random.below(static_cast<int>(prior_.modes.size())));
  const PriorMode& median = prior_.modes[mode];
  const double own = std::log(median.median.frequency.value) + median.own.frequency * out.numbers[5 + 3 * mode];
  const double centre = (std::log(heard.frequency) - own) / spread;
  double& shared = out.numbers[2];
  const double before = shared;
  shared = centre + kLeapSd / spread * random.normal();
  const auto away = [&](double z) {
    const double x = (z - centre) * spread / kLeapSd;
    return 0.5 * x * x;
  };
  out.logPrior = 0.5 * (before * before - shared * shared) + away(shared) - away(before);
  return true;
}

void GuessCloud::move(const Target& target, const LearnParams& params, Random& random) {
  Proposal proposal;
  Guess next;
  for (std::size_t i = 0; i < size(); ++i) {
    propose(i, target.terms, random, proposal);
    const double chance = std::log(random.uniform());
    next.numbers = proposal.numbers;
    fill(next);
    next.now = logLikelihood(target.terms, next.limits, grid_, params);
    next.past = logLikelihood(past_, next.limits, grid_, params);
    const Guess& old = guesses_[i];
    const double gain =
        proposal.logPrior + target.exponent * (next.now - old.now) + (1.0 - target.exponent) * (next.past - old.past);
    if (chance < gain) std::swap(guesses_[i], next);
  }
}

}  // namespace stillcut::learn
