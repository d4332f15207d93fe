// What was found in a recording as a label track of Audacity (File, Import, Labels): one label a stretch of alarm, with
// the band around its chatter, one a stretch that could not be judged. Text: begin, tab, end, tab, label; a line that
// begins with a backslash gives the band of the label above it.
// Thread: one; not the sample path.
#pragma once

#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/model/verdict.h"

namespace stillcut::evaluate {

class AudacityLabels {
 public:
  // The verdicts of one detector in their order; `time` from the first sample, to the end of the verdict's block.
  void observe(Seconds time, Seconds took, const Verdict& verdict);
  std::string text() const;

 private:
  struct Label {
    Seconds begin{}, end{};
    bool alarm = false;
    CutState worst = CutState::Onset;
    ReasonCode code = ReasonCode::None;  // of what was not judged
    Reason reason;
    double weight = 0.0, weighted = 0.0;  // frequency by severity [Hz]
  };
  std::vector<Label> labels_;
};

}  // namespace stillcut::evaluate
