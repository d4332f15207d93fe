#include "core/evaluate/judged_time.h"

#include <algorithm>

#include "core/model/judged_cut.h"

namespace stillcut::evaluate {
namespace {

constexpr double kLeastJudged = 0.5;  // of what is not air

}  // namespace

int channelOf(const Reason& reason) {
  switch (reason.code) {
    case ReasonCode::InputNotFinite:
    case ReasonCode::InputDead:
    case ReasonCode::InputSilent:
    case ReasonCode::InputLoose:
    case ReasonCode::InputOffset:
    case ReasonCode::InputHum:
    case ReasonCode::InputNoise:
    case ReasonCode::InputDoubled:
    case ReasonCode::InputRepeated:
    case ReasonCode::InputAliased:
    case ReasonCode::InputAbsurd:
      return static_cast<int>(reason.n[0]);
    default:
      return -1;
  }
}

void ReasonTimes::add(const Reason& reason, Seconds time) {
  const auto same = std::find_if(times_.begin(), times_.end(), [&reason](const UnjudgedTime& t) {
    return t.reason.code == reason.code && channelOf(t.reason) == channelOf(reason);
  });
  if (same == times_.end()) {
    times_.push_back({reason, time});
  } else {
    same->time += time;
    same->reason = reason;  // the newest numbers
  }
}

std::vector<UnjudgedTime> ReasonTimes::longestFirst() const {
  std::vector<UnjudgedTime> sorted = times_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const UnjudgedTime& a, const UnjudgedTime& b) { return a.time > b.time; });
  return sorted;
}

void JudgedTime::observe(const Verdict& verdict, Seconds took) {
  length_ += took;
  alarmed_ = alarmed_ || verdict.alarming();
  if (judges(verdict)) {
    judged_ += took;
  } else if (verdict.valid && verdict.state == CutState::AirCutting && verdict.phase != CutPhase::RunUp) {
    air_ += took;
  } else {
    rest_.add(whyNotJudged(verdict), took);
  }
}

void JudgedTime::addMissing(Seconds time) {
  if (!(time.value > 0.0)) return;
  length_ += time;
  rest_.add({ReasonCode::InputGap, {}}, time);
}

Finding JudgedTime::finding() const {
  if (alarmed_) return Finding::Chatter;
  const Seconds cut = length_ - air_;
  return judged_.value > 0.0 && judged_.value >= kLeastJudged * cut.value ? Finding::NoChatter : Finding::NotJudged;
}

}  // namespace stillcut::evaluate
