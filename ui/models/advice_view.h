// What to do, in one sentence with its reason and its cost. GUI thread, pure functions.
#pragma once

#include <QString>

#include "ui/base/theme.h"
#include "ui/facade/session_info.h"

namespace stillcut::ui {

struct AdviceView {
  // Open: waits for an answer. InForce: ours stands. ForHand: nobody but a hand at the machine, or the program, can
  // follow it. Offered: authority is Off, and a touch would let Stillcut advise. Again: the run is over, and a touch
  // runs it once more.
  enum class Mode { Nothing, Open, InForce, ForHand, Offered, Again };
  Mode mode = Mode::Nothing;
  QString title;   // "ADVICE", "ACTIVE", "WHAT TO DO"
  QString target;  // "8 565 rpm", or the sentence that there is nothing to do
  QString delta;   // "−235 rpm, 97 %"
  QString reason;  // why this value
  QString feed;    // "Feed follows: 1 370 mm/min"
  QString cost;    // "Costs 2.7 % time, cutting speed 323 m/min"

  bool canAnswer() const { return mode == Mode::Open; }
  QString spoken() const;
  bool operator==(const AdviceView&) const = default;
};

// Why the move in force was asked for: the reason of the newest request that moved something. The strategy says it
// once, the command stays.
class MoveReason {
 public:
  // Call at every display tick.
  void see(const Snapshot& snapshot) {
    const OverrideRequest& asked = snapshot.request;
    if (asked.kind == RequestKind::Set) {
      reason_ = asked.reason;
      target_ = asked.claimsSpeed ? asked.speed : Rpm();
    }
    if (!snapshot.commanding && !snapshot.adviceOpen && asked.kind != RequestKind::Set) {
      reason_ = {};
      target_ = Rpm();
    }
  }
  const Reason& reason() const { return reason_; }
  // Where the ramp ends; 0: no speed was asked for.
  Rpm target() const { return target_; }

 private:
  Reason reason_;
  Rpm target_{};
};

AdviceView makeAdviceView(const Picture& picture, const Reason& moveReason = {}, Rpm target = {});

}  // namespace stillcut::ui
