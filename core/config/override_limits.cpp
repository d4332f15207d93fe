#include "core/config/override_limits.h"

#include <numbers>
#include <string>

namespace stillcut::config {
namespace {

Error refuse(std::string_view where, const ParamDecl& key, const Message& what, const Message& why) {
  return Error{std::string(where) + ": " + std::string(key.key), what, why};
}

// The part of [low, high] in which both f and f * knob stay inside [low, high], 1 always included.
FactorRange withKnob(double low, double high, double knob) noexcept {
  if (knob <= 0.0) return {low, high};  // the operator has stopped this axis; the product is 0 whatever we do
  return {std::min(1.0, std::max(low, low / knob)), std::max(1.0, std::min(high, high / knob))};
}

// A range of 100 % alone is a machine without that override; any other range that does not extend is a mistake.
bool isEmpty(double low, double high, double whole) {
  return low > high || (low == high && low != whole);
}

}  // namespace

Result<OverrideLimits> checkOverrideLimits(const ParamSet& params, const CutSetup& setup, std::string_view where) {
  OverrideLimits limits;
  const auto share = [&](const ParamDecl& decl) { return Ratio(params.real(decl) / 100.0); };
  limits.lowestSpeed = share(kLowestSpeedOverride);
  limits.highestSpeed = share(kHighestSpeedOverride);
  limits.lowestFeed = share(kLowestFeedOverride);
  limits.highestFeed = share(kHighestFeedOverride);
  limits.feedPerTooth = share(kHighestFeedPerTooth).value;
  limits.lowestFeedPerTooth = share(kLowestFeedPerTooth).value;
  if (isEmpty(limits.lowestSpeed.value, limits.highestSpeed.value, 1.0)) {
    return refuse(where, kLowestSpeedOverride, message("the range of the speed override is empty"),
                  message("it must be below %1", kHighestSpeedOverride.key));
  }
  if (isEmpty(limits.lowestFeed.value, limits.highestFeed.value, 1.0)) {
    return refuse(where, kLowestFeedOverride, message("the range of the feed override is empty"),
                  message("it must be below %1", kHighestFeedOverride.key));
  }
  if (!params.isAutomatic(kLowestSpeed)) limits.slowest = Rpm(params.real(kLowestSpeed));
  for (const ParamDecl* decl : {&kHighestSpeed, &kToolSpeed, &kHolderSpeed}) {
    if (!params.isAutomatic(*decl)) limits.fastest = std::min(limits.fastest, Rpm(params.real(*decl)));
  }
  if (!params.isAutomatic(kLowestFeed)) limits.slowestFeed = fromMmPerMin(params.real(kLowestFeed));
  if (!params.isAutomatic(kHighestFeed)) limits.fastestFeed = fromMmPerMin(params.real(kHighestFeed));
  if (limits.slowestFeed >= limits.fastestFeed) {
    return refuse(where, kLowestFeed, message("the lowest feed is not below the highest"),
                  message("see gate.highest-feed"));
  }
  if (!params.isAutomatic(kHighestCuttingSpeed)) {
    if (!(setup.toolDiameter.value > 0.0)) {
      return refuse(where, kHighestCuttingSpeed,
                    message("a cutting speed cannot be limited without the tool's diameter"),
                    message("give the diameter or set it to auto"));
    }
    const double metresPerRev = std::numbers::pi * setup.toolDiameter.value;
    limits.fastest = std::min(limits.fastest, Rpm(params.real(kHighestCuttingSpeed) / metresPerRev));
  }
  if (limits.slowest >= limits.fastest) {
    return refuse(where, kLowestSpeed, message("the lowest speed is not below the highest"),
                  message("see gate.highest-speed, gate.tool-highest-speed, gate.holder-highest-speed and "
                          "gate.highest-cutting-speed"));
  }
  return limits;
}

Status narrowToMachine(ParamSet& params, const MachineOverrides& machine, std::string_view where) {
  const auto narrow = [&](const ParamDecl& low, const ParamDecl& high, Ratio from, Ratio to) -> Status {
    const double newLow = std::max(params.real(low), 100.0 * from.value);
    const double newHigh = std::min(params.real(high), 100.0 * to.value);
    if (isEmpty(newLow, newHigh, 100.0)) {
      return refuse(where, low, message("the machine's override cannot reach the allowed range"),
                    message("check the machine's profile"));
    }
    Status status = params.set(low, newLow, where);
    return status ? params.set(high, newHigh, where) : status;
  };
  Status status = narrow(kLowestSpeedOverride, kHighestSpeedOverride, machine.lowestSpeed, machine.highestSpeed);
  return status ? narrow(kLowestFeedOverride, kHighestFeedOverride, machine.lowestFeed, machine.highestFeed) : status;
}

FactorRange feedFactors(const OverrideLimits& limits, const MachineState& machine) STILLCUT_RT {
  FactorRange range = withKnob(limits.lowestFeed.value, limits.highestFeed.value, machine.operatorFeed.value);
  const MetresPerSecond base = machine.programmedFeed * machine.operatorFeed.value;
  if (base.value > 0.0) {
    range.low = std::min(1.0, std::max(range.low, limits.slowestFeed / base));
    range.high = std::max(1.0, std::min(range.high, limits.fastestFeed / base));
  }
  return range;
}

FactorRange speedFactors(const OverrideLimits& limits, const MachineState& machine) STILLCUT_RT {
  FactorRange range = withKnob(limits.lowestSpeed.value, limits.highestSpeed.value, machine.operatorSpeed.value);
  // Below this speed even the lowest feed would be too much for each tooth, above that one the highest too little.
  const FactorRange feed = feedFactors(limits, machine);
  range.low = std::max(range.low, std::min(1.0, feed.low / limits.feedPerTooth));
  if (limits.lowestFeedPerTooth > 0.0) {
    range.high = std::min(range.high, std::max(1.0, feed.high / limits.lowestFeedPerTooth));
  }
  const Rpm base = machine.programmedSpeed * machine.operatorSpeed.value;
  if (base.value > 0.0) {
    range.low = std::min(1.0, std::max(range.low, limits.slowest / base));
    range.high = std::max(1.0, std::min(range.high, limits.fastest / base));
  }
  return range;
}

SpeedRange reachableSpeeds(const OverrideLimits& limits, const MachineState& machine) STILLCUT_RT {
  const FactorRange range = speedFactors(limits, machine);
  const Rpm base = machine.programmedSpeed * machine.operatorSpeed.value;
  return {base * range.low, base * range.high};
}

}  // namespace stillcut::config
