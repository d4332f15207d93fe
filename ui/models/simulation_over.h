// Whether the machine itself is over. GUI thread.
#pragma once

#include "ui/facade/session_info.h"

namespace stillcut::ui {

// With its cut a simulated machine has ended as well: nothing of ours is left in it that somebody should wait for.
inline bool simulationOver(const Picture& picture) {
  return picture.over() && picture.info->simulatedMachine;
}

}  // namespace stillcut::ui
