// HDF5 files, our own sessions among them, read in a process of their own. HDF5 1.10 dies of some damaged files, at the
// first byte or a gigabyte into the samples: a stranger's file must not take a running cut with it. The process is a
// program that starts afresh (stillcut-reader; no fork, which would halt a real-time thread at its next write, and
// could copy a lock that somebody holds); it reads, and hands over one block for each that is asked for. Thread: any,
// one at a time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/hdf5/isolated_process.h"
#include "core/formats/recording_reader.h"

namespace stillcut::record {

// A session comes back with its steps. Another `program` reads another kind of file in the same way. Error: the library
// died or took more than a minute, then and later: one line; else what openHdf5() or the session's own reader say.
Result<std::unique_ptr<RecordingReader>> openIsolated(const std::string& path, const std::string& inner,
                                                      const ReadOptions& options, IsolatedProgram program = {});

}  // namespace stillcut::record
