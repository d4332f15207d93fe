// Opening a session file for reading, whatever state it was left in. Shared by the reader and by what counts in it.
#pragma once

#include <string>

#include "core/record/hdf5_file.h"
#include "core/record/recording_reader.h"

namespace stillcut::record {

struct OpenedSession {
  Hdf5Id file;
  bool closedCleanly = true;
};

// A file still being written, or left by a crash, is opened as a reader beside its writer; nothing is changed on disk.
Result<OpenedSession> openSessionFile(const std::string& path);
// Everything in the header, checked against nonsense. `frames` and `blocks` are left 0.
Result<RecordingFormat> readSessionFormat(hid_t file, const std::string& path);

}  // namespace stillcut::record
