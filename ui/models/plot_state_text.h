// What a plot adds to its title when it does not move, and why. GUI thread, pure.
#pragma once

#include "ui/base/say.h"
#include "ui/facade/session_info.h"

namespace stillcut::ui {

inline QString plotStateTitle(const QString& title, PlotState plotState) {
  return plotState == PlotState::Paused  ? say("%1, PAUSED").arg(title)
         : plotState == PlotState::Ended ? say("%1, ENDED").arg(title)
                                         : title;
}

}  // namespace stillcut::ui
