// What a tool with a shape is made of: pieces of edge, each with its radius, its axial immersion angle kappa, the
// angles it cuts at, and the delay since the tooth cut that left the surface before it.
//
// Corner radius (bull-nose; ball-nose: the tool's own radius): at a height z below it cos(kappa) = 1 - z/c and the
// radius is R - c + c sin(kappa); start and exit angle are those of the same work's edges at this radius. The chip is
// h = n . x thick, n = (sin phi sin kappa, cos phi sin kappa, -cos kappa), dz/sin(kappa) wide; its force K_r along n
// and K_t along the way of the edge (Altintas and Lee, CIRP Ann. 45, 1996; Ozturk and Budak, J. Manuf. Sci. Eng. 132,
// 2010). Serration: edge j lies rho_j(z) further out. It meets what tooth j + k left where f_k sin(phi) sin(kappa) +
// rho_j - rho_(j+k) is least, and cuts where that is above zero (Dombovari et al., Int. J. Mach. Tools Manuf. 50,
// 2010). Thread: pure; allocates.
#pragma once

#include <vector>

#include "core/milling/cut_model.h"
#include "core/milling/stability/any_tool/tooth_pattern.h"

namespace stillcut::milling {

struct EdgePiece {
  double share = 0.0;           // of the depth of cut
  double from = 0.0, to = 0.0;  // [rad], of this piece of the edge
  double lead = 0.0;            // of it before the spindle's angle [rad]
  double delay = 0.0;           // angle the spindle turns between the two cuts [rad]
  double sineKappa = 1.0, cosineKappa = 0.0;
};

// Of the first teeth of the pattern, which then repeats. `turns` is the largest harmonic of the spindle that will be
// asked for.
std::vector<EdgePiece> edgePieces(const CutModel& model, const ToothPattern& pattern, double depth, int turns);

}  // namespace stillcut::milling
