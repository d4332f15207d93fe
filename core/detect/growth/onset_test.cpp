#include "core/detect/growth/onset_test.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kMemoryTurns = 40.0;  // at least
constexpr Seconds kMemory{1.0};
constexpr double kShortTurns = 10.0;  // a floor that falls is followed this fast
constexpr double kPriorTurns = 4.0;   // weight of "k = 1" before anything is learned
constexpr double kMostShape = 16.0;   // 1 dB of scatter: a lucky stretch must not make the test nervous
constexpr double kMostCorrelation = 4.0;
constexpr double kSure = 2.0;       // standard deviations of a learned mean
constexpr double kOrdinary = 2.0;   // ... of single turns, to which one may pull the mean up, plus 1 / k for the skew
constexpr double kCutOff = 0.3;     // relative loss of variance by that, at k = 1
constexpr double kFallen = 3.0;     // standard deviations by which a short mean must lie below to take its place
constexpr double kCalmScale = 3.0;  // standard deviations above the mean below which an alarm starts to clear
constexpr double kCalmTurns = 2.0;
constexpr double kMostEvidence = 5.0;  // times the limit
constexpr double kMostRaised = 100.0;

}  // namespace

void OnsetTest::reset() {
  mean_ = meanEnergy_ = shortMean_ = learnedTurns_ = evidence_ = calmTurns_ = 0.0;
  variance_ = raised_ = 1.0;
  shortVariance_ = 0.0;
  alarm_ = standsOut_ = false;
}

double OnsetTest::raise(double factor) {
  if (learnedTurns_ == 0.0) return factor;
  const double by = std::min(factor, kMostRaised / raised_);
  raised_ *= by;
  mean_ *= by;
  shortMean_ *= by;
  meanEnergy_ *= by;
  return by;
}

void OnsetTest::setSpindle(Hertz spindle) {
  memoryTurns_ = std::max(kMemoryTurns, kMemory.value * spindle.value);
}

double OnsetTest::shape() const {
  const double variance = variance_ * (1.0 + kCutOff * std::min(variance_, 1.0));
  return std::clamp(1.0 / std::max(variance, 1e-6), 0.5, kMostShape);
}

// The mean over kShortTurns of a process with the integral correlation time c has the variance c / (2 kShortTurns).
double OnsetTest::correlation() const {
  return std::clamp(2.0 * kShortTurns * shortVariance_ * shape(), 1.0, kMostCorrelation);
}

// Relative standard deviation of a mean over so many turns.
double OnsetTest::doubt(double turns) const {
  return std::sqrt(correlation() / (shape() * std::max(turns, 1.0)));
}

void OnsetTest::update(double ratio, double turns, bool learn, double energy, std::optional<double> newest) {
  if (!learned()) {
    if (learn) follow(ratio, turns, energy);
    return;
  }
  const double k = shape();
  // Where the vibration has become less, what does not repeat is compared with what it was: a tool that leaves raises
  // their ratio without anything growing.
  const bool compare = energy > 0.0 && meanEnergy_ > 0.0;
  const double held = compare ? std::min(ratio, energy / meanEnergy_ * mean_) : ratio;
  const double x = held / std::max(mean_ * (1.0 + kSure * doubt(learnedTurns_)), 1e-30);
  const double now = newest && ratio > 0.0 ? x * *newest / ratio : x;
  const double seen = held >= limits_.smallestRatio ? now : 0.0;
  const double score = k * (seen * (1.0 - 1.0 / kGrowth) - std::log(kGrowth));
  evidence_ = std::clamp(evidence_ + score * turns / correlation(), 0.0, kMostEvidence * limits_.evidence);
  standsOut_ = held > kGrowth * mean_;
  if (evidence_ > limits_.evidence && standsOut_) {
    alarm_ = true;
    calmTurns_ = 0.0;
  }
  if (alarm_) {
    const bool calm = x < 1.0 + kCalmScale / std::sqrt(k) || ratio < limits_.smallestRatio;
    calmTurns_ = calm ? calmTurns_ + turns : 0.0;
    if (calmTurns_ > kCalmTurns) {
      alarm_ = false;
      evidence_ = 0.0;
    }
    return;
  }
  if (learn) follow(ratio, turns, energy);
}

void OnsetTest::follow(double ratio, double turns, double energy) {
  if (learnedTurns_ == 0.0) {
    mean_ = shortMean_ = ratio;
    meanEnergy_ = energy;
  }
  const bool known = learned();
  learnedTurns_ = std::min(learnedTurns_ + turns, memoryTurns_);
  const double most = mean_ * (1.0 + kOrdinary / std::sqrt(shape()) + 1.0 / shape());
  const double r = known ? std::min(ratio, most) : ratio;
  shortMean_ += turns / std::min(learnedTurns_, kShortTurns) * (r - shortMean_);
  mean_ += turns / learnedTurns_ * (r - mean_);
  raised_ += turns / learnedTurns_ * (1.0 - raised_);
  meanEnergy_ += turns / learnedTurns_ * ((ratio > 0.0 ? energy * r / ratio : 0.0) - meanEnergy_);
  if (!(mean_ > 0.0)) return;
  const double error = r / mean_ - 1.0;
  const double shortError = shortMean_ / mean_ - 1.0;
  const double rate = turns / std::min(learnedTurns_ + kPriorTurns, memoryTurns_);
  variance_ += rate * (error * error - variance_);
  shortVariance_ += rate * (shortError * shortError - shortVariance_);
  if (known && shortMean_ * (1.0 + kFallen * doubt(kShortTurns)) < mean_) {
    mean_ = shortMean_;
    learnedTurns_ = kShortTurns;
    raised_ = 1.0;
  }
}

}  // namespace stillcut::detect
