// ChannelSurvey: which channels of a recording are no vibration by what they hold: a constant, a row number or any
// other counter, a time, an angle that grows and wraps, a tacho or a switch that knows two values, mains hum
// (hum_survey.h). A channel is what the file says it is until it shows otherwise from its first sample to its last; one
// that ever moves like a vibration is one, whatever it does elsewhere. Thread: one; set-up. Reads as far as a channel
// is undecided, of several channels the first minute, but at least a second.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/formats/recording_reader.h"
#include "core/model/recording_answer.h"

namespace stillcut::evaluate {

// From the reader's beginning; what was read is gone from it. Empty: all may be judged. Where no channel is a vibration
// all stay, so that the judgement says why there is none. `told`: spindle speed, 0: nobody told one.
Result<std::vector<LeftOutChannel>> surveyChannels(record::RecordingReader& reader, Hertz told);

}  // namespace stillcut::evaluate
