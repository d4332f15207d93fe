#include "core/detect/caliskan/turn_marks.h"

#include "core/base/units.h"

namespace stillcut::detect {

void TurnMarks::endHop() {
  newest_ = (newest_ + 1) % kMarks;
  marks_[static_cast<std::size_t>(newest_)] = now_;
}

double TurnMarks::framesAgo(double turns, double unmarked) const {
  const double wanted = now_.angle - kTwoPi * turns;
  Mark after = now_;
  for (int k = 0; k + 1 < kMarks; ++k) {
    const Mark& m = marks_[static_cast<std::size_t>((newest_ - k + kMarks) % kMarks)];
    if (m.angle > wanted) {
      after = m;
      continue;
    }
    if (!(after.angle > m.angle)) break;
    return now_.frame - m.frame - (after.frame - m.frame) * (wanted - m.angle) / (after.angle - m.angle);
  }
  return unmarked;
}

}  // namespace stillcut::detect
