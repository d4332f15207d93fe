#include "app/compose/cut/cut_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/compose/known_lobes.h"
#include "app/compose/profile_rig.h"
#include "core/config/toml_reader.h"
#include "core/milling/linear_force.h"
#include "core/milling/stability/lobe_case.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

void take(CutFile& cut, const milling::ModelParts& parts) {
  if (!parts.modes.empty()) cut.model.modes = parts.modes;
  if (parts.material) cut.model.material = *parts.material;
}

Result<CutFile> ofScenario(const std::string& path, const milling::ModelParts& parts) {
  const auto s = milling::loadScenario(path);
  if (!s) return s.error();
  const milling::Programme& programme = s->programme;
  CutFile cut;
  cut.name = s->name;
  cut.model = s->model;
  take(cut, parts);
  cut.model.engagement.radialImmersion = programme.immersion.highest(cut.model.engagement.radialImmersion);
  cut.depth = Metres(programme.depth.highest(0.0));
  cut.lowest = programme.speed * s->overrides.lowestSpeed.value;
  cut.highest = programme.speed * s->overrides.highestSpeed.value;
  cut.feedPerTooth = programme.feedPerTooth;
  cut.maxAxialDepth = std::max(cut.depth * 2.5, Metres(5e-3));
  return cut;
}

Result<CutFile> ofProfile(const std::string& path, const milling::ModelParts& parts) {
  const auto profile = config::loadProfile(path, pipeline::fullCatalog(), knownIds());
  if (!profile) return profile.error();
  if (profile->model.empty()) {
    return Error{path, message("names no model of its cut"), message("cut.model is the file with modes and material")};
  }
  const auto loaded = cutOfProfile(*profile, modelFile(*profile, path), parts);
  if (!loaded) return loaded.error();
  const auto reach = speedsInReach(*profile, path);
  if (!reach) return reach.error();
  CutFile cut{loaded->name, loaded->model, loaded->maxAxialDepth, profile->depth, {}, {}, {}, {}};
  if (reach->high > reach->low) {
    cut.lowest = reach->low;
    cut.highest = reach->high;
  }
  cut.feedPerTooth = feedPerTooth(*profile, cut.model.tool.teeth);
  return cut;
}

enum class Kind { Case, Scenario, Profile };

Kind kindOf(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".json") return Kind::Case;
  const config::TomlReader reader = config::TomlReader::file(path);
  const config::TomlTable root = reader.root();
  if (root.has("programme")) return Kind::Scenario;
  return root.has("version") || root.has("cut") ? Kind::Profile : Kind::Case;
}

Result<CutFile> load(const std::string& path, const milling::ModelParts& parts) {
  switch (kindOf(path)) {
    case Kind::Scenario:
      return ofScenario(path, parts);
    case Kind::Profile:
      return ofProfile(path, parts);
    case Kind::Case:
      break;
  }
  const auto loaded = milling::loadLobeCase(path, parts);
  if (!loaded) return loaded.error();
  return CutFile{loaded->name, loaded->model, loaded->maxAxialDepth, {}, {}, {}, {}, {}};
}

}  // namespace

Result<CutFile> loadCutFile(const std::string& path, const milling::ModelParts& parts, const CutChanges& changes) {
  Result<CutFile> cut = load(path, parts);
  if (!cut) return cut;
  if (changes.feedPerTooth.value > 0.0) cut->feedPerTooth = changes.feedPerTooth;
  if (changes.engagement) cut->model.engagement = *changes.engagement;
  if (changes.offset) cut->model.engagement.offset = 2.0 * (*changes.offset / cut->model.tool.diameter);
  const Metres chip = milling::lineariseForLobes(cut->model, cut->feedPerTooth);
  if (!(chip.value > 0.0)) return cut;
  cut->remarks.push_back(message("the force is not proportional to the chip: taken as it is at a chip of %1 um",
                                 milling::numberText(std::round(1e7 * chip.value) / 10.0)));
  return cut;
}

}  // namespace stillcut::app
