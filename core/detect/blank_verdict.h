// What every detector says of a block before it judges anything. Thread: worker; real-time.
#pragma once

#include "core/model/verdict.h"
#include "core/sensing/conditioned_block.h"

namespace stillcut::detect {

// Whose block it is, when it ended, in which phase and at what speed; invalid with the block's reason, or in a cut
// whose speed nobody knows. A valid one is still to be filled.
inline Verdict blankVerdict(const ConditionedBlock& block) {
  Verdict v;
  v.time = block.end();
  v.blockSequence = block.sequence;
  v.phase = block.phase;
  v.spindle = block.spindle;
  v.valid = block.valid;
  v.reason = block.reason;
  if (v.valid && block.phase != CutPhase::AirCutting && !block.speedKnown()) {
    v.valid = false;
    v.reason = {ReasonCode::NoSpeed, {}};
  }
  return v;
}

// A verdict that is filled: no cut whose vibration went beyond a sensor's limit is called stable.
inline void doubtOverloaded(Verdict& v, const ConditionedBlock& block) {
  if (!block.overloaded || !v.valid || v.alarming() || v.phase == CutPhase::AirCutting) return;
  v.valid = false;
  v.reason = {ReasonCode::InputClipped, {}};
}

}  // namespace stillcut::detect
