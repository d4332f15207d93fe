// f of a cut whose teeth differ in pitch or helix, by its harmonics. On the circle the motion is exp(i omega t) times a
// function of the pattern's period T, so that with x_k its line at omega + k 2 pi/T and G the receptance
//   x_k = G(omega_k) F_k,   F_k = -sum over l of [ w sum over teeth H_(k-l) (1 - exp(-i omega_l tau)) + i omega_l D ]
//   x_l,
// Hill's determinant det(1 + G A). Each tooth has its own delay, which with unequal helices depends on the height too:
// then the depth is a sum over Gauss points. Lines are faded out at a few times the highest mode, so that f stays
// exactly periodic in omega and real at mu = 1 and -1. Multiplied by the structure's own (mu - mu_i), which takes
// the poles out, f counts multipliers (Budak, J. Manuf. Sci. Eng. 125, 2003 part 1; Bachrathy and Stepan, Int. J.
// Mech. Sci. 2013; the fade is ours).
// Straight teeth without process damping have a StraightMonodromy instead, which is the same f for far less work.
// Thread: const members from any thread.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "core/milling/cut_model.h"
#include "core/milling/stability/any_tool/circle_function.h"
#include "core/milling/stability/any_tool/harmonic_lines.h"
#include "core/milling/stability/any_tool/straight_monodromy.h"
#include "core/milling/stability/any_tool/tooth_pattern.h"
#include "core/milling/stability/regenerative_system.h"

namespace stillcut::milling {

class UnlikeTeeth final : public CircleFunction {
 public:
  UnlikeTeeth(const CutModel& model, const ToothPattern& pattern, Rpm speed);

  int states() const override { return straight_.states(); }
  bool sample(double depth, std::span<const double> angles, Fineness fineness, std::span<std::complex<double>> out,
              WorkMeter& meter) const override;
  Hertz chatterFrequency(double angle, double depth, WorkMeter& meter) const override;
  double growthAt(double depth) const override;
  // f by the lines, whatever the teeth are.
  bool sampleLines(double depth, std::span<const double> angles, Fineness fineness, std::span<std::complex<double>> out,
                   WorkMeter& meter) const;
  // Whether the work at this speed, which grows with the third power of lines or unknowns, is worth waiting for.
  static bool possible(const CutModel& model, const ToothPattern& pattern, Rpm speed);

 private:
  using Complex = std::complex<double>;
  // What does not depend on the frequency, for one depth.
  struct Sums {
    std::vector<Complex> phases;   // [m + most][tooth, height]: exp(i m repeats angle), weighed over the heights
    std::vector<double> delays;    // [tooth, height] [s]
    std::vector<Planar> re, im;    // H_m
    std::vector<Planar> dre, dim;  // D_m over the spindle's angular speed; empty without process damping
    int most = 0;                  // largest m
  };

  Sums sumsAt(double depth, int most) const;
  Eigen::MatrixXcd matrixAt(const std::vector<HarmonicLine>& lines, const Sums& sums, double depth) const;

  ToothPattern pattern_;
  double speed_;   // [rad/s]
  double period_;  // of the pattern [s]
  double start_, exit_;
  double tangential_, radial_, damping_;  // damping [N/m^2], over the radius
  RegenerativeSystem straight_;           // of the mean pitch: the oscillators, and estimates
  HarmonicLines lines_;
  std::optional<StraightMonodromy> rough_, fine_;  // of straight teeth without process damping
};

}  // namespace stillcut::milling
