// Spindle speed variation against a cut that chatters: tried in a simulation of the linear cut, with a sine about the
// speed that the machine can follow. It helps against period doubling, whose lobes are narrow along the speed, and
// seldom against Hopf chatter at high speed (Seguy, Insperger, Arnaud, Dessein and Peigne, Int. J. Adv. Manuf. Technol.
// 48, 2010). Thread: any, set-up; some 0.1 s for each variation that is tried. Allocates.
#pragma once

#include <optional>

#include "core/base/units.h"
#include "core/milling/cut_model.h"

namespace stillcut::learn {

struct SpeedVariation {
  Ratio amplitude{};  // of the speed, to either side
  Seconds period{};
};

// What the spindle and its override can do.
struct VariationLimits {
  Ratio lowest{0.8}, highest{1.2};    // of the programmed speed
  double acceleration = 3000.0;       // of the spindle [rev/min/s]
  Seconds shortestPeriod{0.3};        // that the link to the machine follows
  Rpm lowestSpeed{}, highestSpeed{};  // of the machine; 0: not given
};

struct VariationTrial {
  double growth = 0.0;       // of a small disturbance, mean over a period [1/s]; below zero it dies
  double largestRise = 0.0;  // ln of what it grows to inside a period
};

// With an amplitude of 0 the constant speed.
VariationTrial tryVariation(const milling::CutModel& model, Rpm speed, Metres depth, const SpeedVariation& variation);

// The smallest amplitude within the limits, at the shortest period they allow, with which a disturbance dies and never
// grows to more than e^3 of itself. Empty: none does.
std::optional<SpeedVariation> helpfulVariation(const milling::CutModel& model, Rpm speed, Metres depth,
                                               const VariationLimits& limits);

}  // namespace stillcut::learn
