// Sound tracks of phones' and cameras' files (m4a, mp4, mov, 3gp, wma, webm, amr ...) through FFmpeg's libavformat and
// libavcodec. Pictures are left alone. These libraries read what strangers made: call it in a process of its own
// (stillcut-decoder, which is made where libavformat is there). Thread: its caller's; not real-time.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// Decodes the file once to its end, so that its length and any damage are known before the first sample is used. The
// unit is full scale, as of other sound files; of several sound tracks the first best is read, with a note. Error: the
// container or its codec is not known.
Result<std::unique_ptr<RecordingReader>> openMedia(const std::string& path, const ReadOptions& options);

// Does the file begin as one of these containers do? `head`: its first bytes, 16 or more.
bool isMedia(std::string_view head);

}  // namespace stillcut::record
