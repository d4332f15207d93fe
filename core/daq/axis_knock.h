// Which of several sensors lies along which axis, by knocks: the forces of a cut rotate with the tool, so that a cut
// shows two exchanged axes to nobody, but a blow along an axis moves what it hits that way first. What counts is the
// energy of the first 5 ms after a blow begins; later the structure rings in every direction.
// Thread: any; allocates.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/model/channel.h"

namespace stillcut::daq {

struct KnockResult {
  std::size_t told = 0;     // channel that is said to lie along the axis
  std::size_t loudest = 0;  // channel that measured most of the knocks: the same, where all is right
  double lead = 0.0;        // of its energy over the next one's [dB]
  int knocks = 0;
};

// `samples`: of each channel, as the device delivers them, two seconds or more. Compared are the channels of the named
// one's quantity and place that have an axis. Error, one line: no such channels; no blow 20 dB above the rest; two
// channels within 6 dB of each other.
Result<KnockResult> analyseKnocks(const std::vector<std::vector<float>>& samples, Hertz rate,
                                  const std::vector<ChannelInfo>& channels, std::size_t told);

// "4 knocks along x: 'x' measured most, 14.2 dB above the next; it is right".
std::vector<Message> knockSentence(const KnockResult& heard, const std::vector<ChannelInfo>& channels);
// The forms of its phrases; for whoever translates them.
std::span<const char* const> knockWords();

// The axes of the two exchanged, where another channel than the named one was the strongest.
void applyKnocks(const KnockResult& heard, std::vector<ChannelInfo>& channels);

}  // namespace stillcut::daq
