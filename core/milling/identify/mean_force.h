// Mean cutting forces over whole revolutions, with how well the mean is known.
// Thread: any, set-up path.
#pragma once

#include <array>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::identify {

struct MeanForce {
  double feedPerTooth = 0.0;                     // [m]
  std::array<double, 3> mean{};                  // dynamometer axes x, y, z [N]
  std::array<double, 3> standardError{0, 0, 0};  // of the mean [N]; 0: not known
};

// Over the largest whole number of revolutions, at least 2; runout and helix leave no trace in such a mean. The
// standard error comes from the scatter of the revolutions' own means, widened where neighbours resemble each other
// (drift). `where` names the file in errors: unequal lengths, too short, values that are not finite, absurd speed or
// rate.
Result<MeanForce> meanOverRevolutions(const std::array<std::span<const double>, 3>& force, double rate, Rpm speed,
                                      double feedPerTooth, const std::string& where);

}  // namespace stillcut::identify
