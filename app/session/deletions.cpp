#include "app/session/deletions.h"

namespace stillcut::app {

std::function<void(const record::Deleted&)> Deletions::teller() {
  return [seen = seen_](const record::Deleted& file) {
    if (!file.problem.empty()) return;
    const std::scoped_lock lock(seen->lock);
    ++seen->count;
    seen->last = file.file;
  };
}

ui::RecordingNow Deletions::told(const record::Recorder* recorder) const {
  ui::RecordingNow now;
  if (recorder != nullptr) {
    using State = ui::RecordingNow::State;
    const record::RecorderStatus status = recorder->status();
    now.path = QString::fromStdString(status.path);
    now.state = status.writing ? State::Writes : State::Waits;
    if (!status.recording) now.state = State::Stopped;
  }
  const std::scoped_lock lock(seen_->lock);
  now.deleted = seen_->count;
  now.lastDeleted = QString::fromStdString(seen_->last);
  return now;
}

}  // namespace stillcut::app
