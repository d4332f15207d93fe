#include "app/session/replay/session_lister.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <map>
#include <utility>

#include "app/compose/recording_score.h"

namespace stillcut::app {
namespace {

// Sessions are named by when they began, in UTC. What is inside says it better, once it has been looked at; when a file
// was last changed says nothing: marking it changes it.
qint64 beganByName(const QString& name) {
  static const QString kForm = QStringLiteral("yyyy-MM-dd_HH-mm-ss");
  QDateTime began = QDateTime::fromString(name.left(kForm.size()), kForm);
  if (!began.isValid()) return 0;
  began.setTimeSpec(Qt::UTC);
  return began.toMSecsSinceEpoch();
}

// FOLDER/JOB/TOOL/TIME.h5, as sessions are named; anything else is its own job.
ui::SessionEntry entryOf(const QString& folder, const std::string& path) {
  const QFileInfo file(QString::fromStdString(path));
  const QStringList parts = QDir(folder).relativeFilePath(file.filePath()).split(u'/');
  ui::SessionEntry entry;
  entry.path = file.filePath();
  entry.job = parts.size() >= 3 ? parts[parts.size() - 3] : file.completeBaseName();
  entry.tool = parts.size() >= 2 ? parts[parts.size() - 2] : QStringLiteral(".");
  entry.wallMs = file.lastModified().toMSecsSinceEpoch();
  entry.startedMs = beganByName(file.completeBaseName());
  entry.bytes = file.size();
  entry.session = file.suffix() == QStringLiteral("h5");
  entry.inside = entry.session ? ui::SessionEntry::Inside::NotYet : ui::SessionEntry::Inside::No;
  return entry;
}

void keepWhatIsKnown(std::vector<ui::SessionEntry>& entries, const std::vector<ui::SessionEntry>& before) {
  std::map<QString, const ui::SessionEntry*> known;
  for (const ui::SessionEntry& entry : before) known[entry.path] = &entry;
  for (ui::SessionEntry& entry : entries) {
    const auto old = known.find(entry.path);
    if (old == known.end() || old->second->wallMs != entry.wallMs || old->second->bytes != entry.bytes) continue;
    entry = *old->second;
  }
}

}  // namespace

void SessionLister::list(const QString& folder) {
  folder_ = folder;
  task_.start(ui::TaskState::What::None, folder,
              [this, folder, before = entries_](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                std::vector<ui::SessionEntry> entries;
                if (!folder.isEmpty()) {
                  for (const std::string& path :
                       recordingsIn(folder.toStdString(), [&progress] { return !progress.stopped(); })) {
                    if (progress.stopped()) break;
                    entries.push_back(entryOf(folder, path));
                  }
                }
                keepWhatIsKnown(entries, before);
                return BackgroundTask::Apply([this, entries = std::move(entries)] {
                  entries_ = entries;
                  lookAtNext();
                });
              });
}

void SessionLister::lookInside(const QStringList& paths) {
  if (paths == asked_) return;
  asked_ = paths;
  if (!task_.state().running) lookAtNext();
}

// One at a time: the screen hears of each, and what has scrolled away meanwhile is not waited for.
void SessionLister::lookAtNext() {
  const auto next = std::find_if(entries_.begin(), entries_.end(), [this](const ui::SessionEntry& entry) {
    return entry.inside == ui::SessionEntry::Inside::NotYet && asked_.contains(entry.path);
  });
  if (next == entries_.end()) return;
  task_.start(ui::TaskState::What::None, folder_,
              [this, path = next->path](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
                return BackgroundTask::Apply([this, path, seen = record::glanceAtSession(path.toStdString())] {
                  take(path, seen);
                  lookAtNext();
                });
              });
}

void SessionLister::take(const QString& path, const std::optional<record::SessionGlance>& seen) {
  for (ui::SessionEntry& entry : entries_) {
    if (entry.path != path) continue;
    entry.inside = seen ? ui::SessionEntry::Inside::Known : ui::SessionEntry::Inside::No;
    if (!seen) continue;
    entry.length = seen->length;
    entry.markers = seen->markers;
    entry.alarms = seen->alarms;
    entry.alarmed = seen->alarmed;
    if (seen->started_ns > 0) entry.startedMs = seen->started_ns / 1'000'000;
  }
}

void SessionLister::setMarkers(const QString& path, int markers) {
  for (ui::SessionEntry& entry : entries_) {
    if (entry.path == path) entry.markers = markers;
  }
}

}  // namespace stillcut::app
