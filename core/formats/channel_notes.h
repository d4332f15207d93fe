// What a sound file cannot say about its channels, as one comment in it: names, quantities, units and calibration, so
// that an exported sound file comes back as what it was. JSON; other programs show it as text or leave it alone.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/formats/recording_sink.h"

namespace stillcut::record {

// `fullScale`: SI units at full scale, per channel.
std::string channelNotes(const ExportPlan& plan, const std::vector<double>& fullScale);

// Changes `channels` and `rate` only if the comment is one of ours and speaks of as many channels.
void applyChannelNotes(std::string_view comment, std::vector<RecordedChannel>& channels, Hertz& rate);

}  // namespace stillcut::record
