// Deletions: what the limits of a folder of recordings have let go during this run, what should have gone and could
// not, and how its recording stands, for the screen. Thread: GUI; teller()'s function: any, and longer than this.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/session/recorder.h"
#include "core/session/session_folder.h"
#include "ui/facade/setup_controller.h"

namespace stillcut::app {

class Deletions {
 public:
  std::function<void(const record::Deleted&)> teller();
  // `recorder`: of the run; null: nothing is recorded.
  ui::RecordingNow told(const record::Recorder* recorder) const;

 private:
  struct Seen {
    std::mutex lock;
    int count = 0;
    std::string last;
    std::map<std::string, std::string> kept;  // file, and why it is still there
  };
  std::shared_ptr<Seen> seen_ = std::make_shared<Seen>();
};

}  // namespace stillcut::app
