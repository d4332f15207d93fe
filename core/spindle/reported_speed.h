// The spindle's speed by the machine's word, brought to now. A reading is as old as its link says (telemetry: some
// 100 ms), and while the speed changes it is off by what has changed since. So a line through the readings leads it,
// where they lie on one, but not past where the machine says that the speed is to go; what that adds is known to half
// of itself. A target that has just changed says that the speed is on its way before any reading can show it.
// Thread: worker; real-time.
#pragma once

#include <array>

#include "core/base/time.h"
#include "core/model/machine_state.h"

namespace stillcut::detect {

class ReportedSpeed {
 public:
  struct Word {
    double hertz = 0.0;  // 0: the machine says nothing
    bool measured = false;
    double sd = 0.0;  // Hz, for the reading's age alone
  };
  void reset() noexcept { *this = {}; }
  // now: the end of the block that comes next. A state that does not say when its speed was read is taken as of now.
  Word hear(const MachineState& machine, Instant now) noexcept;

 private:
  static constexpr int kReadings = 64;
  struct Reading {
    Instant at{};
    double hertz = 0.0;
  };
  struct Line {
    double hertz = 0.0;  // at the newest reading
    double slope = 0.0;  // Hz/s; 0: they lie on none
  };
  const Reading& reading(int back) const noexcept {
    return readings_[static_cast<std::size_t>((newest_ - back + kReadings) % kReadings)];
  }
  void remember(Reading reading) noexcept;
  void watchTarget(double hertz, Instant now) noexcept;
  Line line(Seconds over) const noexcept;

  std::array<Reading, kReadings> readings_{};
  int newest_ = 0;
  int count_ = 0;
  double target_ = 0.0, before_ = 0.0;  // Hz: what the speed is to be, and was to be
  Instant changed_{};                   // the target
};

}  // namespace stillcut::detect
