#include "app/compose/replay_run.h"

#include <utility>

namespace stillcut::app {

void ReplayRun::start(Rig::After after) {
  if (thread_) return;
  thread_.emplace(rt::ThreadRequest{"replay"}, [this, after = std::move(after)](const std::stop_token& stop) {
    while (!stop.stop_requested() && rig_->advance(after)) {
    }
    finished_.store(true, std::memory_order_release);
  });
}

void ReplayRun::stop() {
  if (!thread_) return;
  thread_->requestStop();
  rig_->interrupt();
  thread_.reset();
}

}  // namespace stillcut::app
