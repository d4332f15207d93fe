#include "app/session/run_tuning.h"

#include <QCoreApplication>
#include <QDir>
#include <algorithm>
#include <filesystem>

#include "app/compose/profile_rig.h"
#include "core/active/active_params.h"
#include "core/config/profile.h"
#include "core/config/toml_writer.h"
#include "core/control/fuzzy_params.h"
#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/pipeline/catalog.h"
#include "core/safety/gate_limits.h"
#include "core/session/record_params.h"

namespace stillcut::app {
namespace {

using Role = ui::TunableComponent::Role;

QString text(std::string_view s) {
  return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

template <class Part>
void takeChosen(ui::TunableComponent& shown, const Part& part) {
  for (const config::ParamDecl* decl : shown.params) {
    if (decl->mayBeAutomatic) shown.chosen[decl->key] = part.chosen(*decl);
  }
}

ui::TunableComponent part(Role role, std::string_view id, std::string_view label, config::ParamTable params) {
  ui::TunableComponent shown;
  shown.id = text(id);
  shown.label = text(label);
  shown.role = role;
  shown.params.assign(params.begin(), params.end());
  return shown;
}

ui::TunableComponent detectorPart(const detect::DetectorRow& row, const Rig& rig) {
  const auto made = row.make();
  const detect::DetectorInfo info = made->describe();
  ui::TunableComponent shown = part(Role::Detector, info.id, info.label, row.params());
  shown.source = text(info.source);
  for (const std::string_view name : info.indicators) shown.indicators.push_back(text(name));
  const auto& detectors = rig.chain().parts().detectors;
  for (std::size_t k = 0; k < detectors.size(); ++k) {
    if (detectors[k]->describe().id != info.id) continue;
    shown.running = true;
    shown.detector = static_cast<int>(k);
    shown.inCharge = static_cast<int>(k) == rig.chain().parts().inCharge;
    takeChosen(shown, *detectors[k]);
  }
  return shown;
}

template <class Part>
std::vector<ui::AutoReading> readingsOf(const Part& part) {
  std::vector<ui::AutoReading> readings;
  const detect::AutoValueTable table = part.autoValues();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const detect::AutoValue now = part.own(i);
    readings.push_back(
        {table[i].key, text(table[i].label), text(table[i].unit), text(table[i].whys[now.why]), now.value});
  }
  return readings;
}

// The cells of a fuzzy strategy's tables are shown as tables.
void takeRules(ui::TunableComponent& shown) {
  const config::ParamTable rules = control::fuzzyRuleParams(), centres = control::fuzzyCentreParams();
  const auto first = std::find(shown.params.begin(), shown.params.end(), rules.front());
  if (first == shown.params.end()) return;
  shown.params.erase(first, first + static_cast<std::ptrdiff_t>(rules.size()));
  const auto half = rules.begin() + static_cast<std::ptrdiff_t>(rules.size() / 2);
  shown.speedRules.assign(rules.begin(), half);
  shown.feedRules.assign(half, rules.end());
  shown.setCentres.assign(centres.begin(), centres.end());
}

}  // namespace

std::vector<ui::TunableComponent> tunableParts(const Rig& rig) {
  std::vector<ui::TunableComponent> parts;
  for (const auto& row : detect::detectorTable()) parts.push_back(detectorPart(row, rig));
  for (const auto& entry : control::strategyTable()) {
    const auto made = entry.make();
    const control::StrategyInfo info = made->describe();
    ui::TunableComponent shown = part(Role::Strategy, info.id, info.label, entry.params);
    shown.source = text(info.source);
    takeRules(shown);
    shown.running = shown.inCharge = rig.chain().parts().strategy->describe().id == info.id;
    parts.push_back(std::move(shown));
  }
  ui::TunableComponent conditioner =
      part(Role::Conditioner, "conditioner", QT_TRANSLATE_NOOP("Core", "Signal and cut"), detect::conditionerParams());
  conditioner.running = true;
  takeChosen(conditioner, rig.chain().conditioner());
  parts.push_back(std::move(conditioner));
  parts.push_back(part(Role::Gate, "gate", QT_TRANSLATE_NOOP("Core", "Limits of the machine"), safety::gateParams()));
  parts.back().running = true;
  parts.push_back(part(Role::Recording, "record", QT_TRANSLATE_NOOP("Core", "Recording"), record::recordParams()));
  parts.push_back(
      part(Role::Active, "active", QT_TRANSLATE_NOOP("Core", "Active work-holder"), active::activeParams()));
  return parts;
}

std::vector<ui::AutoReading> ownReadings(const Rig& rig, const ui::TunableComponent& part) {
  if (part.role == Role::Conditioner) return readingsOf(rig.chain().conditioner());
  const auto& detectors = rig.chain().parts().detectors;
  if (part.detector < 0 || static_cast<std::size_t>(part.detector) >= detectors.size()) return {};
  return readingsOf(*detectors[static_cast<std::size_t>(part.detector)]);
}

Result<QString> keepValues(const ValuesToKeep& keep, const std::string& profile, const QString& folder) {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  // Only what was changed: what the machine has narrowed at the start is not the profile's.
  const auto putInto = [&](config::ParamSet& params) -> Status {
    for (const config::ParamDecl* decl : catalog.all()) {
      if (keep.values.text(*decl) == keep.started.text(*decl)) continue;
      if (Status set = params.set(*decl, keep.values.real(*decl), "tune"); !set) return set;
    }
    return Done{};
  };
  if (!profile.empty()) {
    auto loaded = config::loadProfile(profile, catalog, knownIds());
    if (!loaded) return loaded.error();
    if (const Status put = putInto(loaded->params); !put) return put.error();
    if (const Status saved = config::saveProfile(*loaded, catalog, profile); !saved) return saved.error();
    return QString::fromStdString(profile);
  }
  if (folder.isEmpty())
    return Error{message("tune"), message("there is no profile to keep them in"), message("start with --profile")};
  if (!QDir().mkpath(folder)) return Error{folder.toStdString(), message("cannot be made")};
  const std::string path = (std::filesystem::path(folder.toStdString()) / "parameters.toml").string();
  config::ParamSet params;
  if (std::filesystem::exists(path)) {
    auto before = config::loadParameters(path, catalog);
    if (!before) return before.error();
    params = std::move(*before);
  }
  if (const Status put = putInto(params); !put) return put.error();
  config::TomlWriter out;
  out.comment("Kept by the Tune page; stillcut-cli reads it with --config.");
  config::writeParameters(out, params, catalog, "");
  if (const Status saved = out.save(path); !saved) return saved.error();
  return QString::fromStdString(path);
}

}  // namespace stillcut::app
