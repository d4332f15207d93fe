#include "app/compose/known_lobes.h"

#include <utility>

#include "core/milling/stability/advice.h"
#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/lobe_case.h"

namespace stillcut::app {
namespace {

StableSpeeds known(const milling::SpeedAdvice& advice, Metres depth) {
  StableSpeeds speeds;
  speeds.depth = depth;
  for (const milling::SpeedPocket& pocket : advice.pockets) {
    speeds.ranges.push_back({pocket.from.speed, pocket.to.speed, pocket.best});
  }
  if (advice.deepest) {
    speeds.largestDepthSpeed = advice.deepest->speed;
    speeds.largestStableDepth = advice.deepest->depth;
  }
  return speeds;
}

}  // namespace

std::optional<StableSpeeds> stableSpeeds(const milling::Scenario& scenario) {
  const milling::Programme& programme = scenario.programme;
  milling::CutModel model = scenario.model;
  model.engagement.radialImmersion = programme.immersion.highest(model.engagement.radialImmersion);
  milling::AdviceRequest request;
  request.depth = Metres(programme.depth.highest(0.0));
  request.lowest = programme.speed * scenario.overrides.lowestSpeed.value;
  request.highest = programme.speed * scenario.overrides.highestSpeed.value;
  request.feedPerTooth = programme.feedPerTooth;
  if (!(request.depth.value > 0.0) || !(request.highest > request.lowest)) return std::nullopt;
  const auto advice = milling::adviseSpeeds(model, request, scenario.name);
  if (!advice || !advice->finished) return std::nullopt;
  return known(*advice, request.depth);
}

Result<std::optional<StableSpeeds>> stableSpeeds(const config::Profile& profile, const std::string& modelPath) {
  if (profile.model.empty()) return std::optional<StableSpeeds>();
  const auto cut = milling::loadLobeCase(modelPath);
  if (!cut) return cut.error();
  if (profile.cut.teeth > 0 && profile.cut.teeth != cut->model.tool.teeth) {
    return Error{modelPath, message("the tool has %1 teeth", std::to_string(cut->model.tool.teeth)),
                 message("the profile's has %1", std::to_string(profile.cut.teeth))};
  }
  // Which speeds are stable depends on the depth, and no method here knows those of an uneven pitch.
  if (!(profile.depth.value > 0.0) || !profile.pitch.empty()) return std::optional<StableSpeeds>();
  const auto reach = speedsInReach(profile, modelPath);
  if (!reach) return reach.error();
  if (!(profile.cut.nominalSpeed.value > 0.0) || !(reach->high > reach->low)) return std::optional<StableSpeeds>();
  milling::AdviceRequest request;
  request.depth = profile.depth;
  request.lowest = reach->low;
  request.highest = reach->high;
  const auto advice = milling::adviseSpeeds(cut->model, request, modelPath);
  if (!advice) return advice.error();
  return std::optional(known(*advice, request.depth));
}

Result<Metres> stableDepth(const config::Profile& profile, const std::string& modelPath, Rpm speed) {
  constexpr double kSearched = 4.0;  // times the profile's depth
  if (profile.model.empty() || !profile.pitch.empty() || !(speed.value > 0.0)) return Metres();
  const auto cut = milling::loadLobeCase(modelPath);
  if (!cut) return cut.error();
  const auto lobes = milling::ExactLobes::make(cut->model, modelPath);
  if (!lobes) return lobes.error();
  milling::LimitOptions options;
  options.maxAxialDepth = profile.depth.value > 0.0 ? profile.depth * kSearched : cut->maxAxialDepth;
  options.firstOnly = true;
  options.frequencies = false;
  const auto limits = lobes->limits(speed, options);
  if (!limits) return limits.error();
  return limits->hasLimit() ? limits->crossings.front().depth : Metres();
}

Result<config::SpeedRange> speedsInReach(const config::Profile& profile, const std::string& where) {
  const auto limits = config::checkOverrideLimits(profile.params, profile.cut, where);
  if (!limits) return limits.error();
  MachineState programmed;
  programmed.programmedSpeed = profile.cut.nominalSpeed;
  programmed.programmedFeed = profile.cut.nominalFeed;
  return config::reachableSpeeds(*limits, programmed);
}

}  // namespace stillcut::app
