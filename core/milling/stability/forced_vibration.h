// What a stable cut leaves and how loud it is: forced vibration and surface location error. Where all teeth are alike
// and run true the forced motion repeats with every tooth, so that regeneration does not see it and the structure's own
// receptance gives it exactly, line by line: x_k = G(k omega_tp) F_k (Schmitz and Mann, Int. J. Mach. Tools Manuf. 46,
// 2006). Process damping of the forced motion is left out.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <optional>

#include "core/milling/cut_model.h"

namespace stillcut::milling {

// Distance of the wall from where it was programmed, over the depth of the cut; above zero material is left.
struct SurfaceError {
  Metres least{}, greatest{};
};

struct ForcedVibration {
  double acceleration = 0.0;  // rms of the tool tip, both axes together [m/s^2]
  double displacement = 0.0;  // the same without the mean deflection [m]
  // Walls that exist: the up-milled one where teeth enter at 0, the down-milled one where they leave at pi.
  std::optional<SurfaceError> upWall, downWall;
};

// Empty where teeth differ in pitch, helix or runout, whose forced motion regeneration changes. `model` has passed
// check() and has a force exponent of 1; depth, feed and speed are above zero.
std::optional<ForcedVibration> forcedVibration(const CutModel& model, Rpm speed, Metres depth, Metres feedPerTooth);

}  // namespace stillcut::milling
