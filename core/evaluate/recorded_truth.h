// What is known about a recording: marked in the session itself, or beside the file in a table TRUTH.csv (columns file,
// t0_s, t1_s, label; teeth, programmed_rpm and measured_spindle_hz where there), or in a simulated case's NAME.json and
// NAME_truth.csv beside NAME_acc.wav.
// Thread: set-up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evaluate/alarm_score.h"
#include "core/formats/recording_reader.h"
#include "core/model/marker.h"

namespace stillcut::evaluate {

struct RecordedTruth {
  std::vector<TruthSpan> spans;
  std::string from;  // the file that said it
  int teeth = 0;     // 0: not said
  Rpm speed{};       // 0: not said
  std::optional<SensorQuantity> quantity;
  std::optional<double> scale;
  std::optional<Hertz> chatter;  // its frequency at the onset
};

// What a session says of itself; of any other file, nothing. A file beside it is not looked at: it may be called the
// same by chance. Empty: nobody has said anything. Error: what is said cannot be read.
Result<std::optional<RecordedTruth>> truthIn(const std::string& recording);

// The same, and then what stands beside the recording: for whoever has asked for it.
Result<std::optional<RecordedTruth>> truthOf(const std::string& recording);

// Spans from how strong the chatter was against the forced vibration, as simulations tell it. From `clear` on (20 %, in
// energy) it is chatter while the ratio of amplitudes stays above one tenth; before `slight` (1 %) all is quiet,
// entries included, and later on wherever the ratio is below one hundredth. NaN: never; what grew above one hundredth
// all the same was stopped.
struct Onsets {
  Seconds slight{}, clear{};
};
std::vector<TruthSpan> spansOfRatio(const std::vector<Seconds>& times, const std::vector<double>& ratios,
                                    const Onsets& onsets);

// Spans from a session's markers. A touch speaks of the last alarm that had begun before it (true, false), and "I hear
// it now" of that moment. `begin`: the first sample; `alarms`: those of the detector in charge, as recorded.
std::vector<TruthSpan> spansOfMarkers(const std::vector<Marker>& markers, Instant begin,
                                      const std::vector<Alarm>& alarms);

}  // namespace stillcut::evaluate
