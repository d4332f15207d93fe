// JudgedTime: how much of a recording one detector has judged, and for which reasons not the rest. Judged is the steady
// cut with a valid verdict that rests on a learned floor, and every alarm. Entry, exit, run-up and learning belong to
// every cut and are not judged; air has nothing to judge.
// Thread: one; not the sample path.
#pragma once

#include <vector>

#include "core/model/recording_answer.h"
#include "core/model/verdict.h"

namespace stillcut::evaluate {

// Time by reason: those of one code and one channel are one.
class ReasonTimes {
 public:
  void add(const Reason& reason, Seconds time);
  std::vector<UnjudgedTime> longestFirst() const;
  bool empty() const { return times_.empty(); }

 private:
  std::vector<UnjudgedTime> times_;
};

// The channel that a reason is about, counted among those judged; -1: none.
int channelOf(const Reason& reason);

class JudgedTime {
 public:
  // `took`: length of the verdict's block.
  void observe(const Verdict& verdict, Seconds took);
  // Samples that are missing between two blocks.
  void addMissing(Seconds time);

  Seconds length() const { return length_; }
  Seconds judged() const { return judged_; }
  Seconds air() const { return air_; }
  std::vector<UnjudgedTime> notJudged() const { return rest_.longestFirst(); }
  // Chatter where something alarmed; else no chatter only where at least half of what is not air was judged.
  Finding finding() const;

 private:
  Seconds length_{}, judged_{}, air_{};
  ReasonTimes rest_;
  bool alarmed_ = false;
};

}  // namespace stillcut::evaluate
