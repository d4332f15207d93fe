// What a plot adds to its title when it does not move, and why. GUI thread, pure.
#pragma once

#include "ui/base/say.h"
#include "ui/facade/session_info.h"

namespace stillcut::ui {

inline QString standingTitle(const QString& title, Standing standing) {
  return standing == Standing::Paused  ? say("%1, PAUSED").arg(title)
         : standing == Standing::Ended ? say("%1, ENDED").arg(title)
                                       : title;
}

}  // namespace stillcut::ui
