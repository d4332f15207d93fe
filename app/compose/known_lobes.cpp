#include "app/compose/known_lobes.h"

#include "core/milling/stability/advice.h"

namespace stillcut::app {

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
  StableSpeeds known;
  known.depth = request.depth;
  for (const milling::SpeedPocket& pocket : advice->pockets) {
    known.ranges.push_back({pocket.from.speed, pocket.to.speed, pocket.best});
  }
  if (advice->deepest) {
    known.deepestSpeed = advice->deepest->speed;
    known.deepestDepth = advice->deepest->depth;
  }
  return known;
}

}  // namespace stillcut::app
