// Alarms against marked truth: found, missed, false per hour, delay. Knows nothing of files or detectors.
// Thread: any; values.
#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/model/verdict.h"

namespace stillcut::evaluate {

// Times count from the first sample of the recording.
// Grew: chatter on its way that was stopped before it was chatter; an alarm is right, none is no miss.
// Ignored: nothing is asked of a detector there.
enum class SpanKind { Chatter, Quiet, Grew, Ignored };
struct TruthSpan {
  Seconds begin{}, end{};
  SpanKind kind = SpanKind::Ignored;
  std::string label;
  bool touched = false;  // by one touch: as long as the alarm it speaks of, or the moment before "I hear it"
};
// "chatter..." and "true-alarm" are chatter; "transition...", "entry", "exit", "note" and unknown words are ignored;
// every other label of a table of truth (stable, idle, spindle_runup, entry_stable ..., false-alarm) is quiet.
SpanKind kindOf(const std::string& label);

struct Alarm {
  Seconds begin{}, end{};
};

// Collects the alarms of one detector from its verdicts. A pause shorter than kAlarmPause is part of the alarm.
inline constexpr Seconds kAlarmPause{0.25};
class AlarmList {
 public:
  void observe(Seconds time, const Verdict& verdict);
  const std::vector<Alarm>& alarms() const { return alarms_; }

 private:
  std::vector<Alarm> alarms_;
};

// An alarm may come this much before the marked beginning, which a person has set, and stay this long after the end.
inline constexpr Seconds kEarly{0.5};
inline constexpr Seconds kLinger{1.0};

struct AlarmScore {
  int spans = 0;  // of chatter
  int found = 0;
  int alarms = 0;                // all
  int falseAlarms = 0;           // that reach into quiet spans
  Seconds quiet{};               // length in which no alarm was to come
  std::vector<double> delays_s;  // of each span found, from its marked beginning; 0: before it

  int missed() const { return spans - found; }
  // NaN where nothing quiet is marked.
  double falsePerHour() const;
  // 0.5: median. NaN when nothing was found.
  double delayQuantile(double share) const;
  void add(const AlarmScore& other);
};
// Quiet is what is marked so. Where somebody touched true, false or "I hear it" during the cut, all of its `length` was
// listened to, and quiet is what no chatter covers.
AlarmScore scoreAlarms(const std::vector<TruthSpan>& truth, const std::vector<Alarm>& alarms, Seconds length = {});

}  // namespace stillcut::evaluate
