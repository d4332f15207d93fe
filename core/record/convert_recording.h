// Export: any recording that can be opened, as WAV or CSV in SI units.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/record/recording_reader.h"

namespace stillcut::record {

// The suffix of `to` decides: .wav (32-bit float) or .csv (time and one column per channel, with names and units).
// `to` appears only when it is complete. A gap makes the times of a CSV jump; WAV has no times, so it is filled with
// zeros there.
Status convertRecording(const std::string& from, const std::string& to, const ReadOptions& options = {});

}  // namespace stillcut::record
