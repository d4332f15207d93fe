// A recording that can be read until somebody says stop: what copies it through core/record then ends with an error and
// leaves no file behind. Thread: the task's.
#pragma once

#include "app/session/background_task.h"
#include "core/session/convert_recording.h"

namespace stillcut::app {

// Opens as openCut() does. `progress` outlives what it opens, and is told the part that was read.
record::OpenCut openStoppable(BackgroundTask::Progress& progress);

}  // namespace stillcut::app
