// The unit of a compliance whose file does not say it, where only one is possible. Units in use (m/N, mm/N, um/N,
// in/lbf) lie 5.7 to 1000 times apart, and machine tools are neither softer nor stiffer than some: where exactly one
// unit gives a stiffness they have, it is that one, and the caller says so; where two do, or where the phase is not
// that of a compliance, nobody can know and the option is asked for. Accelerances in g and m/s^2 look alike.
// Thread: any, set-up path.
#pragma once

#include "core/base/result.h"
#include "core/milling/identify/frf.h"
#include "core/milling/identify/modal_fit.h"

namespace stillcut::identify {

// Of the softest mode at the tip of a tool: slender end mills of 3 mm begin at some 1e5 N/m, face mills in heavy
// spindles end below 1e9 N/m (Schmitz and Smith, Machining Dynamics, 2nd ed., ch. 2 and 7: 1e6 to 1e8).
inline constexpr double kSoftestTool = 1e5;  // [N/m]
inline constexpr double kStiffestTool = 1e9;

struct UnitFound {
  double factor = 1.0;  // to m/N
  Message remark;       // names the unit and why
};

Result<UnitFound> unitByStiffness(const Frf& frf, const ModalOptions& options);

}  // namespace stillcut::identify
