// SessionLister: the recordings below a folder for the Sessions page, from what the folder says of them alone. What is
// inside a session (its length, its markers) is looked at for the rows that somebody asks for, one file after the other
// in processes of their own, and kept for files that have not changed since.
// Thread: GUI; the folder and the files are looked at apart.
#pragma once

#include <QStringList>
#include <optional>
#include <vector>

#include "app/session/background_task.h"
#include "core/session/session_glance.h"
#include "ui/facade/session_controller.h"

namespace stillcut::app {

class SessionLister {
 public:
  void list(const QString& folder);
  const QString& folder() const { return folder_; }
  const std::vector<ui::SessionEntry>& entries() const { return entries_; }
  // Looks into these, and no longer into others.
  void lookInside(const QStringList& paths);
  // Somebody has changed the markers of this one.
  void setMarkers(const QString& path, int markers);
  // True: the entries have changed.
  bool collect() { return task_.collect(); }

 private:
  void lookAtNext();
  void take(const QString& path, const std::optional<record::SessionGlance>& seen);

  QString folder_;
  std::vector<ui::SessionEntry> entries_;
  QStringList asked_;
  BackgroundTask task_;
};

}  // namespace stillcut::app
