// What a file holds, for `info` and for screens. Thread: its caller's, for as long as it takes; not real-time.
#pragma once

#include <optional>
#include <string>

#include "core/formats/recording_reader.h"
#include "core/session/file/session_reader.h"

namespace stillcut::record {

struct RecordingDescription {
  std::string path;
  RecordingFormat format;
  std::optional<SessionCounts> session;
};

Result<RecordingDescription> describeRecording(const std::string& path, const ReadOptions& options = {});
// Lines for people, each with its end.
std::string toText(const RecordingDescription& description);
// One JSON object, indented.
std::string toJson(const RecordingDescription& description);

}  // namespace stillcut::record
