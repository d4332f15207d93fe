// Whether a told speed seems to be in another unit: revolutions a second, as drives and some books have them.
// Thread: main; reads the recording once more.
#pragma once

#include <string>
#include <vector>

#include "core/formats/recording_reader.h"
#include "core/model/recording_answer.h"

namespace stillcut::app {

// A sentence where the signal fits sixty times the told speed; empty: no doubt, or nothing to be seen.
// `channels`: of the recording, that were judged.
std::string speedDoubt(const std::string& path, const record::ReadOptions& read,
                       const std::vector<ChannelAnswer>& channels, Rpm told);

}  // namespace stillcut::app
