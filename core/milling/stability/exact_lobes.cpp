#include "core/milling/stability/exact_lobes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/milling/stability/any_tool/alike_teeth.h"
#include "core/milling/stability/any_tool/depth_search.h"
#include "core/milling/stability/any_tool/shaped_teeth.h"
#include "core/milling/stability/any_tool/unlike_teeth.h"
#include "core/milling/stability/limit_search.h"

namespace stillcut::milling {

namespace {

constexpr double kHighestSpeed = 1e6;  // [rpm]
constexpr int kMostLines = 140;        // of the harmonics of a shaped tool
constexpr double kMostWaves = 1000.0;  // vibration periods of the fastest mode between two teeth

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", v);
  return text;
}

// f of a serrated tool has a kink wherever another tooth begins to cut, and no series: the multipliers outside are
// counted at even steps of depth, and the step with the first one is halved. The count takes the rough lines: half a
// percent. An island thinner than a step is not seen, so that nothing here is verified.
SpeedLimits serratedLimits(const ShapedTeeth& teeth, Rpm speed, const LimitOptions& options, WorkMeter& meter) {
  constexpr int kSteps = 60;
  SpeedLimits limits;
  limits.speed = speed;
  double low = 0.0, high = 0.0;
  for (int i = 1; i <= kSteps; ++i) {
    const double depth = options.maxAxialDepth.value * i / kSteps;
    const std::optional<int> outside = teeth.outside(depth, meter);
    if (meter.stopped()) return limits;
    if (outside.value_or(1) > 0) {
      high = depth;
      break;
    }
    low = depth;
    limits.searchedTo = i == kSteps ? options.maxAxialDepth : Metres(depth);
  }
  if (high == 0.0) return limits;
  int after = 2;
  while (high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    const int outside = teeth.outside(middle, meter).value_or(1);
    if (meter.stopped()) return limits;
    (outside > 0 ? high : low) = middle;
    if (outside > 0) after = outside;
  }
  const double angle = teeth.closestAngle(high, meter);
  StabilityLimit limit{speed, 0, Metres(high), 0, after, CrossingKind::Hopf, Radians(angle), {}};
  if (after == 1) limit.kind = angle > 0.25 * kTwoPi ? CrossingKind::Flip : CrossingKind::Fold;
  if (options.frequencies) limit.frequency = teeth.chatterFrequency(angle, high, meter);
  limits.crossings.push_back(limit);
  limits.searchedTo = limit.depth;
  return limits;
}

// The search goes along the edge.
SpeedLimits shapedLimits(const ShapedTeeth& teeth, const Tool& tool, Rpm speed, LimitOptions options,
                         WorkMeter& meter) {
  const Metres deepest = options.maxAxialDepth;
  for (Metres* depth : {&options.maxAxialDepth, &options.hint}) *depth = Metres(edgeLengthBelow(tool, depth->value));
  SpeedLimits limits =
      tool.serration ? serratedLimits(teeth, speed, options, meter) : DepthSearch(teeth, speed, options, meter).run();
  const bool all = limits.searchedTo >= options.maxAxialDepth;
  limits.searchedTo = all ? deepest : Metres(depthOfLength(tool, limits.searchedTo.value));
  for (StabilityLimit& l : limits.crossings) l.depth = Metres(depthOfLength(tool, l.depth.value));
  return limits;
}

}  // namespace

const char* crossingName(CrossingKind kind) {
  if (kind == CrossingKind::Fold) return "fold";
  return kind == CrossingKind::Flip ? "flip" : "hopf";
}

int SpeedLimits::outsideAt(Metres depth) const {
  int outside = 0;
  for (const StabilityLimit& l : crossings) {
    if (l.depth > depth) break;
    outside = l.after;
  }
  return outside;
}

Result<ExactLobes> ExactLobes::make(const CutModel& model, const std::string& where) {
  Result<RegenerativeSystem> system = makeRegenerativeSystem(model, where);
  if (!system) return system.error();
  if (model.tool.serration && !(model.tool.serration->feedPerTooth.value > 0.0)) {
    return Error{where + ": tool", message("which teeth of a serrated tool cut depends on the feed"),
                 message("give the feed per tooth")};
  }
  return ExactLobes(model, std::move(system.value()));
}

