// What a list of recordings says of each session: its length, its markers and its alarms, without reading its steps.
// Thread: any; not real-time (file access by a process of its own, which may die of a damaged file).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/session/file/min_max.h"

namespace stillcut::record {

struct SessionGlance {
  Seconds length{};  // from the first sample to the last, pauses included
  int markers = 0;
  bool featuresOnly = false;    // a history without samples
  int alarms = 0;               // that began in it
  Seconds alarmed{};            // from the beginning of each to its last alarming verdict
  std::int64_t started_ns = 0;  // of the first sample, ns since 1970 UTC; 0: not told
};

// Nothing where the file is no session, is still being written, or was cut off: a glance repairs nothing. Nothing as
// well where the look takes more than 0.1 s of work: waiting for a slow disk is none.
std::optional<SessionGlance> glanceAtSession(const std::string& path);

// The whole of a session as a picture: least and greatest of its first channel in each of `columns` equal parts, in SI
// units; NaN where nothing was recorded. 0 columns: its begin and end alone.
struct SessionSketch {
  Instant begin{}, end{};
  std::vector<MinMax> columns;
};
Result<SessionSketch> sketchSession(const std::string& path, int columns);

namespace here {

// In the process that calls it.
std::optional<SessionGlance> glanceAtSession(const std::string& path);

}  // namespace here

}  // namespace stillcut::record
