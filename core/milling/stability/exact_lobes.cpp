#include "core/milling/stability/exact_lobes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/milling/stability/limit_search.h"

namespace stillcut::milling {

namespace {

constexpr double kHighestSpeed = 1e6;  // [rpm]
constexpr double kMostWaves = 1000.0;  // vibration periods of the fastest mode between two teeth

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", v);
  return text;
}

}  // namespace

const char* crossingName(CrossingKind kind) {
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
  return ExactLobes(std::move(system.value()), neglectedEffects(model));
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
  return LimitSearch(system_, speed, options, meter).run();
}

}  // namespace stillcut::milling
