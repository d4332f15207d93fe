// Recordings that Python's NumPy has saved: one array (.npy), or several by name in a ZIP archive (.npz).
// Source: NEP 1, "A simple file format for NumPy arrays". Thread: its caller's; not real-time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// Real numbers of any size and byte order, in one or two dimensions; the longer side is time. Single numbers of an
// archive may be its rate, as MATLAB's. Objects, complex numbers and structured arrays are refused or left out.
Result<std::unique_ptr<RecordingReader>> openNpy(const std::string& path, const ReadOptions& options);
// `inner`: "/name" reads that array alone; empty: all.
Result<std::unique_ptr<RecordingReader>> openNpz(const std::string& path, const std::string& inner,
                                                 const ReadOptions& options);
// Does a ZIP archive hold arrays of NumPy?
bool isNpz(const std::string& path);

}  // namespace stillcut::record
