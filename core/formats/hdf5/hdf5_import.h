// Recordings in HDF5 files of other programs, MATLAB's v7.3 among them: any data set, or a folder of them, by its path.
// Thread: its caller's, for as long as it takes; not real-time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// `inner` is the path of a data set (one dimension: one channel; two: the longer side is time) or of a folder whose
// data sets are the channels; empty: the one place in the file that holds any. Units and rates: attributes of the data
// set and of the folders above it, or single numbers beside it. Only so much is believed as the file has bytes for;
// compressed pieces of more than 64 MB are refused.
Result<std::unique_ptr<RecordingReader>> openHdf5(const std::string& path, const std::string& inner,
                                                  const ReadOptions& options);

// Does the file say that its writer has not closed it? False for what is no HDF5 file.
bool isLeftOpen(const std::string& path);

}  // namespace stillcut::record
