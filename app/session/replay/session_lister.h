// SessionLister: the recordings below a folder for the Sessions page. They appear at once; what is inside each session
// (its length, its markers) follows a few files at a time, and is kept for files that have not changed since.
// Thread: GUI; the files are looked at apart.
#pragma once

#include <QString>
#include <vector>

#include "app/session/background_task.h"
#include "ui/facade/session_controller.h"

namespace stillcut::app {

class SessionLister {
 public:
  void list(const QString& folder);
  const QString& folder() const { return folder_; }
  const std::vector<ui::SessionEntry>& entries() const { return entries_; }
  // Somebody has changed the markers of this one.
  void setMarkers(const QString& path, int markers);
  // True: the entries have changed.
  bool collect() { return task_.collect(); }

 private:
  void lookInside();

  QString folder_;
  std::vector<ui::SessionEntry> entries_;
  BackgroundTask task_;
};

}  // namespace stillcut::app
