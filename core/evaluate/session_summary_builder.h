// From a recording to its summary, in one reading. A session tells what was decided; any other recording only what was
// measured.
// Thread: one; set-up. Memory is bounded.
#pragma once

#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/formats/recording_reader.h"
#include "core/formats/span_reader.h"
#include "core/model/session_summary.h"

namespace stillcut::evaluate {

// `goOn`: receives the fraction that is done, 0 to 1; false: stop with an error. Empty: to the end.
Result<SessionSummary> summarizeRecording(const std::string& path, const record::ReadOptions& options = {},
                                          const record::TimeSpan& span = {},
                                          const std::function<bool(double)>& goOn = {});

// What can be read at once, however long the recording: what it is, how long, and of a session the least and greatest
// of its first channel as curve (`vibration` is half of what lies between them). No verdicts, no spectrogram.
Result<SessionSummary> glimpseOf(const std::string& path);

}  // namespace stillcut::evaluate
