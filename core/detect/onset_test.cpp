#include "core/detect/onset_test.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kMemoryTurns = 40.0;
constexpr double kDrift = 4.0;          // scatters a stable cut may lie above its own mean
constexpr double kLeastScatter = 0.35;  // 1.5 dB: a short, lucky stretch must not make the test nervous
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
    if (!learn) return;
    learnedTurns_ += turns;
    const double rate = std::min(1.0, turns / learnedTurns_);
    const double error = u - mean_;
    mean_ += rate * error;
    variance_ += rate * ((1.0 - rate) * error * error - variance_);
    return;
  }
  const double z = (u - mean_) / scatter();
  const double excess = ratio >= limits_.smallestRatio ? z - kDrift : -kDrift;
  evidence_ = std::clamp(evidence_ + excess * turns, 0.0, kMostEvidence);
  if (evidence_ > limits_.evidence) {
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
  if (!learn || evidence_ > 0.0) return;
  learnedTurns_ += turns;
  const double rate = turns / std::min(learnedTurns_, kMemoryTurns);
  const double error = u - mean_;
  mean_ += rate * error;
  variance_ += rate * ((1.0 - rate) * error * error - variance_);
}

}  // namespace stillcut::detect
