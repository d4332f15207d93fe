#include "app/session/replay/session_lister.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <map>
#include <optional>
#include <utility>

#include "app/compose/recording_score.h"
#include "core/session/session_glance.h"

namespace stillcut::app {
namespace {

constexpr std::size_t kAtOnce = 16;  // files looked at before the screen hears of them

// FOLDER/JOB/TOOL/TIME.h5, as sessions are named; anything else is its own job.
ui::SessionEntry entryOf(const QString& folder, const std::string& path) {
  const QFileInfo file(QString::fromStdString(path));
  const QStringList parts = QDir(folder).relativeFilePath(file.filePath()).split(u'/');
  ui::SessionEntry entry;
  entry.path = file.filePath();
  entry.job = parts.size() >= 3 ? parts[parts.size() - 3] : file.completeBaseName();
  entry.tool = parts.size() >= 2 ? parts[parts.size() - 2] : QStringLiteral(".");
  entry.wallMs = file.lastModified().toMSecsSinceEpoch();
  entry.bytes = file.size();
  entry.inside =
      file.suffix() == QStringLiteral("h5") ? ui::SessionEntry::Inside::NotYet : ui::SessionEntry::Inside::No;
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
                  lookInside();
                });
              });
}

void SessionLister::lookInside() {
  std::vector<std::pair<std::size_t, std::string>> next;
  for (std::size_t i = 0; i < entries_.size() && next.size() < kAtOnce; ++i) {
    if (entries_[i].inside == ui::SessionEntry::Inside::NotYet) next.emplace_back(i, entries_[i].path.toStdString());
  }
  if (next.empty()) return;
  task_.start(ui::TaskState::What::None, folder_,
              [this, next](BackgroundTask::Progress& progress) -> Result<BackgroundTask::Apply> {
                std::vector<std::optional<record::SessionGlance>> seen;
                for (const auto& [place, path] : next) {
                  if (progress.stopped()) return Error{path, message("stopped")};
                  seen.push_back(record::glanceAtSession(path));
                }
                return BackgroundTask::Apply([this, next, seen = std::move(seen)] {
                  for (std::size_t k = 0; k < next.size(); ++k) {
                    ui::SessionEntry& entry = entries_[next[k].first];
                    entry.inside = seen[k] ? ui::SessionEntry::Inside::Known : ui::SessionEntry::Inside::No;
                    if (!seen[k]) continue;
                    entry.length = seen[k]->length;
                    entry.markers = seen[k]->markers;
                  }
                  lookInside();
                });
              });
}

void SessionLister::setMarkers(const QString& path, int markers) {
  for (ui::SessionEntry& entry : entries_) {
    if (entry.path == path) entry.markers = markers;
  }
}

}  // namespace stillcut::app
