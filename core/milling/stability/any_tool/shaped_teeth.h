// f of a cut whose teeth have a shape: bull-nose, ball-nose, serrated, with any pitch and helix besides, and modes
// along z. As unlike_teeth.h by Hill's determinant, with the directional matrices of edge_pieces.h summed for each
// delay. In place of the depth stands the length of edge below it: force and delay are no smooth functions of the depth
// at the tip of a ball, but of that length they are, and only then do few depths tell of all. Thread: const members
// from any thread.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>
#include <vector>

#include "core/milling/cut_model.h"
#include "core/milling/stability/any_tool/circle_function.h"
#include "core/milling/stability/any_tool/edge_pieces.h"
#include "core/milling/stability/any_tool/harmonic_lines.h"
#include "core/milling/stability/any_tool/tooth_pattern.h"

namespace stillcut::milling {

// Along the corner and up the side, and back.
double edgeLengthBelow(const Tool& tool, double depth);
double depthOfLength(const Tool& tool, double length);

class ShapedTeeth final : public CircleFunction {
 public:
  ShapedTeeth(const CutModel& model, const ToothPattern& pattern, Rpm speed);

  int states() const override { return 2 * static_cast<int>(modes_.size()); }
  bool sample(double length, std::span<const double> angles, Fineness fineness, std::span<std::complex<double>> out,
              WorkMeter& meter) const override;
  Hertz chatterFrequency(double angle, double length, WorkMeter& meter) const override;
  double growthAt(double length) const override;
  // Multipliers outside the circle; empty where one lies on it, or when stopped.
  std::optional<int> outside(double length, WorkMeter& meter) const;
  // Where on the circle f is smallest.
  double closestAngle(double length, WorkMeter& meter) const;
  int lines(Fineness fineness) const { return lines_.count(fineness); }

 private:
  using Complex = std::complex<double>;
  using Spatial = std::array<Complex, 9>;  // 3x3, row major
  struct Mode3 {
    double omega, zeta, mass;
    std::array<double, 3> toTip;
  };
  struct Group {                   // of the pieces with one delay
    double delay = 0.0;            // [s]
    std::vector<Spatial> force{};  // [m + most], times the depth
  };
  struct Sums {
    std::vector<Group> groups{};
    std::vector<Spatial> drag{};  // [m + most]; empty without process damping
    int most = 0;
  };

  Sums sumsAt(double depth, int most, WorkMeter& meter) const;
  void add(Sums& sums, Group& group, const EdgePiece& piece, double depth) const;
  Complex valueAt(double angle, Fineness fineness, const Sums& sums, WorkMeter& meter) const;
  Eigen::MatrixXcd matrixAt(const std::vector<HarmonicLine>& lines, const Sums& sums) const;

  const CutModel& model_;  // outlives this
  ToothPattern pattern_;
  double speed_;   // [rad/s]
  double period_;  // of the pattern [s]
  std::vector<Mode3> modes_;
  std::vector<std::size_t> axes_;  // of x, y, z, those along which a mode moves
  HarmonicLines lines_;
};

}  // namespace stillcut::milling
