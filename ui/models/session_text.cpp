#include "ui/models/session_text.h"

#include <QFileInfo>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

QString figure(double value, const QString& unit) {
  return std::isfinite(value) ? join(significant(value, 3), unit) : QString(QChar(0x2013));
}

// "3 times, 2 of them marked false"
QString counted(int alarms, int markedFalse) {
  if (alarms == 0) return say("not at all");
  const QString times = alarms == 1 ? say("once") : say("%1 times").arg(alarms);
  return markedFalse == 0 ? say("%1, none marked false").arg(times)
                          : say("%1, %2 of them marked false").arg(times).arg(markedFalse);
}

}  // namespace

QString trackText(const DetectorTrack& track) {
  const QString name = sayCore(track.detector.toStdString());
  if (!track.compared) {
    return say("%1 alarmed %2").arg(name, counted(static_cast<int>(track.before.size()), track.falseBefore));
  }
  return say("%1 would have alarmed %2; as recorded: %3")
      .arg(name, counted(static_cast<int>(track.after.size()), track.falseAfter),
           counted(static_cast<int>(track.before.size()), track.falseBefore));
}

QString scoreText(const ScoreLine& line) {
  return say("%1: found %2 of %3, false %4 (%5 per hour), delay %6")
      .arg(sayCore(line.detector.toStdString()))
      .arg(line.found)
      .arg(line.spans)
      .arg(line.falseAlarms)
      .arg(figure(line.falsePerHour, {}), figure(line.delay_s, QStringLiteral("s")));
}

QString taskText(const TaskState& task) {
  if (!task.running && !task.problem.isEmpty()) return task.problem;
  const QString file = breakable(QFileInfo(task.file).fileName());
  switch (task.what) {
    case TaskState::What::None:
      return {};
    case TaskState::What::Reading:
      return task.running ? say("Reading %1: %2").arg(file, percent(task.part)) : QString();
    case TaskState::What::Marking:
      return task.running ? say("Writing %1").arg(file) : say("The marker is in the file");
    case TaskState::What::Detectors:
      return task.running ? say("Every detector runs on it: %1").arg(percent(task.part))
                          : say("Every detector has run on it");
    case TaskState::What::Scoring:
      return task.running ? say("Scoring: %1").arg(percent(task.part)) : say("Scored against what is marked");
    case TaskState::What::Exporting:
      return task.running ? say("Writing %1").arg(file) : say("Written: %1").arg(breakable(task.file));
  }
  return {};
}

}  // namespace stillcut::ui
