// What the screens remember of a run, since the snapshot holds only the newest: spectrogram columns, what every
// detector said, the working points, what the operator said of its alarms. Fed at every display tick. Plain values, GUI
// thread.
#pragma once

#include <deque>
#include <vector>

#include "ui/facade/session_info.h"
#include "ui/models/alarm_marks.h"
#include "ui/models/history/event_log.h"
#include "ui/models/history/spectrum_column_reader.h"

namespace stillcut::ui {

// One detector at one display tick.
struct TrackPoint {
  Instant time{};
  CutState state = CutState::AirCutting;
  bool judged = false;     // else the state says nothing
  float severity = 0.0F;   // energy ratio, 0..1
  float indicator = 0.0F;  // its first one
  float frequency = 0.0F;  // [Hz], 0: none
  bool afterGap = false;   // samples are missing between the point before and this one
};

// Where the cut was: spindle speed, and what the detector in charge said of it.
struct WorkingPoint {
  Instant time{};
  Rpm speed{};
  CutState state = CutState::AirCutting;
  bool valid = false;
};

class RunHistory {
 public:
  // Two minutes of columns are 13 MB.
  static constexpr Seconds kKept{120.0};

  void see(const Snapshot& snapshot);
  void clear();
  // What somebody touched.
  void note(const OperatorInput& input) { marks_.note(input); }

  // All of one channel.
  const std::deque<SpectrumColumn>& columns() const { return columns_; }
  // In the order of Snapshot::verdicts.
  const std::vector<std::deque<TrackPoint>>& tracks() const { return tracks_; }
  // One each time the speed or the state has changed, and every half second.
  const std::deque<WorkingPoint>& points() const { return points_; }
  // What happened, and the machine's numbers: kept for hours.
  const EventLog& log() const { return log_; }
  const AlarmMarks& marks() const { return marks_; }
  Hertz spectrumTop() const { return top_; }
  bool empty() const { return columns_.empty() && tracks_.empty(); }
  Instant begin() const;
  Instant end() const { return end_; }

  // The column whose time is nearest; null when there is none.
  const SpectrumColumn* columnAt(Instant t) const;

 private:
  void addPoint(const Snapshot& snapshot);
  void forget();

  SpectrumColumnReader reader_;
  std::deque<SpectrumColumn> columns_;
  std::vector<std::deque<TrackPoint>> tracks_;
  std::deque<WorkingPoint> points_;
  EventLog log_;
  AlarmMarks marks_;
  std::uint64_t number_ = 0;
  std::uint64_t gaps_ = 0;
  Hertz top_{};
  Instant end_{};
};

}  // namespace stillcut::ui
