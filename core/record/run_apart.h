// runApart: work that a library might not survive, done in a process of its own. HDF5 1.10 dies of some damaged files;
// a stranger's file must not take a running cut with it.
#pragma once

#include <functional>
#include <optional>

#include "core/base/units.h"

namespace stillcut::record {

// What `work` returned (0 to 99); nothing when it died, or was not done within `limit`. The child shares no memory, is
// silent, and is not let use more than four gigabytes. Without a free process the work is not done: 0.
// Thread: any, set-up path. The child has only this thread: `work` must not wait for others.
std::optional<int> runApart(const std::function<int()>& work, Seconds limit);

}  // namespace stillcut::record
