// The parameters of the active table's controller, `active.*`.
// Thread: set-up.
#pragma once

#include "core/active/fxlms.h"
#include "core/active/identify_path.h"
#include "core/config/param_set.h"

namespace stillcut::active {

config::ParamTable activeParams();
FxlmsOptions fxlmsOptions(const config::ParamSet& params);  // without lines to quieten: those belong to the cut
PathRequest pathRequest(const config::ParamSet& params);

}  // namespace stillcut::active
