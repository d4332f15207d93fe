// Three force channels of a recording as plain arrays in newtons, for the identification of cutting coefficients.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::app {

struct ForceFile {
  Hertz rate{};
  std::array<std::vector<double>, 3> force;  // [N]
};

// `channels` counts from 0; empty: the three channels that measure force, else the first three. A gap in the recording
// is an error: the mean would no longer be one over whole revolutions.
Result<ForceFile> readForces(const std::string& path, const std::vector<int>& channels);

}  // namespace stillcut::app
