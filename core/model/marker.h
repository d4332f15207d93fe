// Marker: what a person says about a moment or a span of a recording. Machinists touch a button during the cut;
// engineers add spans and notes afterwards. Plain values: any thread.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/time.h"

namespace stillcut {

// Labels with a meaning for the score; any other word is a note. Spans may as well be called as in tables of truth:
// "chatter", "stable", "idle", "entry", "exit", "spindle_runup", "transition".
inline constexpr const char* kLabelTrueAlarm = "true-alarm";    // the alarm just given was chatter
inline constexpr const char* kLabelFalseAlarm = "false-alarm";  // the alarm just given was not
inline constexpr const char* kLabelOperatorChatter = "heard";   // "I hear it now"
inline constexpr const char* kLabelNote = "note";

struct Marker {
  std::uint64_t number = 0;  // counts the markers of a session
  Instant begin{};           // on the clock of the samples
  Instant end{};             // as begin: a moment
  std::string label;
  std::string author;
  std::string note;
  std::int64_t made_ns = 0;  // when it was set, ns since 1970 UTC
};

}  // namespace stillcut
