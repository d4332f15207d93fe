// Cutting coefficients from mean forces at several feeds (mechanistic identification).
//
// In the axes of core/milling/cut_model.h a tooth at phi feels, from the workpiece, F_t against its motion
// (cos phi, -sin phi), F_r inward against (sin phi, cos phi), F_a along +z (up, out of the workpiece):
//   F_x = -F_t cos phi - F_r sin phi,  F_y = F_t sin phi - F_r cos phi,  F_z = F_a,
// with F_q = a_p (K_q f_z sin phi + K_qe), q = t, r, a. The mean over a revolution of Z teeth, engaged st .. ex, is
// linear in the feed, mean F = f_z (slope) + (edge), P = Z a_p / (2 pi), integrals over st .. ex:
//   slope x = P (-K_t SC - K_r SS)     edge x = P (-K_te C - K_re S)      SC = int sin cos, SS = int sin^2
//   slope y = P ( K_t SS - K_r SC)     edge y = P ( K_te S - K_re C)      S = int sin, C = int cos
//   slope z = P K_a S                  edge z = P K_ae (ex - st)
// For a slot: slope x = -Z a_p K_r / 4, slope y = Z a_p K_t / 4, edge x = -Z a_p K_re / pi, edge y = Z a_p K_te / pi,
// slope z = Z a_p K_a / pi, edge z = Z a_p K_ae / 2 (Altintas, Manufacturing Automation, 2nd ed., eq. 2.92).
// Helix and runout leave the mean over whole revolutions as it is. The force is taken linear in the chip thickness.
//
// Signs: a dynamometer measures the force on the workpiece (the negative of the above), and its axes may point
// anywhere. Each measured axis is multiplied by its sign to become the force on the tool. Left open, the signs are
// found from what must hold: K_t, K_r and K_a are positive. Thread: any, set-up path.
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
