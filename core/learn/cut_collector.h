// From the verdicts of a run to cuts: one begins in the steady cut, ends in air or when the speed changes, and counts
// once it was judged long enough. What was not judged, and what was forced vibration, is nothing to learn from. Thread:
// one; looked at some tens of times a second, never on the sample path.
#pragma once

#include <optional>

#include "core/learn/cut_evidence.h"
#include "core/model/verdict.h"

namespace stillcut::learn {

struct CollectorParams {
  Seconds quiet{2.0};         // judged without an alarm, that a cut counts as stable
  Seconds alarmed{0.3};       // in alarm, that it counts as chatter
  Seconds air{0.5};           // that end a cut
  double speedChange = 0.03;  // of the speed, that begin another cut [1]
  Seconds longestGap{0.5};    // between two looks, that count
};

struct CollectedCut {
  CutOutcome outcome = CutOutcome::Stable;
  Rpm speed{};        // mean
  Hertz frequency{};  // of the chatter, mean; 0: none
  Hertz frequencySd{};
};

class CutCollector {
 public:
  explicit CutCollector(const CollectorParams& params = {}) : params_(params) {}

  // The newest verdict of the detector in charge. A cut that it ends.
  std::optional<CollectedCut> look(const Verdict& verdict);
  // The run has ended.
  std::optional<CollectedCut> end();

 private:
  void count(const Verdict& verdict, double seconds);

  CollectorParams params_;
  Instant last_{};
  bool begun_ = false;
  double judged_s_ = 0.0, alarm_s_ = 0.0, air_s_ = 0.0;
  double speedSum_ = 0.0;  // rev/min s
  double frequencySum_ = 0.0, squareSum_ = 0.0, frequency_s_ = 0.0;
};

}  // namespace stillcut::learn
