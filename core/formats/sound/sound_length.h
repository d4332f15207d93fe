// How much of a sound file can be read, whatever its header says. Thread: any; not real-time (file access).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/formats/sound/sound_file.h"

namespace stillcut::record {

struct SoundLength {
  std::int64_t frames = 0;      // that can be read; 0: none
  std::optional<Message> note;  // where that is less than was promised
};

// Of MP3, FLAC and OGG by decoding all of it, for their headers tell only what was meant to be written; of others what
// libsndfile makes of header and size. `header`: of a WAV.
SoundLength lengthOf(const std::string& path, const SoundFile& file, const RiffHeader* header);

}  // namespace stillcut::record
