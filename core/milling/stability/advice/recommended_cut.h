// One cut out of a band of stability limits: where the most is removed at a depth that stays stable in all draws.
// The removal rate goes with speed times depth at a given width and feed per tooth, so that a deep pocket at half the
// speed is no gain; and a speed at the edge of a pocket is none either: the limit of a speed is taken as the lowest
// within `speedDoubt` of it. Pure: any thread.
#pragma once

#include <optional>
#include <span>

#include "core/milling/stability/limit_band.h"

namespace stillcut::milling {

struct RecommendOptions {
  double speedDoubt = 0.015;  // fraction by which a spindle under load and an override's steps may be off by
  double margin = 0.1;        // taken off the depth besides: 10 % of what a limit computed for a linear cut misses
};

struct RecommendedCut {
  Rpm speed{};
  Metres depth{};     // with the margin
  Metres anySpeed{};  // the deepest that is stable at every speed of the range, with the margin
  bool open = false;  // `deepest` ends it, not chatter
};

// `limits` by rising speed; `deepest`: what was searched, or what the tool can cut. Empty: no limits.
std::optional<RecommendedCut> recommendCut(std::span<const LimitBand> limits, Metres deepest,
                                           const RecommendOptions& options = {});

}  // namespace stillcut::milling
