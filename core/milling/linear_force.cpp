#include "core/milling/linear_force.h"

#include <cmath>

namespace stillcut::milling {

Metres meanChip(const Engagement& engagement, Metres feedPerTooth) {
  const double start = engagement.startAngle(), exit = engagement.exitAngle();
  return Metres(feedPerTooth.value * (std::cos(start) - std::cos(exit)) / (exit - start));
}

Metres meanChip(const CutModel& model, Metres feedPerTooth) {
  return model.turning ? chipPerFeed(model) * feedPerTooth : meanChip(model.engagement, feedPerTooth);
}

Material linearisedAt(Material m, Metres chip) {
  if (m.exponent == 1.0) return m;
  const double slope = m.exponent * std::pow(chip.value, m.exponent - 1.0);
  m.tangential *= slope;
  m.radial *= slope;
  m.exponent = 1.0;
  m.tangentialEdge = m.radialEdge = 0.0;
  return m;
}

Metres lineariseForLobes(CutModel& model, Metres feedPerTooth) {
  if (model.tool.serration && feedPerTooth.value > 0.0) model.tool.serration->feedPerTooth = feedPerTooth;
  if (model.material.exponent == 1.0) return {};
  const Metres chip = feedPerTooth.value > 0.0 ? meanChip(model, feedPerTooth) : model.material.usualChip;
  if (chip.value > 0.0) model.material = linearisedAt(model.material, chip);
  return chip;
}

}  // namespace stillcut::milling
