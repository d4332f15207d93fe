// The lobes of the cut that a recording is of: of the scenario or the profile that it says it was made from. The
// machine may have another tool by now. Thread: any; the disk may be slow.
#pragma once

#include <memory>
#include <string>

#include "app/session/lobe_worker.h"

namespace stillcut::app {

// `configuration`: as the recording carries it (run_text.h). A file of modes is looked for where the profile named it,
// or beside the recording where it was named by a relative path. Null: the modes are not known any more, or never were.
std::unique_ptr<LobeWorker> recordedLobes(const std::string& path, const std::string& configuration);

}  // namespace stillcut::app
