// A part of a recording as a recording of its own: from one time to another, counted from the recording's first sample.
// Thread: its owner's; not real-time.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

struct TimeSpan {
  std::optional<Seconds> from;  // empty: from the beginning
  std::optional<Seconds> to;    // empty: to the end; the sample at this time is not part of it
  bool whole() const { return !from && !to; }
};

// Error: the span is empty, or lies outside the recording. Blocks keep their times.
Result<std::unique_ptr<RecordingReader>> openSpan(std::unique_ptr<RecordingReader> whole, const TimeSpan& span,
                                                  const std::string& where);

}  // namespace stillcut::record
