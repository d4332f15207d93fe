// A structure that is hit with a hammer: force and accelerations at the point of the blow, with noise and the limits of
// the channels. For trying a tap test without hardware, and for tests that know the answer.
// Thread: one; step() neither allocates nor throws.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/milling/cut_model.h"
#include "core/milling/simulation/noise.h"

namespace stillcut::milling {

struct TapBlow {
  double force = 200.0;                   // largest [N]
  double width = 0.4e-3;                  // of the pulse, a half sine [s]
  double bounce = 0.0;                    // fraction of a second pulse; 0: a clean hit
  double bounceAfter = 12e-3;             // [s]
  double lean = 0.0;                      // [rad] off the axis that is hit
  std::array<double, 2> along{1.0, 0.0};  // unit direction of the hammer in x and y
};

struct TapStructure {
  std::vector<Mode> modes;
  Hertz rate{25600.0};
  double forceNoise = 0.1;        // rms [N]
  double responseNoise = 0.3;     // rms [m/s^2]
  double forceRange = 500.0;      // where the channel clips [N]
  double responseRange = 5000.0;  // [m/s^2]
};

// Two modes in x and two in y of a slender end mill.
TapStructure usualTapStructure();

class SimulatedTap {
 public:
  struct Sample {
    double force = 0.0;                    // [N]
    std::array<double, 2> acceleration{};  // along x and y [m/s^2]
  };

  SimulatedTap(TapStructure structure, std::uint64_t seed);

  // Begins now; what still rings goes on.
  void strike(const TapBlow& blow);
  Sample step() noexcept;
  const TapStructure& structure() const { return structure_; }

 private:
  struct Oscillator {
    double q = 0.0, v = 0.0;  // modal displacement and velocity
    double w = 0.0, damping = 0.0, mass = 1.0;
    std::array<double, 2> direction{};
    // Of one substep with constant force.
    double qq = 0.0, qv = 0.0, vq = 0.0, vv = 0.0, qf = 0.0, vf = 0.0;
  };
  double forceAt(double sinceBlow) const noexcept;

  TapStructure structure_;
  std::vector<Oscillator> modes_;
  TapBlow blow_{0.0};
  double sinceBlow_ = 1e9;
  NoiseSource noise_;
};

}  // namespace stillcut::milling
