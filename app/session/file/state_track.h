// StateTrack: a stretch for each state of a verdict, one after the other. Thread: one.
#pragma once

#include "core/model/judged_cut.h"
#include "ui/facade/file_controller.h"

namespace stillcut::app {

class StateTrack {
 public:
  // Of a block from `begin` to `end`, since the first sample.
  void add(const Verdict& verdict, Seconds begin, Seconds end) {
    constexpr Seconds kTouch{1e-6};
    const bool judged = hasState(verdict);
    const bool same = !states_.empty() && states_.back().state == verdict.state && states_.back().judged == judged &&
                      begin - states_.back().end < kTouch;
    if (same) {
      states_.back().end = end;
    } else {
      states_.push_back({begin, end, verdict.state, judged});
    }
  }
  const std::vector<ui::FileState>& states() const { return states_; }

 private:
  std::vector<ui::FileState> states_;
};

}  // namespace stillcut::app
