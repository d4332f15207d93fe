#include "core/detect/alarm_state_machine.h"

#include <cmath>

#include "core/detect/blank_verdict.h"
#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kHysteresis = 0.5;
constexpr double kFalling = 0.8;      // what grows does not make the vibration fall; a tool that leaves does
constexpr double kSdMemory = 0.25;    // of the newest jump in the doubt
constexpr double kFlipOffset = 0.02;  // tooth orders from the middle

}  // namespace

void AlarmStateMachine::prepare(int teeth) {
  teeth_ = teeth;
  reset();
}

void AlarmStateMachine::reset() {
  state_ = CutState::AirCutting;
  severity_ = frequencySd_ = sinceOnset_ = feedSinceOnset_ = waited_ = 0.0;
  frequency_ = {};
}

void AlarmStateMachine::judge(const Evidence& evidence, const ConditionedBlock& block, Seconds step) {
  severity_ = evidence.severity;
  const bool high = severity_ >= chatterRatio_ * (state_ == CutState::Chatter ? kHysteresis : 1.0);
  const bool judged = steady(block) && block.levelTrend > kFalling;
  const bool begins = evidence.begins && judged;
  waited_ = begins ? waited_ + step.value : 0.0;
  const bool stands = alarming() ? evidence.lasts : begins && waited_ >= block.alarmWait.value;
  state_ = !stands ? CutState::Stable : high ? CutState::Chatter : CutState::Onset;
  if (alarming()) {
    sinceOnset_ += step.value;
  } else {
    sinceOnset_ = feedSinceOnset_ = frequencySd_ = 0.0;
    frequency_ = {};
  }
}

bool AlarmStateMachine::endBlock(const ConditionedBlock& block) {
  if (block.phase == CutPhase::AirCutting) {
    const bool left = state_ != CutState::AirCutting;
    reset();
    return left;
  }
  if (state_ == CutState::AirCutting) state_ = CutState::Stable;
  if (alarming()) feedSinceOnset_ += block.feed.value * block.frames / block.rate.value;
  return false;
}

void AlarmStateMachine::follow(Hertz frequency, Hertz resolution) {
  if (!alarming() || !(frequency.value > 0.0)) return;
  if (!(frequency_.value > 0.0)) {
    frequencySd_ = resolution.value;
  } else {
    frequencySd_ += kSdMemory * (std::abs(frequency.value - frequency_.value) - frequencySd_);
  }
  frequency_ = frequency;
}

// Period doubling sits half way between the tooth-passing harmonics, whatever the speed; Hopf chatter anywhere else.
ChatterKind AlarmStateMachine::kind(Hertz spindle) const {
  if (teeth_ < 1 || !(frequency_.value > 0.0) || !(spindle.value > 0.0)) return ChatterKind::Unknown;
  const Hertz tooth = spindle * teeth_;
  const double doubt = kFlipOffset + frequencySd_ / tooth.value;
  return 0.5 - std::abs(dsp::orderOffset(frequency_, tooth)) < doubt ? ChatterKind::Flip : ChatterKind::Hopf;
}

Verdict AlarmStateMachine::verdict(const ConditionedBlock& block) const {
  Verdict v = blankVerdict(block);
  if (!v.valid) return v;
  v.state = state_;
  v.severity = Ratio(severity_);
  v.frequency = frequency_;
  v.frequencySd = Hertz(frequencySd_);
  v.sinceOnset = Seconds(sinceOnset_);
  v.feedSinceOnset = Metres(feedSinceOnset_);
  if (v.alarming()) v.kind = kind(block.spindle);
  if (block.phase == CutPhase::RunUp) v.reason = {ReasonCode::SpindleRunUp, {toRpm(block.spindle).value}};
  doubtOverloaded(v, block);
  return v;
}

}  // namespace stillcut::detect
