// The one chatter frequency that verdict, advice, card and plots name: that of the advice as long as what is measured
// now cannot be told from it, so that no two numbers on one screen stand for one thing. GUI thread, pure.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/model/snapshot.h"

namespace stillcut::ui {

inline Hertz namedChatter(const Snapshot& snapshot, Hertz measured, Hertz doubt = {}) {
  constexpr double kSame = 0.015;
  const Hertz advised = snapshot.advice.chatter;
  if (!(measured.value > 0.0) || !(advised.value > 0.0)) return measured;
  const double apart = std::abs((measured - advised).value);
  return apart <= std::max(kSame * advised.value, 3.0 * doubt.value) ? advised : measured;
}

}  // namespace stillcut::ui
