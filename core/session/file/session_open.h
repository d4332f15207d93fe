// Opening a session file for reading, whatever state it was left in. Shared by the reader and by what counts in it.
// Thread: its caller's, for as long as it takes; not real-time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/formats/recording_reader.h"
#include "core/storage/hdf5_file.h"
#include "core/storage/journaled_file.h"

namespace stillcut::record {

struct OpenedSession {
  std::unique_ptr<JournaledFile> journaled;  // where a journal must be read along with the file; goes after it
  Hdf5Id file;
  bool closedCleanly = true;
};

// A file left by a crash is repaired where it can be written, else read as if it had been; one that is still being
// written is opened as a reader beside its writer. One that is cut short (a copy that broke off, a full disk) is
// refused and left as it is: what is missing would read as zeros.
enum class Repair : std::uint8_t { Yes, No };  // No: a glance, nothing is changed
Result<OpenedSession> openSessionFile(const std::string& path, Repair repair = Repair::Yes);
// Completes what a dead writer has begun, where that makes a whole session of it.
Result<Recovery> recoverSession(const std::string& path);
// An error: a file that was not closed is no session, or cut short. Nothing is written.
Status checkUnclosed(const std::string& path, bool journal);
// Everything in the header, checked against nonsense. `frames` and `blocks` are left 0.
Result<RecordingFormat> readSessionFormat(const OpenedSession& opened, const std::string& path);

}  // namespace stillcut::record
