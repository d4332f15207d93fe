// The long work of the Sessions page: every detector on a recording, and scores of one or many. Thread: the task's.
#pragma once

#include <QStringList>
#include <string>
#include <vector>

#include "app/session/background_task.h"

namespace stillcut::app {

// With the recording's own parameters, and with `settings` (KEY=VALUE) where there are any.
Result<std::vector<ui::DetectorTrack>> trackDetectors(const std::string& file, const std::vector<std::string>& settings,
                                                      BackgroundTask::Progress& progress);

struct Scores {
  std::vector<ui::ScoreLine> lines;
  QStringList notScored;  // "FILE: why"
};
// Of several files those that cannot be read are told, and the others scored; a single one is an error.
Result<Scores> scoreFiles(const std::vector<std::string>& files, BackgroundTask::Progress& progress);

}  // namespace stillcut::app
