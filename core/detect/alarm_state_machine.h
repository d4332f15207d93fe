// AlarmStateMachine: from a method's evidence to the states of a verdict, the same for every method that tests growth
// above a learned floor: air, stable, onset, chatter with hysteresis, time and feed since onset, kind.
//
// An alarm begins in the steady cut alone (entry, exit and run-up are not judged; an alarm that stands is kept through
// them while its evidence lasts), not where the vibration falls or the speed changes, and ends when the method says
// that nothing of it is left.
// Thread: worker; real-time.
#pragma once

#include "core/model/verdict.h"
#include "core/sensing/conditioned_block.h"

namespace stillcut::detect {

// What a method found in one step.
struct Evidence {
  bool begins = false;  // enough to call it an onset now
  bool lasts = false;   // enough to keep an alarm
  double severity = 0.0;
};

class AlarmStateMachine {
 public:
  void prepare(int teeth);
  // Energy ratio of full chatter (Caliskan: 0.2); it ends at half of that.
  void setChatterRatio(double ratio) { chatterRatio_ = ratio; }
  void reset();

  void judge(const Evidence& evidence, const ConditionedBlock& block, Seconds step);
  // Once per block: leaves the cut in air, adds up the feed. True when the cut was left: forget what belongs to it.
  bool endBlock(const ConditionedBlock& block);
  // A frequency of this step; the spread of successive ones is its doubt. resolution: of the method [Hz].
  void follow(Hertz frequency, Hertz resolution);

  CutState state() const { return state_; }
  bool alarming() const { return state_ == CutState::Onset || state_ == CutState::Chatter; }
  // May a floor be learned from this step?
  bool calm() const { return state_ == CutState::Stable; }
  // The machine says that its speed changes, faster than turns compare. Where only the vibration looks like it, that
  // may be chatter.
  static bool speedChanges(const ConditionedBlock& block) {
    return block.speedChanging && !block.revolutionsComparable;
  }
  static bool steady(const ConditionedBlock& block) { return block.phase == CutPhase::Steady && !speedChanges(block); }
  // What was learned before is no floor any more: the speed changes, and nobody alarms.
  bool outdated(const ConditionedBlock& block) const { return speedChanges(block) && !alarming(); }
  Hertz frequency() const { return frequency_; }

  // Everything but reason and indicators. An invalid block gives an invalid verdict with the block's reason.
  Verdict verdict(const ConditionedBlock& block) const;

 private:
  ChatterKind kind(Hertz spindle) const;

  int teeth_ = 0;
  double chatterRatio_ = 0.2;
  CutState state_ = CutState::AirCutting;
  double severity_ = 0.0;
  double waited_ = 0.0;  // s, for which evidence has been enough on end
  Hertz frequency_{};
  double frequencySd_ = 0.0;
  double sinceOnset_ = 0.0;
  double feedSinceOnset_ = 0.0;
};

}  // namespace stillcut::detect
