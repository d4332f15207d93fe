// The markers' table of an open session file, for those who hold one. Thread: the file's.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/session/file/session_rows.h"
#include "core/storage/hdf5_file.h"

namespace stillcut::record {

// By number: the newest row of each, removed ones too. `path` is named in an error.
Result<std::map<std::uint64_t, MarkerRow>> readMarkerRows(hid_t file, const std::string& path);

}  // namespace stillcut::record
