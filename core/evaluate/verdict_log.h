// VerdictLog: the changes of every detector's verdict as the `--events` file has them (README, command line), and the
// figures of a run that a summary prints.
// Thread: one; not the sample path.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/time.h"
#include "core/model/verdict.h"

namespace stillcut::evaluate {

class VerdictLog {
 public:
  // `begin`: stream time of the first sample, from which "t" counts.
  VerdictLog(std::string_view detector, Instant begin) : detector_(detector), begin_(begin) {}

  // Keeps the verdict when state, phase, validity, reason or warning changed since the last one.
  void observe(const Verdict& verdict);

  // Appends one object per change, from number `first` on.
  void appendEvents(nlohmann::json& array, std::size_t first = 0) const;
  std::size_t changes() const { return changes_.size(); }

  struct Summary {
    std::string detector;
    int alarms = 0;              // times the state became onset or chatter from neither
    double firstAlarm_s = -1.0;  // -1: none
    double alarmTime_s = 0.0;    // in onset or chatter
    double chatterTime_s = 0.0;
    double validTime_s = 0.0;
    double frequency_Hz = 0.0;  // of the line that alarms were about most, by severity: means of two lines are none
    double worstSeverity = 0.0;
    double spindle_Hz = 0.0;  // mean of the spindle frequency used where one was; 0: never one
    std::string lastReason;   // of the last invalid verdict
  };
  Summary summary() const;

 private:
  struct Band {  // of frequency, as wide as one line
    double weight = 0.0;
    double sum = 0.0;
  };
  double strongest() const;

  std::string detector_;
  Instant begin_;
  bool started_ = false;
  Verdict last_;
  std::vector<Verdict> changes_;
  Summary sums_;
  std::map<long, Band> bands_;
  double spindleTime_ = 0.0;  // [s]
};

void toJson(nlohmann::json& object, const VerdictLog::Summary& summary);

}  // namespace stillcut::evaluate
