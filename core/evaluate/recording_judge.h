// RecordingJudge: follows a run over a recording, step by step, and says at its end what each detector has found, how
// much of the recording that rests on, and what was wrong with each channel.
// Thread: whoever runs the rig; not the sample path. Allocates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evaluate/alarm_score.h"
#include "core/evaluate/auto_value_log.h"
#include "core/evaluate/judged_time.h"
#include "core/evaluate/verdict_log.h"
#include "core/model/step_record.h"
#include "core/pipeline/chain.h"

namespace stillcut::evaluate {

// What the run does not know of its recording.
struct JudgedRecording {
  CutSetup setup;                       // as the run took it: teeth, nominal speed, channels, stable speeds
  std::vector<int> fileChannels;        // of each channel of the run its place in the file; empty: the same
  std::vector<LeftOutChannel> leftOut;  // by the file's places
  config::SpeedRange reach;             // of the spindle; 0 to 0: not given
  Metres depthLimit{};                  // of the nominal speed, by the lobes; 0: not known
};

class RecordingJudge {
 public:
  // `chain` outlives it.
  RecordingJudge(const pipeline::Chain& chain, JudgedRecording recording);

  // After each step.
  void observe(const StepInput& input, const StepOutput& output);

  std::size_t detectors() const { return detectors_.size(); }
  // Of detector d, in the order of the chain; 0 is in charge.
  RecordingAnswer answer(std::size_t d) const;
  VerdictLog::Summary summary(std::size_t d) const { return detectors_[d].log.summary(); }
  const VerdictLog& log(std::size_t d) const { return detectors_[d].log; }
  const AlarmList& alarms(std::size_t d) const { return detectors_[d].alarms; }
  const std::vector<AutoValueLog::Entry>& ownValues() const { return own_.entries(); }
  std::optional<Instant> begin() const { return begin_; }
  // The reason as a reader of the file counts its channels.
  Reason asInFile(Reason reason) const;

 private:
  struct Judged {
    VerdictLog log;
    AlarmList alarms;
    JudgedTime time;
    double alarmTime = 0.0, alarmTurns = 0.0;  // [s] in alarm with a known speed, and revolutions meanwhile
  };
  void observeChannels(const StepOutput& output, Seconds took);
  Hertz spindleOf(const Verdict& verdict) const;
  int fileChannel(int channel) const;

  const pipeline::Chain* chain_;
  JudgedRecording recording_;
  std::vector<Judged> detectors_;
  std::vector<ReasonTimes> faults_;  // of each channel
  AutoValueLog own_;
  std::optional<Instant> begin_;
};

}  // namespace stillcut::evaluate
