#include "app/cli/setting_options.h"

#include <utility>

#include "app/compose/profile_rig.h"
#include "core/config/profile.h"
#include "core/config/toml_reader.h"
#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {

void SettingOptions::add(CLI::App& command) {
  command.add_option("--set", settings, "Override a parameter, KEY=VALUE; may be repeated")->allow_extra_args(false);
  command.add_option("--config", config, "Read parameters from FILE (.toml)");
}

namespace {

Result<Settings> readConfig(const std::string& path, const config::ParamCatalog& catalog) {
  if (!config::TomlReader::file(path).root().has("version")) {
    auto params = config::loadParameters(path, catalog);
    if (!params) return params.error();
    return Settings{std::move(params).value(), ""};
  }
  const auto profile = config::loadProfile(path, catalog, knownIds());
  if (!profile) return profile.error();
  return Settings{profile->params, profile->detector};
}

}  // namespace

std::string detectorWords(bool all) {
  std::string words;
  for (const auto& row : detect::detectorTable()) words += (words.empty() ? "" : ",") + std::string(row.id);
  return "TEXT:{" + words + (all ? ",all}" : "}");
}

std::string strategyWords() {
  std::string words = "active";
  for (const auto& entry : control::strategyTable()) words += "," + std::string(entry.id);
  return "TEXT:{" + words + "}";
}

Result<Settings> SettingOptions::read(const config::ParamSet& base) const {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  Settings result{base, ""};
  if (!config.empty()) {
    auto loaded = readConfig(config, catalog);
    if (!loaded) return loaded.error();
    result = std::move(loaded).value();
  }
  for (const std::string& setting : settings) {
    if (const Status set = config::applySetting(result.params, catalog, setting); !set) return set.error();
  }
  return result;
}

}  // namespace stillcut::app
