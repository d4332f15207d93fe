// Every point (theta, w) of a rectangle where mu = exp(i theta) is a Floquet multiplier: det(Psi(w (1 - 1/mu)) - mu) =
// 0, two real equations for two real unknowns. No depth is scanned: the rectangle is split until in every cell either a
// second-order Taylor bound excludes a zero or the map is one-to-one and Newton decides. So islands and lenses cannot
// be stepped over, however thin. Thread: one, with its WorkMeter; not real-time.
#pragma once

#include <optional>
#include <vector>

#include "core/milling/stability/characteristic.h"

namespace stillcut::milling {

struct CircleCrossing {
  double angle = 0.0;        // theta in (0, pi] [rad]
  double depth = 0.0;        // w [m]
  double outward = 0.0;      // d|mu|/dw there [1/m]: above zero when the multiplier leaves the circle
  Complex byAngle, byDepth;  // derivatives of f there
};

struct ThetaDepthBox {
  double angle0 = 0.0, angle1 = 0.0;  // [rad], within 0 .. pi
  double depth0 = 0.0, depth1 = 0.0;  // [m]
};

// f and its derivatives by theta and w.
struct CircleValue {
  Complex f, fa, fw, faa, faw, fww;
};
CircleValue onCircle(const Characteristic& characteristic, double angle, double depth);

class CircleSurface;

// `caution` multiplies the bound on what the second-order terms leave out; 1 is usual, larger is slower and surer.
// Empty when stopped, or when the box needs more cells than any cut seen so far by far: f is then lost in its noise.
std::optional<std::vector<CircleCrossing>> findCrossings(const Characteristic& characteristic, const ThetaDepthBox& box,
                                                         double caution, WorkMeter& meter);

std::optional<std::vector<CircleCrossing>> findCrossings(const CircleSurface& surface, const ThetaDepthBox& box,
                                                         double caution, WorkMeter& meter);

// Change of arg f along the circle from angle a to b at a depth [rad]; NaN when a multiplier sits on the circle to
// within the resolution, and when stopped. By the argument principle on f/mu^n (analytic outside the circle, one at
// infinity) the number of multipliers outside is states - change(0, pi)/pi, the lower half circle mirroring the upper
// one.
double argumentChange(const Characteristic& characteristic, double depth, double a, double b, WorkMeter& meter);
double argumentChange(const CircleSurface& surface, double depth, double a, double b, WorkMeter& meter);

}  // namespace stillcut::milling
