#include "app/session/replay/recorded_lobes.h"

#include <QByteArray>
#include <QString>
#include <QTemporaryFile>
#include <string_view>
#include <utility>

#include "app/compose/profile_rig.h"
#include "app/compose/run_text.h"
#include "core/config/profile.h"
#include "core/milling/simulation/scenario.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

std::unique_ptr<LobeWorker> ofScenario(const std::string& file) {
  const auto scenario = milling::loadScenario(file);
  return scenario ? std::make_unique<LobeWorker>(*scenario) : nullptr;
}

// A text that is no scenario is refused as any file would be.
std::unique_ptr<LobeWorker> ofScenarioText(const QByteArray& text) {
  QTemporaryFile file;
  if (!file.open() || file.write(text) != text.size() || !file.flush()) return nullptr;
  return ofScenario(file.fileName().toStdString());
}

}  // namespace

std::unique_ptr<LobeWorker> recordedLobes(const std::string& path, const std::string& configuration) {
  if (path.ends_with(".toml")) return ofScenario(path);
  const std::string origin = runOrigin(configuration);
  if (origin.empty()) return nullptr;
  const auto profile = config::parseProfile(origin, path, pipeline::fullCatalog(), knownIds());
  if (!profile) return ofScenarioText(QByteArray::fromStdString(origin));
  auto lobes = LobeWorker::ofProfile(*profile, path);
  return lobes ? std::move(lobes).value() : nullptr;
}

}  // namespace stillcut::app
