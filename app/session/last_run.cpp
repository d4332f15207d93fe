#include "app/session/last_run.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace stillcut::app {

LastRun::LastRun(const QString& folder) {
  if (folder.isEmpty()) return;
  file_ = QDir(folder).filePath(QStringLiteral("last-run.ini"));
  const QSettings kept(file_, QSettings::IniFormat);
  before_.profile = kept.value(QStringLiteral("run/profile")).toString();
  before_.endedBadly = kept.value(QStringLiteral("run/running")).toBool();
  before_.began = kept.value(QStringLiteral("run/began")).toDateTime();
  before_.recording = kept.value(QStringLiteral("run/recording")).toString();
}

QString LastRun::sentence() const {
  if (!before_.endedBadly) return {};
  const QString began = before_.began.toString(QStringLiteral("yyyy-MM-dd HH:mm"));
  if (before_.recording.isEmpty()) {
    return QCoreApplication::translate("Session", "The run of %1 did not end in order; nothing of it was recorded")
        .arg(began);
  }
  return QCoreApplication::translate("Session", "The run of %1 did not end in order; it is recorded in %2")
      .arg(began, QFileInfo(before_.recording).fileName());
}

void LastRun::begin(const QString& profile) {
  now_ = {};
  if (profile.isEmpty()) return;
  now_.profile = QFileInfo(profile).absoluteFilePath();
  now_.began = QDateTime::currentDateTime();
  keep(true);
}

void LastRun::recordTo(const QString& recording) {
  if (now_.profile.isEmpty() || recording == now_.recording) return;
  now_.recording = recording;
  keep(true);
}

void LastRun::end() {
  if (now_.profile.isEmpty()) return;
  keep(false);
  now_ = {};
}

void LastRun::keep(bool running) {
  if (file_.isEmpty()) return;
  QSettings kept(file_, QSettings::IniFormat);
  kept.setValue(QStringLiteral("run/profile"), now_.profile);
  kept.setValue(QStringLiteral("run/running"), running);
  kept.setValue(QStringLiteral("run/began"), now_.began);
  kept.setValue(QStringLiteral("run/recording"), now_.recording);
  kept.sync();  // the next moment may be the last
}

}  // namespace stillcut::app
