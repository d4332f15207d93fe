#include "core/learn/stability_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stillcut::learn {
namespace {

constexpr double kBinWidth = 0.03;  // of ln depth

std::vector<Rpm> speedsOf(const MapRequest& request) {
  std::vector<Rpm> speeds;
  const double step = (request.highest - request.lowest).value / std::max(1, request.speeds - 1);
  for (int i = 0; i < request.speeds; ++i) speeds.emplace_back(request.lowest.value + step * i);
  return speeds;
}

}  // namespace

LimitDistribution::LimitDistribution(double logDeepest)
    : logHighest_(logDeepest),
      logLowest_(logDeepest - kBinWidth * (kBins - 1)),
      mass_(kBins, 0.0),
      below_(kBins, 0.0) {}

void LimitDistribution::clear() {
  std::ranges::fill(mass_, 0.0);
}

void LimitDistribution::add(double logLimit, double weight) {
  const double place = std::clamp((logLimit - logLowest_) / kBinWidth, 0.0, kBins - 1.0);
  mass_[static_cast<std::size_t>(place + 0.5)] += weight;
}

void LimitDistribution::finish(double sd) {
  const int reach = std::max(1, static_cast<int>(3.0 * sd / kBinWidth));
  std::vector<double> kernel(static_cast<std::size_t>(2 * reach + 1));
  double sum = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double z = k * kBinWidth / sd;
    sum += kernel[static_cast<std::size_t>(k + reach)] = std::exp(-0.5 * z * z);
  }
  std::vector<double> soft(mass_.size(), 0.0);
  // What has no limit down to the deepest stays there.
  soft.back() = mass_.back();
  for (int i = 0; i + 1 < kBins; ++i) {
    const double mass = mass_[static_cast<std::size_t>(i)];
    if (mass == 0.0) continue;
    for (int k = -reach; k <= reach; ++k) {
      const int to = std::clamp(i + k, 0, kBins - 1);
      soft[static_cast<std::size_t>(to)] += mass * kernel[static_cast<std::size_t>(k + reach)] / sum;
    }
  }
  double total = 0.0;
  for (const double m : soft) total += m;
  double reached = 0.0;
  for (std::size_t i = 0; i < soft.size(); ++i) {
    reached += soft[i];
    below_[i] = total > 0.0 ? reached / total : 0.0;
  }
}

double LimitDistribution::stableAt(double logDepth) const {
  // below_[i] counts what lies up to the middle between bin i and the next.
  const double place = (logDepth - logLowest_) / kBinWidth - 0.5;
  if (place <= 0.0) return 1.0;
  if (place >= kBins - 2.0) return 1.0 - below_[kBins - 2];
  const auto i = static_cast<std::size_t>(place);
  return 1.0 - (below_[i] + (place - static_cast<double>(i)) * (below_[i + 1] - below_[i]));
}

double LimitDistribution::depthAtRisk(double risk) const {
  const auto at = std::ranges::lower_bound(below_, risk);
  const auto i = static_cast<double>(at - below_.begin());
  if (i >= kBins - 1.0) return std::exp(logHighest_);
  const double before = i > 0.0 ? below_[static_cast<std::size_t>(i) - 1] : 0.0;
  const double share = (risk - before) / std::max(1e-12, *at - before);
  return std::exp(std::min(logHighest_, logLowest_ + kBinWidth * (i - 0.5 + share)));
}

LimitDistribution limitDistribution(LobePosterior& posterior, std::size_t shape, Rpm speed) {
  const GuessCloud& guesses = posterior.guesses();
  const LearnParams& params = posterior.params();
  LimitDistribution limit(std::log(posterior.range().deepest.value));
  const double step = std::numbers::sqrt3 * params.speedSd;
  const std::array<double, 3> at{speed.value * (1.0 - step), speed.value, speed.value * (1.0 + step)};
  constexpr std::array<double, 3> kShare{1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    const double weight = guesses.weights()[i];
    for (std::size_t k = 0; k < at.size(); ++k) {
      limit.add(limitAt(guesses[i].limits[shape], posterior.grid(), at[k]).logDepth, weight * kShare[k]);
    }
  }
  limit.finish(posterior.shape(shape).marginSd);
  return limit;
}

StabilityMap stabilityMap(LobePosterior& posterior, const MapRequest& request) {
  const std::size_t shape = posterior.shapeOf(request.engagement, request.teeth);
  StabilityMap map;
  map.speeds = speedsOf(request);
  for (int i = 1; i <= request.depths; ++i)
    map.depths.push_back(request.deepest * (static_cast<double>(i) / request.depths));
  map.probability.reserve(map.speeds.size() * map.depths.size());
  for (const Rpm speed : map.speeds) {
    const LimitDistribution limit = limitDistribution(posterior, shape, speed);
    for (const Metres depth : map.depths) {
      map.probability.push_back(static_cast<float>(limit.stableAt(std::log(depth.value))));
    }
  }
  return map;
}

LimitQuantiles limitQuantiles(LobePosterior& posterior, const MapRequest& request, double risk) {
  const std::size_t shape = posterior.shapeOf(request.engagement, request.teeth);
  LimitQuantiles q;
  q.speeds = speedsOf(request);
  for (const Rpm speed : q.speeds) {
    const LimitDistribution limit = limitDistribution(posterior, shape, speed);
    q.low.emplace_back(limit.depthAtRisk(0.1));
    q.median.emplace_back(limit.depthAtRisk(0.5));
    q.high.emplace_back(limit.depthAtRisk(0.9));
    q.atRisk.emplace_back(limit.depthAtRisk(risk));
  }
  return q;
}

LearnedAdvice learnedAdvice(LobePosterior& posterior, const MapRequest& request, double risk) {
  const std::size_t shape = posterior.shapeOf(request.engagement, request.teeth);
  LearnedAdvice best;
  for (const Rpm speed : speedsOf(request)) {
    const LimitDistribution limit = limitDistribution(posterior, shape, speed);
    const Metres depth = std::min(Metres(limit.depthAtRisk(risk)), request.deepest);
    const double removal = depth.value * speed.value;
    if (removal <= best.removal) continue;
    best = {speed, depth, limit.stableAt(std::log(depth.value)), removal};
  }
  return best;
}

}  // namespace stillcut::learn
