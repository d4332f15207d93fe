#include "app/cli/setting_options.h"

#include "app/compose/catalog.h"
#include "core/config/profile.h"

namespace stillcut::app {

void SettingOptions::add(CLI::App& command) {
  command.add_option("--set", settings, "Override a parameter, KEY=VALUE; may be repeated")->allow_extra_args(false);
  command.add_option("--config", config, "Read parameters from FILE (.toml)");
}

Result<config::ParamSet> SettingOptions::params() const {
  const config::ParamCatalog catalog = fullCatalog();
  config::ParamSet params;
  if (!config.empty()) {
    auto loaded = config::loadParameters(config, catalog);
    if (!loaded) return loaded.error();
    params = std::move(loaded).value();
  }
  for (const std::string& setting : settings) {
    if (const Status set = config::applySetting(params, catalog, setting); !set) return set.error();
  }
  return params;
}

}  // namespace stillcut::app
