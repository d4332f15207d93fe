// What the operator said of each alarm of this run, by the time it began: one mark at most, taken back by the touch
// that made it. Made from the touches themselves, whichever page they were made on. GUI thread, values.
#pragma once

#include <cstdint>
#include <map>

#include "core/base/time.h"
#include "core/model/operator_input.h"

namespace stillcut::ui {

enum class AlarmJudgement { None, Chatter, False };

// What a touch on a judgement asks for, where `now` is the one that stands. `began` zero: the newest alarm.
inline OperatorInput judgeAlarm(Instant began, AlarmJudgement touched, AlarmJudgement now) {
  OperatorInput input;
  input.action = touched == now                       ? OperatorAction::UndoMark
                 : touched == AlarmJudgement::Chatter ? OperatorAction::TrueAlarm
                                                      : OperatorAction::FalseAlarm;
  input.value = sinceEpoch(began).value;
  return input;
}

class AlarmMarks {
 public:
  AlarmJudgement of(Instant began) const {
    const auto mark = marks_.find(sinceEpoch(began).value);
    return mark != marks_.end() ? mark->second : AlarmJudgement::None;
  }
  void note(const OperatorInput& input) {
    ++version_;
    if (input.action == OperatorAction::TrueAlarm) marks_[input.value] = AlarmJudgement::Chatter;
    if (input.action == OperatorAction::FalseAlarm) marks_[input.value] = AlarmJudgement::False;
    if (input.action == OperatorAction::UndoMark) marks_.erase(input.value);
  }
  void clear() {
    marks_.clear();
    ++version_;
  }
  std::uint64_t version() const { return version_; }  // another one: something was touched

 private:
  std::map<double, AlarmJudgement> marks_;  // by OperatorInput::value
  std::uint64_t version_ = 0;
};

}  // namespace stillcut::ui