Status ExactLobes::checkSpeed(Rpm speed) const {
  if (!isFinite(speed) || !(speed.value > 0.0) || speed.value > kHighestSpeed) {
    return Error{message("spindle speed"), message("%1 rpm is no speed", number(speed.value)),
                 message("above 0 and up to 1e6 rpm")};
  }
  const double waves = system_.highestOmega() / kTwoPi * system_.toothPeriod(speed);
  if (waves > kMostWaves) {
    return Error{message("spindle speed"), message("%1 rpm is too low for these modes", number(speed.value)),
                 message("the fastest mode swings %1 times between two teeth", number(std::round(waves)))};
  }
  return Done{};
}

Status ExactLobes::checkPattern(Rpm speed, Metres largest) const {
  if (!(largest < pattern_.meeting())) {
    return Error{message("tool"),
                 message("the edges of two teeth meet at %1 mm", number(1e3 * pattern_.meeting().value)),
                 message("take a smaller depth or other helix angles")};
  }
  if (!possible(speed)) {
    return Error{message("spindle speed"),
                 message("%1 rpm is too low for teeth that differ or have a shape", number(speed.value)),
                 message("from %1 rpm on it is possible", number(lowestSpeed().value))};
  }
  return Done{};
}

bool ExactLobes::possible(Rpm speed) const {
  if (changesWithSpeed(model_)) return ExactLobes(modelAt(model_, speed), system_).possible(speed);
  if (isShaped(model_.tool)) return ShapedTeeth(model_, pattern_, speed).lines(Fineness::Rough) <= kMostLines;
  return pattern_.alike || UnlikeTeeth::possible(model_, pattern_, speed);
}

Rpm ExactLobes::lowestSpeed() const {
  if (pattern_.alike && !isShaped(model_.tool)) return {};
  Rpm low(1.0), high(kHighestSpeed);
  while (high / low > 1.0005) {
    const Rpm middle(std::sqrt(low.value * high.value));
    (possible(middle) ? high : low) = middle;
  }
  return Rpm(std::ceil(high.value));
}

Status ExactLobes::checkDepth(Metres largest) {
  if (isFinite(largest) && largest.value > 0.0 && largest.value <= 1.0) return Done{};
  return Error{message("largest depth"), message("%1 mm is no depth", number(1e3 * largest.value)),
               message("above 0 and up to 1000 mm")};
}

Result<SpeedLimits> ExactLobes::limits(Rpm speed, const LimitOptions& options, const std::stop_token& stop) const {
  WorkMeter meter(stop);
  return limits(speed, options, meter);
}

Result<SpeedLimits> ExactLobes::limits(Rpm speed, const LimitOptions& options, WorkMeter& meter) const {
  if (Status ok = checkSpeed(speed); !ok) return ok.error();
  if (Status ok = checkDepth(options.maxAxialDepth); !ok) return ok.error();
  if (changesWithSpeed(model_)) {
    const CutModel here = modelAt(model_, speed);
    return ExactLobes(here, systemAt(here, Metres(0.0))).limits(speed, options, meter);
  }
  if (isShaped(model_.tool)) {
    if (Status ok = checkPattern(speed, options.maxAxialDepth); !ok) return ok.error();
    return shapedLimits(ShapedTeeth(model_, pattern_, speed), model_.tool, speed, options, meter);
  }
  if (pattern_.alike && pattern_.straight && model_.material.processDamping == 0.0) {
    return LimitSearch(system_, speed, options, meter).run();
  }
  if (pattern_.alike) return DepthSearch(AlikeTeeth(model_, speed), speed, options, meter).run();
  if (Status ok = checkPattern(speed, options.maxAxialDepth); !ok) return ok.error();
  return DepthSearch(UnlikeTeeth(model_, pattern_, speed), speed, options, meter).run();
}

}  // namespace stillcut::milling
