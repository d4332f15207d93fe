// LabVIEW's TDMS files as recordings. Thread: its caller's; not real-time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// `inner`: "/Group" or "/Group/Channel"; empty: all groups.
Result<std::unique_ptr<RecordingReader>> openTdms(const std::string& path, const std::string& inner,
                                                  const ReadOptions& options);

}  // namespace stillcut::record
