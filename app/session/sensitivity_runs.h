// SensitivityRuns: what other limits of a detector would have done to the newest recordings, one after the other in the
// background; a newer question ends the one before. Thread: GUI; recordings are judged apart.
#pragma once

#include <QStringList>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/session/background_task.h"
#include "ui/models/tune/tuning.h"

namespace stillcut::app {

class SensitivityRuns {
 public:
  // `files`: newest first. `settings`: KEY=VALUE.
  void start(std::vector<std::string> files, std::string detector, const QStringList& settings);
  // What is known so far.
  ui::SensitivityTrial collect();

 private:
  // Written by the worker, read by the screen.
  struct Board {
    std::mutex mutex;
    ui::SensitivityTrial trial;
  };
  std::shared_ptr<Board> board_ = std::make_shared<Board>();
  BackgroundTask task_;
};

}  // namespace stillcut::app
