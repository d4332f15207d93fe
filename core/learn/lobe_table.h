// The stability limit of one guessed machine at all speeds at once: the zeroth-order border (Altintas and Budak, CIRP
// Ann. 44, 1995; core/milling/stability/zeroth_order.h) swept once over the chatter frequency instead of solved at each
// speed. Some 20 to 60 us a table, so that thousands of guesses can be held against a shop's cuts. What the zeroth
// order gets wrong is part of the learner's uncertainty (MODEL.md).
// Thread: pure functions; allocate only when the table grows.
#pragma once

#include <span>
#include <vector>

#include "core/milling/cut_model.h"
#include "core/milling/stability/regenerative_system.h"

namespace stillcut::learn {

// Speeds in equal ratios.
struct SpeedGrid {
  double lowest = 1000.0;    // [rev/min]
  double highest = 20000.0;  // [rev/min]
  int points = 256;

  double at(int i) const;            // [rev/min]
  double place(double speed) const;  // the inverse, 0 .. points - 1; outside it is held at the ends
};

// Mean directional matrix per tangential coefficient: H = K_t (tangential + ratio * radial).
struct ForceShape {
  milling::Planar tangential{}, radial{};
};
ForceShape meanForce(const milling::Engagement& engagement, int teeth);

struct Dynamics {
  std::vector<milling::Mode> modes;
  double tangential = 0.0;   // K_t [N/m^2]
  double radialRatio = 0.0;  // K_r/K_t
};

struct LimitPoint {
  float logDepth = 0.0F;   // of the limit [ln m]
  float frequency = 0.0F;  // of the chatter there [Hz]; 0: none down to `deepest`
};

// One entry per speed of the grid. A speed without a limit down to `deepest` [m] has ln deepest.
void fillLimits(const Dynamics& machine, const ForceShape& shape, int teeth, const SpeedGrid& grid, double deepest,
                std::vector<LimitPoint>& out);

// Between the grid's speeds. The frequency is the nearer one's.
LimitPoint limitAt(std::span<const LimitPoint> table, const SpeedGrid& grid, double speed);

}  // namespace stillcut::learn
