// Export: any recording that can be opened, or a span of it, in SI units and with its calibration. Any one thread.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/formats/recording_reader.h"
#include "core/formats/span_reader.h"
#include "core/session/open_recording.h"

namespace stillcut::record {

// The suffix of `to` decides: .wav (32-bit float; RF64 above 4 GiB), .flac (24 bits), .csv (time and one column per
// channel), .mat (MATLAB v5), .uff (58b) or .unv (58 in text), .h5 (plain HDF5). `to` appears only when it is complete.
// A gap makes the times of a CSV jump; .mat and .h5 hold NaN there, the others zeros and a list beside
// them (gap_list.h).
// `open`: how `from` is opened, where it may be something else than a file this room knows.
using OpenCut = std::function<Result<std::unique_ptr<RecordingReader>>(const std::string&, const ReadOptions&)>;
Status convertRecording(const std::string& from, const std::string& to, const ReadOptions& options = {},
                        const TimeSpan& span = {}, const OpenCut& open = openRecording);

}  // namespace stillcut::record
