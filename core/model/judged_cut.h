// What one verdict has judged of a cut: for totals of time, and for whoever shows or sends a state. Any thread.
#pragma once

#include "core/model/verdict.h"

namespace stillcut {

// The tool is in the material: neither air nor run-up.
inline bool inCut(const Verdict& v) {
  return v.phase == CutPhase::Entry || v.phase == CutPhase::Steady || v.phase == CutPhase::Exit;
}

// An alarm, or the steady cut on a learned floor. Entry, exit, run-up and learning belong to every cut and are not
// judged.
inline bool judges(const Verdict& v) {
  const bool steady = v.valid && v.phase == CutPhase::Steady && v.state != CutState::AirCutting;
  return v.alarming() || (steady && v.reason.code != ReasonCode::Learning);
}

// The verdict's state may be shown: the cut was judged, or there is none. Everything else is "not judged", never
// "stable".
inline bool hasState(const Verdict& v) {
  return judges(v) || (v.valid && v.state == CutState::AirCutting);
}

// Why a cut was not judged; of a verdict without hasState().
inline Reason whyNotJudged(const Verdict& v) {
  if (!v.valid || v.reason.code == ReasonCode::Learning) return v.reason;
  if (v.phase == CutPhase::RunUp) return {ReasonCode::SpindleRunUp, {toRpm(v.spindle).value}};
  return {ReasonCode::Transient, {}};
}

}  // namespace stillcut
