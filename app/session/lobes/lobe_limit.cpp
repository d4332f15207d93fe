#include "app/session/lobes/lobe_limit.h"

namespace stillcut::app {

ui::LobeLimit lobeLimit(const milling::SpeedLimits& limits) {
  ui::LobeLimit out;
  out.speed = limits.speed;
  out.limited = limits.hasLimit();
  out.depth = limits.searchedTo;
  if (!out.limited) return out;
  const milling::StabilityLimit& first = limits.crossings.front();
  out.depth = first.depth;
  out.kind = first.kind == milling::CrossingKind::Flip ? ChatterKind::Flip : ChatterKind::Hopf;
  out.frequency = first.frequency;
  for (std::size_t k = 1; k < limits.crossings.size(); ++k) {
    if (limits.crossings[k].after != 0) continue;
    const bool last = k + 1 == limits.crossings.size();
    out.islands.push_back({limits.crossings[k].depth, last ? limits.searchedTo : limits.crossings[k + 1].depth});
  }
  return out;
}

}  // namespace stillcut::app
