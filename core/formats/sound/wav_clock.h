// When a WAV recording began, from the chunks that recorders write beside the samples: bext (EBU Tech 3285: date, time
// and samples since midnight), the same in iXML, or ICRD of a LIST INFO chunk where it holds a time of day.
// Thread: any; not real-time (file access).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/formats/sound/riff_header.h"

namespace stillcut::record {

// Of the first sample, ns since 1970 UTC; empty: not told, or no day that there was. These chunks know no zone: that of
// this computer is taken.
std::optional<std::int64_t> wavStarted(const std::string& path, const RiffHeader& header);

}  // namespace stillcut::record
