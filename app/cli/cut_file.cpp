#include "app/cli/cut_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
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
  const auto loaded = milling::loadLobeCase(modelFile(*profile, path), parts);
  if (!loaded) return loaded.error();
  const auto reach = speedsInReach(*profile, path);
  if (!reach) return reach.error();
  CutFile cut{loaded->name, loaded->model, loaded->maxAxialDepth, profile->depth, {}, {}, {}, {}};
  if (!profile->pitch.empty()) {
    // The tool in the spindle; its angles close exactly, which a catalogue's figures need not.
    if (profile->pitch.size() != static_cast<std::size_t>(cut.model.tool.teeth)) {
      return Error{path, message("the tool has %1 teeth", std::to_string(cut.model.tool.teeth)),
                   message("the profile's has %1", std::to_string(profile->pitch.size()))};
    }
    cut.model.tool.pitch = profile->pitch;
    const double sum = std::accumulate(profile->pitch.begin(), profile->pitch.end(), 0.0);
    for (double& angle : cut.model.tool.pitch) angle *= kTwoPi / sum;
  }
  if (reach->high > reach->low) {
    cut.lowest = reach->low;
    cut.highest = reach->high;
  }
  const double perSecond = toothPassing(profile->cut.nominalSpeed, cut.model.tool.teeth).value;
  if (perSecond > 0.0) cut.feedPerTooth = Metres(profile->cut.nominalFeed.value / perSecond);
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

Result<CutFile> loadCutFile(const std::string& path, const milling::ModelParts& parts) {
  Result<CutFile> cut = load(path, parts);
  if (!cut || cut->model.material.exponent == 1.0 || !(cut->feedPerTooth.value > 0.0)) return cut;
  const Metres chip = milling::meanChip(cut->model.engagement, cut->feedPerTooth);
  cut->model.material = milling::linearisedAt(cut->model.material, chip);
  cut->remarks.push_back(message("the force is not proportional to the chip: taken as it is at the mean chip of %1 um",
                                 milling::numberText(std::round(1e7 * chip.value) / 10.0)));
  return cut;
}

}  // namespace stillcut::app
