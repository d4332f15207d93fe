#include "core/milling/stability/advice/recommended_cut.h"

#include <algorithm>

namespace stillcut::milling {
namespace {

// The speed may be anywhere in its range, and what lies between two speeds of the band is not known better than at
// the worse of them.
Metres lowestAround(std::span<const LimitBand> limits, Rpm speed, double doubt) {
  const Rpm from = speed * (1.0 - doubt);
  const Rpm to = speed * (1.0 + doubt);
  Metres lowest = limits.front().low;
  bool any = false;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const bool begins = i + 1 < limits.size() && limits[i].speed <= to && limits[i + 1].speed >= from;
    const bool ends = i > 0 && limits[i - 1].speed <= to && limits[i].speed >= from;
    if (!begins && !ends && !(limits[i].speed >= from && limits[i].speed <= to)) continue;
    lowest = any ? std::min(lowest, limits[i].low) : limits[i].low;
    any = true;
  }
  return lowest;
}

}  // namespace

std::optional<RecommendedCut> recommendCut(std::span<const LimitBand> limits, Metres deepest,
                                           const RecommendOptions& options) {
  if (limits.empty()) return std::nullopt;
  RecommendedCut best;
  double most = -1.0;
  Metres lowest = deepest;
  for (const LimitBand& at : limits) {
    const Metres depth = std::min(deepest, lowestAround(limits, at.speed, options.speedDoubt));
    lowest = std::min(lowest, depth);
    const double removed = depth.value * at.speed.value;
    if (removed <= most) continue;
    most = removed;
    best.speed = at.speed;
    best.depth = depth;
  }
  best.open = best.depth >= deepest;
  const double kept = 1.0 - options.margin;
  if (!best.open) best.depth = best.depth * kept;
  best.anySpeed = lowest >= deepest ? lowest : lowest * kept;
  return best;
}

}  // namespace stillcut::milling
