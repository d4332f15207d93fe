// Cutting coefficients from mean forces at several feeds (mechanistic identification; Altintas, Manufacturing
// Automation, 2nd ed., eq. 2.92). Equations, axes and signs: resources/manual/developers/laws.md#cutting-coefficients.
// Thread: any, set-up path.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"
#include "core/milling/identify/mean_force.h"

namespace stillcut::identify {

enum class FeedAxis { X, Y };

struct ForceAxes {
  FeedAxis feed = FeedAxis::X;              // dynamometer axis along the feed; the other one is across it
  std::optional<std::array<int, 3>> signs;  // +-1 for the force along the feed, to its left, and up; empty: found
};

struct ForceTest {
  std::string source;
  int teeth = 2;
  double depth = 0.0;  // a_p [m]
  milling::Engagement engagement;
  ForceAxes axes;
  std::vector<MeanForce> means;  // at least two different feeds
};

struct Coefficient {
  double value = 0.0;
  double deviation = 0.0;  // standard deviation; 0 when neither errors nor a third feed are there to tell
};

struct CuttingCoefficients {
  Coefficient tangential, radial, axial;              // K_t, K_r, K_a [N/m^2]
  Coefficient tangentialEdge, radialEdge, axialEdge;  // K_te, K_re, K_ae [N/m]
  std::array<int, 3> signs{1, 1, 1};                  // as given or found
  int feeds = 0;                                      // different ones
  double misfit = 0.0;                                // |mean force - line| / |mean force| over all tests
  std::vector<std::string> remarks;

  milling::Material material() const;  // linear; the axial ones have no place in it
};

// Error: fewer than two feeds, values out of range, no choice of signs that makes the coefficients positive.
Result<CuttingCoefficients> identifyCoefficients(const ForceTest& test);

}  // namespace stillcut::identify
