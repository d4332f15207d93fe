// What is believed of a machine before its first cut: medians and spreads of modes and cutting coefficients, each
// log-normal. From nothing but the kind of tool; from a tap test; from receptances coupled to a measured holder.
// Plain values: any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/learn/lobe_table.h"
#include "core/milling/cut_model.h"

namespace stillcut::learn {

// Standard deviations of logarithms: 0.05 is some 5 %.
struct ModeSpread {
  double frequency = 0.0;
  double damping = 0.0;
  double stiffness = 0.0;
};

struct PriorMode {
  milling::Mode median;
  ModeSpread own;  // of this mode alone
};

struct MachinePrior {
  std::vector<PriorMode> modes;
  ModeSpread shared;                // of all modes together: a stiffer machine is stiffer along x and along y
  double tangential = 7e8;          // K_t, median [N/m^2]
  double tangentialSpread = 0.15;   // of its logarithm
  double radialRatio = 0.3;         // K_r/K_t, median
  double radialRatioSpread = 0.25;  // of its logarithm
  std::string origin;               // "end mill, 12 mm, aluminium"

  // Numbers that a guess is made of, standard normal before the first cut.
  int dimensions() const { return static_cast<int>(3 * modes.size()) + 5; }
  Dynamics machineAt(std::span<const double> guess) const;
};

// Nothing but the tool's diameter and the material, by a name of the table of materials (core/milling/material_table.h;
// aluminium for one that is not known): an end mill in a machining centre.
MachinePrior priorOfTool(Metres diameter, std::string_view material);
// Modes that were tapped, each with what its fit says of its uncertainty; what a tap test is off by besides is added.
MachinePrior priorOfTap(std::span<const PriorMode> modes, const milling::Material& material);
// Modes of a tip coupled to a measured holder: joint and clamping are guessed there.
MachinePrior priorOfCoupling(std::span<const PriorMode> modes, const milling::Material& material);

}  // namespace stillcut::learn
