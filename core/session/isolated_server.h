// The other end of openIsolated(): what the programs stillcut-reader and stillcut-decoder do. Thread: the main one of
// its process; waits.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// Serves the file over the socket `peer` until nobody asks any more. Kills the process when the library needs more
// than a minute for an answer or four gigabytes of memory. `options`: JSON as isolated_messages.h has it.
int serveIsolated(int peer, const std::string& path, const std::string& inner, const std::string& options);

// The same for a file with a sound track; only where there is libavformat.
int serveMedia(int peer, const std::string& path, const std::string& options);

// What both are made of: the limits, and a reader, or its refusal, handed over as it is asked for.
void limitIsolated();
int serveOpened(int peer, const Result<std::unique_ptr<RecordingReader>>& reader);

}  // namespace stillcut::record
