#include "core/milling/stability/lobe_refine.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillcut::milling {

namespace {

constexpr double kWaveStep = 0.1;  // waves of the fastest mode between two teeth from one speed to the next
constexpr std::size_t kMostSteps = 5000;

class Refiner {
 public:
  Refiner(LobeSweep sweep, const RefineOptions& options) : sweep_(std::move(sweep)), options_(options) {
    // At first nobody knows of any stretch that it is straight.
    bent_.assign(sweep_.speeds.size(), 1);
  }

  // The middles of all stretches that need one.
  std::vector<Rpm> wanted() {
    parents_.clear();
    std::vector<Rpm> middles;
    for (std::size_t i = 0; i + 1 < sweep_.speeds.size(); ++i) {
      if (sweep_.speeds.size() + middles.size() >= options_.mostSpeeds) break;
      if (!needed(i)) continue;
      parents_.push_back(i);
      middles.push_back(0.5 * (sweep_.speeds[i].speed + sweep_.speeds[i + 1].speed));
    }
    return middles;
  }

  void take(const std::vector<SpeedLimits>& middles) {
    std::vector<SpeedLimits> speeds;
    std::vector<char> bent;
    std::size_t next = 0;
    for (std::size_t i = 0; i < sweep_.speeds.size(); ++i) {
      speeds.push_back(sweep_.speeds[i]);
      if (next >= parents_.size() || parents_[next] != i) {
        bent.push_back(bent_[i]);
        continue;
      }
      const SpeedLimits& middle = middles[next++];
      const double a = limitingDepth(sweep_.speeds[i]).value, b = limitingDepth(sweep_.speeds[i + 1]).value,
                   m = limitingDepth(middle).value;
      // Where two lobes cross beside the middle, the line is off by more there.
      const bool still = std::abs(m - 0.5 * (a + b)) > 0.5 * options_.depthError * m;
      bent.push_back(still ? 1 : 0);
      speeds.push_back(middle);
      bent.push_back(still ? 1 : 0);
    }
    sweep_.speeds = std::move(speeds);
    bent_ = std::move(bent);
  }

  LobeSweep result() { return std::move(sweep_); }

 private:
  bool needed(std::size_t i) const {
    const SpeedLimits &a = sweep_.speeds[i], &b = sweep_.speeds[i + 1];
    const bool inside = b.speed > options_.from && a.speed < options_.to;
    if (!inside || (b.speed - a.speed) <= options_.finest) return false;
    const Metres depth = options_.edgesAt;
    const bool edge = depth.value > 0.0 && (limitingDepth(a) > depth) != (limitingDepth(b) > depth);
    return edge || bent_[i] != 0;
  }

  LobeSweep sweep_;
  RefineOptions options_;
  std::vector<char> bent_;  // of the stretch after each speed
  std::vector<std::size_t> parents_;
};

}  // namespace

Metres limitingDepth(const SpeedLimits& limits) {
  return limits.hasLimit() ? limits.crossings.front().depth : limits.searchedTo;
}

Result<LobeSweep> refineLobes(LobeSweep sweep, const CutModel& model, const SweepOptions& options,
                              const RefineOptions& refine, const std::string& where, const std::stop_token& stop) {
  if (!sweep.finished) return sweep;
  Refiner refiner(std::move(sweep), refine);
  bool finished = true;
  for (std::vector<Rpm> middles = refiner.wanted(); finished && !middles.empty(); middles = refiner.wanted()) {
    const Result<LobeSweep> more = sweepLobes(model, middles, options, where, stop);
    if (!more) return more.error();
    finished = more->finished;
    if (finished) refiner.take(more->speeds);
  }
  LobeSweep result = refiner.result();
  result.finished = finished;
  return result;
}

std::vector<Rpm> speedsAcross(const CutModel& model, Rpm lowest, Rpm highest, int steps) {
  const Rpm even = (highest - lowest) / static_cast<double>(std::max(steps, 1));
  std::vector<Rpm> speeds{lowest};
  while (speeds.back() < highest && speeds.size() < kMostSteps) {
    const Rpm at = speeds.back();
    const double waves = wavesBetweenTeeth(model, at);
    speeds.push_back(std::min(highest, at + std::min(even, at * (kWaveStep / std::max(waves, kWaveStep)))));
  }
  return speeds;
}

}  // namespace stillcut::milling
