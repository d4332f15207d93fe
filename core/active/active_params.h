// The parameters of the active table's controller, `active.*`.
// Thread: set-up.
#pragma once

#include "core/active/fxlms.h"
#include "core/active/identify_path.h"
#include "core/active/path_recorder.h"
#include "core/config/param_set.h"

namespace stillcut::active {

config::ParamTable activeParams();
FxlmsOptions fxlmsOptions(const config::ParamSet& params);  // without lines to quieten: those belong to the cut
PathRequest pathRequest(const config::ParamSet& params);
RecordRequest recordRequest(const config::ParamSet& params);
Seconds oldestModel(const config::ParamSet& params);
double auxiliaryShare(const config::ParamSet& params);  // of the stroke, rms; 0: no on-line identification
bool forceFeedback(const config::ParamSet& params);
int simulatedFrames(const config::ParamSet& params);  // in a block of a simulated device

}  // namespace stillcut::active
