// Spreadsheets as recordings: the sheet that is asked for, or the first that holds rows of numbers.
// Thread: its owner's; not real-time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// `place`: "/NAME" of a sheet; empty: none is asked for. A note tells which sheet of several was taken.
Result<std::unique_ptr<RecordingReader>> openSheet(const std::string& path, const std::string& place,
                                                   const ReadOptions& options);

}  // namespace stillcut::record
