// What one period of the pattern makes of the motion where straight teeth stand unevenly, as a matrix whose eigenvalues
// are the multipliers. A tooth meets what the one before it has left at the same angle, so that of the past only the
// tip's displacement while teeth cut counts, and no further back than the longest pitch. It is kept at Gauss points of
// stretches of time that end wherever a tooth enters or leaves; within a stretch the force is the polynomial through
// its values there, the structure's answer to it is exact, and the delayed displacement is interpolated:
//   (1 + w V H) u = P y + w V G,   F = -w (H u - G),   y' = Phi y + E F
// with the states y, G = sum over teeth of H_j u(t - tau_j). Some hundred unknowns where Hill's determinant needs all
// lines of a revolution, and one matrix serves all angles on the circle.
// (Spectral elements for delayed systems: Khasawneh and Mann, Int. J. Numer. Meth. Eng. 87, 2011; the exact answer of
// the structure within a stretch is ours.) Thread: const members from any thread; allocates.
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <span>
#include <vector>

#include "core/milling/stability/any_tool/circle_function.h"
#include "core/milling/stability/any_tool/tooth_pattern.h"
#include "core/milling/stability/regenerative_system.h"

namespace stillcut::milling {

// The cut of one straight tooth.
struct ToothCut {
  double start = 0.0, exit = 0.0;         // [rad]
  double tangential = 0.0, radial = 0.0;  // [N/m^2]
};

class StraightMonodromy {
 public:
  // `speed` [rad/s].
  StraightMonodromy(const RegenerativeSystem& system, const ToothPattern& pattern, const ToothCut& cut, double speed,
                    Fineness fineness);

  // About how many unknowns it has, without making it.
  static double expectedSize(const RegenerativeSystem& system, const ToothPattern& pattern, const ToothCut& cut,
                             double speed);

  // f at exp(i angle), as CircleFunction has it; false when stopped.
  bool sample(double depth, std::span<const double> angles, std::span<std::complex<double>> out,
              WorkMeter& meter) const;
  // Of one depth; empty when stopped.
  Eigen::MatrixXd at(double depth, WorkMeter& meter) const;
  int size() const { return size_; }

 private:
  // Displacement at another time as a sum over the points of a stretch.
  struct Lookup {
    std::size_t stretch = 0;
    bool before = false;  // of the period before
    Eigen::VectorXd weights;
  };
  struct Stretch {
    double from = 0.0, to = 0.0;            // [s]
    std::vector<int> teeth;                 // in the cut
    int first = 0, points = 0;              // among those of the period; none where no tooth cuts
    int unknown = -1;                       // column of its first point as part of the past; -1: too long ago
    Eigen::VectorXd nodes;                  // [s]
    Eigen::MatrixXd free, leave;            // P, Phi
    Eigen::MatrixXd moves, pushes;          // V, E
    Eigen::MatrixXd stiffness;              // H of all teeth
    std::vector<Eigen::MatrixXd> own;       // [tooth] H_j at each point, side by side
    std::vector<std::vector<Lookup>> past;  // [tooth][point]
  };

  void divide(Fineness fineness);
  void respond(Stretch& stretch) const;
  void cutWith(Stretch& stretch) const;
  Lookup lookUp(double time) const;
  double phaseOf(double seconds) const;
  Eigen::MatrixXd toothForce(double angle) const;

  const RegenerativeSystem& system_;
  ToothPattern pattern_;
  ToothCut cut_;
  double speed_, period_;
  double begin_ = 0.0;  // [s] of the period that is looked at
  std::vector<Stretch> stretches_;
  int points_ = 0, size_ = 0;
  double effort_ = 0.0;  // operations of at()
};

}  // namespace stillcut::milling
