#include "app/session/deletions.h"

#include <QFileInfo>

#include "ui/base/say.h"

namespace stillcut::app {

std::function<void(const record::Deleted&)> Deletions::teller() {
  return [seen = seen_](const record::Deleted& file) {
    const std::scoped_lock lock(seen->lock);
    if (!file.problem.empty()) {
      seen->kept[file.file] = file.problem;
      return;
    }
    seen->kept.erase(file.file);
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
  for (const auto& [file, problem] : seen_->kept) {
    now.notDeleted << QStringLiteral("%1 (%2)").arg(QFileInfo(QString::fromStdString(file)).fileName(),
                                                    ui::sayCore(problem));
  }
  return now;
}

}  // namespace stillcut::app
