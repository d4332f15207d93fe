// The linear regenerative cut in the form every stability method starts from, speed left out.
//
//   modal:  q_i'' + 2 zeta_i omega_i q_i' + omega_i^2 q_i = (1/m_i) a_i . F,   x = sum_i a_i q_i
//   force:  F = -w H(phi) (x(t) - x(t - tau)),  H = sum over the teeth in the cut of the directional matrix
// With h = x sin(phi) + y cos(phi), F_t = K_t w h, F_r = K_r w h (van Dijk 2010 eq. 1-4):
//   H = [ (K_t c + K_r s) s, (K_t c + K_r s) c ; (K_r c - K_t s) s, (K_r c - K_t s) c ]
// so that H(phi) = steady + cosine cos(2 phi) + sine sin(2 phi) wherever the same teeth cut. With a helix H is the mean
// over the depth, whose edges trail behind the tip by up to lag = w tan(helix)/R, and has a part linear in phi.
// Process damping adds -(w/Omega) D(phi) x'(t) with D = (c/R) [s s, s c; s c, c c], Omega [rad/s].
// Where all modes move along one direction the problem is projected on it and `axes` is 1.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"

namespace stillcut::milling {

using Planar = std::array<double, 4>;  // 2x2, row major; with one axis only element 0 is used

// A stretch of the tooth period over which the same teeth are in the cut. Angles are those of the reference tooth.
struct ForceInterval {
  double from = 0.0;  // [rad]
  double to = 0.0;    // [rad]
  bool cutting = false;
  Planar steady{}, slope{}, cosine{}, sine{};  // [N/m^2], slope [N/m^2/rad]

  Planar at(double angle) const;
  // Integral of H over [a, b] inside the arc [N/m^2 rad].
  Planar integral(double a, double b) const;
};

struct RegenerativeSystem {
  struct Oscillator {
    double omega = 0.0;  // undamped [rad/s]
    double zeta = 0.0;
    double mass = 0.0;              // [kg]
    std::array<double, 2> toTip{};  // a_i, on the projected axes
  };
  int axes = 2;                          // 1 or 2
  std::array<double, 2> direction{1.0};  // of the single axis, when axes is 1
  std::vector<Oscillator> oscillators;
  std::vector<ForceInterval> intervals;  // cover [0, toothAngle) in order
  std::vector<ForceInterval> damping;    // D [N/m^2] over the same stretches; empty: no process damping
  double depth = 0.0;                    // [m] that lag and damping are for
  double toothAngle = 0.0;               // 2 pi / teeth
  int teeth = 0;

  int states() const { return 2 * static_cast<int>(oscillators.size()); }
  double toothPeriod(Rpm speed) const { return 60.0 / (speed.value * teeth); }  // [s]
  double highestOmega() const;
  // Largest |H| entry over the period times the largest |a_i|^2/m_i: how much the cut can stiffen a mode [1/(s^2 m)].
  double stiffening() const;
  // Mean of H over [a, b], which may reach over several arcs but lies in [0, toothAngle].
  Planar mean(double a, double b) const;
  Planar meanDamping(double a, double b) const;  // the same of D
};

// For tools whose teeth are alike, as they are at `depth`; for others the mean pitch stands for theirs. Refuses what
// check() refuses, and a force that is not proportional to the chip thickness. Runout and edge forces do not change the
// linear cut.
Result<RegenerativeSystem> makeRegenerativeSystem(const CutModel& model, const std::string& where, Metres depth = {});
// The same for a model that has been made into a system before.
RegenerativeSystem systemAt(const CutModel& model, Metres depth);

// Fraction of the tooth period during which at least one tooth cuts, 0..1.
double cuttingFraction(const RegenerativeSystem& system);

}  // namespace stillcut::milling
