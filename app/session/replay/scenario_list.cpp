#include "app/session/replay/scenario_list.h"

#include <QDateTime>
#include <QDirIterator>
#include <QFileInfo>

#include "app/compose/resource_folder.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::app {

std::vector<ui::SessionEntry> scenariosFor(const QString& folder, const std::function<bool()>& goOn) {
  std::vector<ui::SessionEntry> found;
  for (const QString& place : {QString::fromStdString((resourceFolder() / "scenarios").string()), folder}) {
    if (place.isEmpty()) continue;
    QDirIterator files(place, {QStringLiteral("*.toml")}, QDir::Files, QDirIterator::Subdirectories);
    while (goOn() && files.hasNext()) {
      const QFileInfo file(files.next());
      const auto scenario = milling::loadScenario(file.filePath().toStdString());
      if (!scenario) continue;
      ui::SessionEntry entry;
      entry.path = file.filePath();
      entry.job = QString::fromStdString(scenario->name);
      entry.tool = QString::fromStdString(scenario->cutSetup().tool);
      entry.wallMs = file.lastModified().toMSecsSinceEpoch();
      entry.bytes = file.size();
      entry.inside = ui::SessionEntry::Inside::Known;
      entry.length = scenario->programme.duration;
      found.push_back(std::move(entry));
    }
  }
  return found;
}

}  // namespace stillcut::app
