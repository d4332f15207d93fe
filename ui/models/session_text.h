// What came of runs, scores and tasks on recordings, as sentences. GUI thread, pure functions.
#pragma once

#include <QString>

#include "ui/facade/session_controller.h"

namespace stillcut::ui {

// "Energy ratio alarmed once, none marked false", or with settings "Energy ratio would have alarmed 3 times, 2 of them
// marked false; as recorded: 5 times, 4 of them marked false".
QString trackText(const DetectorTrack& track);
QString scoreText(const ScoreLine& line);
// While it runs and afterwards; a problem as it is.
QString taskText(const TaskState& task);

}  // namespace stillcut::ui
