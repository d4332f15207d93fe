#include "app/compose/known_lobes.h"

#include <numeric>
#include <utility>

#include "core/milling/linear_force.h"
#include "core/milling/material_table.h"
#include "core/milling/stability/advice.h"
#include "core/milling/stability/exact_lobes.h"

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
  milling::lineariseForLobes(model, programme.feedPerTooth);
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

Metres feedPerTooth(const config::Profile& profile, int teeth) {
  const double perSecond = toothPassing(profile.cut.nominalSpeed, teeth).value;
  return Metres(perSecond > 0.0 ? profile.cut.nominalFeed.value / perSecond : 0.0);
}

Result<milling::LobeCase> cutOfProfile(const config::Profile& profile, const std::string& modelPath,
                                       milling::ModelParts parts) {
  if (!profile.material.empty() && !parts.material) {
    const auto material = milling::materialNamed(profile.material, "cut.material");
    if (!material) return material.error();
    parts.material = material.value();
  }
  Result<milling::LobeCase> cut = milling::loadLobeCase(modelPath, parts);
  if (!cut) return cut;
  milling::Tool& tool = cut->model.tool;
  const int told = profile.pitch.empty() ? profile.cut.teeth : static_cast<int>(profile.pitch.size());
  if (told > 0 && told != tool.teeth) {
    return Error{modelPath, message("the tool has %1 teeth", std::to_string(tool.teeth)),
                 message("the profile's has %1", std::to_string(told))};
  }
  if (profile.pitch.empty()) return cut;
  tool.pitch = profile.pitch;
  const double sum = std::accumulate(profile.pitch.begin(), profile.pitch.end(), 0.0);
  for (double& angle : tool.pitch) angle *= kTwoPi / sum;
  return cut;
}

Result<std::optional<StableSpeeds>> stableSpeeds(const config::Profile& profile, const std::string& modelPath) {
  if (profile.model.empty()) return std::optional<StableSpeeds>();
  auto cut = cutOfProfile(profile, modelPath);
  if (!cut) return cut.error();
  // Which speeds are stable depends on the depth.
  if (!(profile.depth.value > 0.0)) return std::optional<StableSpeeds>();
  const auto reach = speedsInReach(profile, modelPath);
  if (!reach) return reach.error();
  if (!(profile.cut.nominalSpeed.value > 0.0) || !(reach->high > reach->low)) return std::optional<StableSpeeds>();
  milling::AdviceRequest request;
  request.depth = profile.depth;
  request.lowest = reach->low;
  request.highest = reach->high;
  if (!cut->model.tool.pitch.empty()) {
    // Every limit of unlike teeth takes some twenty times as long, and somebody waits for the run to begin. Speeds are
    // commanded in larger steps than this.
    request.steps = 48;
    request.finest = Rpm(10.0);
  }
  milling::lineariseForLobes(cut->model, feedPerTooth(profile, cut->model.tool.teeth));
  const auto advice = milling::adviseSpeeds(cut->model, request, modelPath);
  if (!advice) return advice.error();
  return std::optional(known(*advice, request.depth));
}

Result<Metres> stableDepth(const config::Profile& profile, const std::string& modelPath, Rpm speed) {
  constexpr double kSearched = 4.0;  // times the profile's depth
  if (profile.model.empty() || !(speed.value > 0.0)) return Metres();
  auto cut = cutOfProfile(profile, modelPath);
  if (!cut) return cut.error();
  milling::lineariseForLobes(cut->model, feedPerTooth(profile, cut->model.tool.teeth));
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
