// Which angles of the tool are in the material, on the way in, in full, and on the way out.
// Thread: pure functions. Real-time safe.
#pragma once

#include <array>

#include "core/milling/surface_history.h"

namespace stillcut::milling {

struct EngagedAngles {
  std::array<AngularWindow, 2> windows{};
  int count = 0;
};

// `full` is the window of the radial immersion. `entered` is the advance of the tool since its edge met the material's
// face, `remaining` what is left until its centre reaches the end, both in radii of the tool; 1 or more: no effect.
// In: a tooth cuts where sin(phi) > 1 - entered. Out: where sin(phi) < remaining.
EngagedAngles engagedAngles(AngularWindow full, double entered, double remaining) noexcept;

}  // namespace stillcut::milling
