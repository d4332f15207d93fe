// Is this HDF5 file one of our sessions, and does the HDF5 library survive it? Tried in a process of its own.
#pragma once

#include <string>

#include "core/record/recording_reader.h"

namespace stillcut::record {

// True: a session (which is not read any further here); false: a file of another program, of which everything but the
// samples after the first 64 MB was read once without harm, whether it is a recording or not. Error: the library died.
Result<bool> probeHdf5(const std::string& path, const std::string& inner, const ReadOptions& options);

}  // namespace stillcut::record
