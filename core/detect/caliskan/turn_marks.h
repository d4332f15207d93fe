// When did the spindle stand one turn, two turns back? Marks of frame and angle, hop by hop: while the speed changes,
// one turn ago is where the angle was one turn less. Thread: worker; real-time.
#pragma once

#include <array>

#include "core/detect/growth/energy_growth.h"

namespace stillcut::detect {

class TurnMarks {
 public:
  void reset() { *this = {}; }
  // So many frames of `step` [rad] of the spindle each.
  void advance(double step, int frames) {
    now_.frame += frames;
    now_.angle += frames * step;
  }
  void endHop();
  // Frames since the spindle stood so many turns back; beyond the marks, `unmarked`.
  double framesAgo(double turns, double unmarked) const;

 private:
  static constexpr int kMarks = 27 * kHopsPerTurn;  // as far back as new_line.h looks, of eight hops a turn
  struct Mark {
    double frame = 0.0;
    double angle = 0.0;  // unwrapped
  };
  Mark now_;
  std::array<Mark, kMarks> marks_{};  // hop ends
  int newest_ = 0;
};

}  // namespace stillcut::detect
