// What a list of recordings says of each session: its length and how many markers it holds, without reading its steps.
// Thread: any, one at a time; not real-time (file access, and a process that looks first whether the file is ours).
#pragma once

#include <optional>
#include <string>

#include "core/base/units.h"

namespace stillcut::record {

struct SessionGlance {
  Seconds length{};  // from the first sample to the last, pauses included
  int markers = 0;
};

// Nothing where the file is no session, is still being written, or was cut off: a glance repairs nothing.
std::optional<SessionGlance> glanceAtSession(const std::string& path);

}  // namespace stillcut::record
