// From a recording to its summary, in one reading. A session tells what was decided; any other recording only what was
// measured.
// Thread: one; set-up. Memory is bounded.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/model/session_summary.h"
#include "core/record/recording_reader.h"
#include "core/record/span_reader.h"

namespace stillcut::app {

Result<SessionSummary> summarizeRecording(const std::string& path, const record::ReadOptions& options = {},
                                          const record::TimeSpan& span = {});

}  // namespace stillcut::app
