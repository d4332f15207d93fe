#include "core/learn/cut_collector.h"

#include <algorithm>
#include <cmath>

#include "core/model/judged_cut.h"

namespace stillcut::learn {

std::optional<CollectedCut> CutCollector::look(const Verdict& verdict) {
  const double seconds = secondsBetween(last_, verdict.time).value;
  const bool first = last_ == Instant{};
  last_ = verdict.time;
  if (first || !(seconds > 0.0) || seconds > params_.longestGap.value) return std::nullopt;
  const bool air = verdict.state == CutState::AirCutting || verdict.phase == CutPhase::AirCutting;
  air_s_ = air ? air_s_ + seconds : 0.0;
  std::optional<CollectedCut> ended;
  if (air_s_ >= params_.air.value) ended = end();
  const double speed = 60.0 * verdict.spindle.value;
  const double time = judged_s_ + alarm_s_;
  if (begun_ && speed > 0.0 && std::abs(speed * time - speedSum_) > params_.speedChange * speedSum_) ended = end();
  if (judges(verdict) && speed > 0.0 && verdict.kind != ChatterKind::Forced) count(verdict, seconds);
  return ended;
}

void CutCollector::count(const Verdict& verdict, double seconds) {
  begun_ = true;
  speedSum_ += 60.0 * verdict.spindle.value * seconds;
  if (!verdict.alarming()) {
    judged_s_ += seconds;
    return;
  }
  alarm_s_ += seconds;
  if (!(verdict.frequency.value > 0.0)) return;
  frequency_s_ += seconds;
  frequencySum_ += verdict.frequency.value * seconds;
  squareSum_ += verdict.frequency.value * verdict.frequency.value * seconds;
}

std::optional<CollectedCut> CutCollector::end() {
  const bool chatter = alarm_s_ >= params_.alarmed.value;
  const bool quiet = alarm_s_ == 0.0 && judged_s_ >= params_.quiet.value;
  std::optional<CollectedCut> cut;
  if (begun_ && (chatter || quiet)) {
    cut.emplace();
    cut->outcome = chatter ? CutOutcome::Chatter : CutOutcome::Stable;
    cut->speed = Rpm(speedSum_ / (judged_s_ + alarm_s_));
    if (chatter && frequency_s_ > 0.0) {
      cut->frequency = Hertz(frequencySum_ / frequency_s_);
      const double mean = cut->frequency.value;
      cut->frequencySd = Hertz(std::sqrt(std::max(0.0, squareSum_ / frequency_s_ - mean * mean)));
    }
  }
  begun_ = false;
  judged_s_ = alarm_s_ = air_s_ = speedSum_ = frequencySum_ = squareSum_ = frequency_s_ = 0.0;
  return cut;
}

}  // namespace stillcut::learn
