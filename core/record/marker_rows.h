// The markers' table of an open session file, for those who hold one. Thread: the file's.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/record/hdf5_file.h"
#include "core/record/session_rows.h"

namespace stillcut::record {

// By number: the newest row of each, removed ones too. `path` is named in an error.
Result<std::map<std::uint64_t, MarkerRow>> readMarkerRows(hid_t file, const std::string& path);

}  // namespace stillcut::record
