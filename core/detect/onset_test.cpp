#include "core/detect/onset_test.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kMemoryTurns = 40.0;
constexpr double kFallTurns = 10.0;     // a falling floor is followed at once: growth is measured from the lowest calm
constexpr double kDrift = 3.0;          // scatters a stable cut may lie above its own mean
constexpr double kLeastScatter = 0.25;  // 1 dB: a short, lucky stretch must not make the test nervous
constexpr double kMostLearned = 1.0;    // scatters by which one value may pull the mean up
constexpr double kLeastGrowth = 1.386;  // nepers: twice the amplitude, or it is not worth the word
constexpr double kCalm = 3.0;           // scatters below which an alarm starts to clear
constexpr double kCalmTurns = 2.0;
constexpr double kMostEvidence = 20.0;

}  // namespace

void OnsetTest::reset() noexcept {
  mean_ = variance_ = learnedTurns_ = evidence_ = calmTurns_ = 0.0;
  alarm_ = false;
}

double OnsetTest::floor() const noexcept {
  return std::exp(mean_);
}

double OnsetTest::scatter() const noexcept {
  return std::max(std::sqrt(variance_), kLeastScatter);
}

void OnsetTest::update(double ratio, double turns, bool learn) noexcept {
  const double u = std::log(std::max(ratio, 1e-12));
  if (!learned()) {
    if (learn) follow(u, turns);
    return;
  }
  const double z = (u - mean_) / scatter();
  const double excess = ratio >= limits_.smallestRatio ? z - kDrift : -kDrift;
  evidence_ = std::clamp(evidence_ + excess * turns, 0.0, kMostEvidence);
  if (evidence_ > limits_.evidence && u - mean_ > kLeastGrowth) {
    alarm_ = true;
    calmTurns_ = 0.0;
  }
  if (alarm_) {
    calmTurns_ = z < kCalm || ratio < limits_.smallestRatio ? calmTurns_ + turns : 0.0;
    if (calmTurns_ > kCalmTurns) {
      alarm_ = false;
      evidence_ = 0.0;
    }
    return;
  }
  if (learn) follow(u, turns);
}

void OnsetTest::follow(double u, double turns) noexcept {
  const bool first = learnedTurns_ == 0.0;
  const bool known = learned();
  learnedTurns_ += turns;
  if (first) mean_ = u;
  const double error = known ? std::min(u - mean_, kMostLearned * scatter()) : u - mean_;
  const double memory = error < 0.0 ? kFallTurns : kMemoryTurns;
  const double rate = turns / std::min(learnedTurns_, memory);
  mean_ += rate * error;
  variance_ += turns / std::min(learnedTurns_, kMemoryTurns) * (error * error - variance_);
}

}  // namespace stillcut::detect
