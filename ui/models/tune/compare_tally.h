// What each of two settings did while it was in force: time, alarms, time in alarm, highest energy ratio. For the
// comparison of A and B. Stream time; plain values, GUI thread.
#pragma once

#include <QString>
#include <array>
#include <cstddef>

#include "core/model/snapshot.h"

namespace stillcut::ui {

struct SideTally {
  Seconds inForce{}, alarming{};
  int alarms = 0;
  double highest = 0.0;
};

class CompareTally {
 public:
  void reset() { *this = CompareTally(); }
  // Every display tick; `side`: whose values are in force.
  void see(const Snapshot& snapshot, std::size_t side) {
    const Verdict& verdict = snapshot.verdicts[static_cast<std::size_t>(snapshot.inCharge)];
    const Seconds passed = started_ ? secondsBetween(last_, snapshot.time) : Seconds();
    const bool continues = started_ && side == side_ && passed.value >= 0.0 && passed.value < 1.0;
    SideTally& tally = sides_[side];
    if (continues) {
      tally.inForce = tally.inForce + passed;
      if (alarming_) tally.alarming = tally.alarming + passed;
    }
    if (verdict.alarming() && !(continues && alarming_)) ++tally.alarms;
    if (verdict.valid && verdict.severity.value > tally.highest) tally.highest = verdict.severity.value;
    alarming_ = verdict.alarming();
    last_ = snapshot.time;
    side_ = side;
    started_ = true;
  }
  const SideTally& side(std::size_t k) const { return sides_[k]; }

 private:
  std::array<SideTally, 2> sides_{};
  Instant last_{};
  std::size_t side_ = 0;
  bool started_ = false;
  bool alarming_ = false;
};

// "12.4 s: 2 alarms, 0.8 s, ER to 0.31"; "not tried yet".
QString tallyText(const SideTally& tally);

}  // namespace stillcut::ui
