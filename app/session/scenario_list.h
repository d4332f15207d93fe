// The simulated cuts that can be replayed: the program's own, and those below the folder of recordings. A file that is
// no scenario is left out. Thread: any; reads files.
#pragma once

#include <QString>
#include <vector>

#include "ui/models/session_desk.h"

namespace stillcut::app {

std::vector<ui::SessionEntry> scenariosFor(const QString& folder);

}  // namespace stillcut::app
