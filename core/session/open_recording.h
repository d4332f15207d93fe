// openRecording: the one door to recordings on disk. The content decides, then the suffix. A place inside an HDF5 or
// MATLAB file is named after a colon: "FILE.h5:/folder/set".
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// Set-up thread. An unreadable, empty, truncated or senseless file gives one line; a file that is text is read once to
// its end to find that out.
Result<std::unique_ptr<RecordingReader>> openRecording(const std::string& path, const ReadOptions& options = {});

}  // namespace stillcut::record
