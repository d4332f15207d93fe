// The simulated cuts that can be replayed: the program's own, and those below the folder of recordings. A file that is
// no scenario is left out. `goOn`: asked before each file; false: stop with what there is. Thread: any; reads files.
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "ui/facade/session_controller.h"

namespace stillcut::app {

std::vector<ui::SessionEntry> scenariosFor(const QString& folder, const std::function<bool()>& goOn);

}  // namespace stillcut::app
