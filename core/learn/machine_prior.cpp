#include "core/learn/machine_prior.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/milling/linear_force.h"
#include "core/milling/material_table.h"

namespace stillcut::learn {
namespace {

MachinePrior around(std::span<const PriorMode> modes, const milling::Material& material, const ModeSpread& more) {
  MachinePrior prior;
  for (const PriorMode& m : modes) {
    prior.modes.push_back({m.median,
                           {std::hypot(m.own.frequency, more.frequency), std::hypot(m.own.damping, more.damping),
                            std::hypot(m.own.stiffness, more.stiffness)}});
  }
  prior.tangential = material.tangential;
  prior.radialRatio = material.radial / material.tangential;
  return prior;
}

}  // namespace

Dynamics MachinePrior::machineAt(std::span<const double> guess) const {
  Dynamics machine;
  machine.tangential = tangential * std::exp(tangentialSpread * guess[0]);
  machine.radialRatio = radialRatio * std::exp(radialRatioSpread * guess[1]);
  const double frequency = std::exp(shared.frequency * guess[2]);
  const double damping = std::exp(shared.damping * guess[3]);
  const double stiffness = std::exp(shared.stiffness * guess[4]);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const std::span<const double> g = guess.subspan(5 + 3 * i, 3);
    milling::Mode mode = modes[i].median;
    mode.frequency *= frequency * std::exp(modes[i].own.frequency * g[0]);
    mode.damping = std::min(0.5, mode.damping * damping * std::exp(modes[i].own.damping * g[1]));
    mode.stiffness *= stiffness * std::exp(modes[i].own.stiffness * g[2]);
    machine.modes.push_back(mode);
  }
  return machine;
}

// Tips of end mills in machining centres lie between some 400 Hz (long tools, spindle modes) and 3 kHz (short ones), at
// 5 to 80 N/um for 12 mm, damped by 1 to 7 % (Altintas, ch. 3; Schmitz and Smith, ch. 9; Ford 2013 table 1).
MachinePrior priorOfTool(Metres diameter, std::string_view material) {
  const milling::TableMaterial* known = milling::findMaterial(material);
  if (known == nullptr) known = milling::findMaterial("aluminium");
  const milling::Material guess = milling::linearisedAt(known->material, known->material.usualChip);
  const double size = diameter.value > 0.0 ? diameter.value / 0.012 : 1.0;
  MachinePrior prior;
  milling::Mode mode;
  mode.frequency = Hertz(1100.0 * std::pow(size, -0.4));
  mode.damping = 0.03;
  mode.stiffness = 2.0e7 * size;
  for (int axis = 0; axis < 2; ++axis) {
    mode.direction = {axis == 0 ? 1.0 : 0.0, axis == 0 ? 0.0 : 1.0};
    prior.modes.push_back({mode, {0.12, 0.35, 0.30}});
  }
  prior.shared = {0.50, 0.35, 0.75};
  prior.tangential = guess.tangential;
  prior.tangentialSpread = 0.18;
  prior.radialRatio = guess.radial / guess.tangential;
  char text[80];
  std::snprintf(text, sizeof text, "end mill, %g mm, ", 1e3 * diameter.value);
  prior.origin = text + known->name;
  return prior;
}

MachinePrior priorOfTap(std::span<const PriorMode> modes, const milling::Material& material) {
  MachinePrior prior = around(modes, material, {0.015, 0.15, 0.12});
  // A spindle that rotates is not quite the one that was tapped (Schmitz and Smith, sec. 4.6).
  prior.shared = {0.02, 0.10, 0.10};
  prior.origin = "tap test";
  return prior;
}

MachinePrior priorOfCoupling(std::span<const PriorMode> modes, const milling::Material& material) {
  MachinePrior prior = around(modes, material, {0.05, 0.40, 0.25});
  prior.shared = {0.04, 0.20, 0.15};
  prior.origin = "coupled receptances";
  return prior;
}

}  // namespace stillcut::learn
