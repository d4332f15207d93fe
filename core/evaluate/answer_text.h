// The answer about a recording in sentences, the same on every screen, in the report and on the command line. Forms are
// messages, so that the edge translates them; numbers and reasons are written by whoever shows them.
// Thread: any; not the sample path.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/model/recording_answer.h"

namespace stillcut::evaluate {

struct AnswerWriting {
  std::function<std::string(double value, int decimals)> number;
  std::function<std::string(Rpm)> speed;             // "9,010", without its unit
  std::function<std::string(const Reason&)> reason;  // without a full stop
};
// As the command line writes: English, thousands parted by commas.
AnswerWriting englishWriting();

// "chatter at 1502 Hz from 3.3 s on", "no chatter", "not judged: channel 0 delivers a constant"
Message findingSentence(const RecordingAnswer& answer, const AnswerWriting& writing);
// "try 9,010 or 10,010 rev/min (5 or 4½ waves of 1502 Hz between two teeth, instead of 4.74), or less depth"; why no
// speed can be said; empty where no chatter was found.
Message adviceSentence(const SpeedAnswer& advice, const AnswerWriting& writing);
// "judged 1.5 of 8.0 s; the rest: 2.0 s of air cutting, 4.5 s: channel 0 delivers a constant"
Message judgedSentence(const RecordingAnswer& answer, const AnswerWriting& writing);
// "chatter can be detected up to 5300 Hz"
Message hearingSentence(const RecordingAnswer& answer, const AnswerWriting& writing);
// A line for each channel that was left out or was not in order.
std::vector<Message> channelSentences(const RecordingAnswer& answer, const AnswerWriting& writing);

// "4½", "5", "4.74": waves between two teeth.
std::string wavesText(double waves, const AnswerWriting& writing);

}  // namespace stillcut::evaluate
