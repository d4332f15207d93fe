// The modal model of one compliance and its least-squares fit.
//   H(f) = sum_r (a_r + i u_r b_r) / (1 - u_r^2 + 2 i z_r u_r) + c_0 - c_1 (f_m/f)^2,   u_r = f / f_r,
// with complex upper (c_0) and lower (c_1) residuals for the modes outside the band. a_r + i u b_r with real a, b is
// the pair of complex conjugate residues A/(s - p) + A*/(s - p*); b_r = 0 is the real mode of classical theory with
// modal stiffness 1 / a_r. (Ewins, Modal Testing, 2nd ed., section 4.4.) For given poles the model is linear in a, b,
// c; poles are refined by variable projection (Golub and Pereyra 1973) with Kaufman's Jacobian and Levenberg-Marquardt
// steps in ln f and ln z, which keeps both positive. Pure: any thread; set-up, not real-time.
#pragma once

#include <vector>

#include "core/milling/identify/modal_lines.h"
#include "core/milling/identify/modal_pole.h"

namespace stillcut::identify {

enum class ModalConstants { Real, Complex };

struct ConstantsFit {
  Eigen::VectorXd constants;  // per mode a (and b if complex), then the residuals; [m/N]
  Eigen::VectorXcd fitted;    // at the lines
  double misfit = 1.0;        // |fitted - measured| / |measured|, 2-norms over the band
};

ConstantsFit fitConstants(const ModalLines& lines, const std::vector<ModalPole>& poles, ModalConstants kind);

// Improves the poles; complex constants. Returns the misfit reached.
double refinePoles(const ModalLines& lines, std::vector<ModalPole>& poles, int iterations);

// Standard deviations from the scatter of the residual: relative of frequency, damping and a, one row per mode.
Eigen::MatrixX3d relativeDeviations(const ModalLines& lines, const std::vector<ModalPole>& poles);

}  // namespace stillcut::identify
