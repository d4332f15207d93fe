// Recordings in MATLAB files of version 5 to 7.2, through matio. Version 7.3 is HDF5: hdf5_import.h.
// Thread: its caller's, for as long as it takes; not real-time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// Real numeric vectors and matrices are channels, as variable_channels.h says; units are text variables beside them
// ("x_unit" for "x"). `inner` names the one variable to take; empty: all. Cells and structs are skipped.
Result<std::unique_ptr<RecordingReader>> openMat5(const std::string& path, const std::string& inner,
                                                  const ReadOptions& options);

}  // namespace stillcut::record
