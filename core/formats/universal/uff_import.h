// Time recordings in universal files: every dataset 58 or 58b that is a time response is a channel.
// Thread: its caller's, for as long as it takes; not real-time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// Reads the file once to its end, so that damage is known before anything is made of it, with a fixed buffer. Of
// channels of several lengths or rates those that hold most numbers are read; the others, and other functions (spectra,
// frequency responses), are named in `skipped`.
Result<std::unique_ptr<RecordingReader>> openUff(const std::string& path, const ReadOptions& options);

}  // namespace stillcut::record
