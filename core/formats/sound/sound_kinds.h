// Which files libsndfile is asked about, by what they begin with. Pure: any thread.
#pragma once

#include <string_view>

namespace stillcut::record {

// RIFF and its kin, FLAC, AIFF, OGG, Sun and NeXT, CAF, Creative, IRCAM, Ensoniq, NIST, MP3.
bool isSound(std::string_view head);
// MP3: a tag of ID3, or a frame's eleven set bits with layer III. UTF-16 begins with eleven set bits as well.
bool isMpegAudio(std::string_view head);

}  // namespace stillcut::record
