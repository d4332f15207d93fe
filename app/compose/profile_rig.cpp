#include "app/compose/profile_rig.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "app/compose/known_lobes.h"
#include "app/compose/left_overrides.h"
#include "app/compose/resource_folder.h"
#include "app/io/alsa_driver.h"
#include "app/io/comedi_driver.h"
#include "app/io/comedi_output.h"
#include "app/io/iio_driver.h"
#include "app/io/wires.h"
#include "core/cnc/registry.h"
#include "core/control/registry.h"
#include "core/daq/registry.h"
#include "core/detect/registry.h"
#include "core/milling/simulation/scenario.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

// Files a profile names are looked for beside the profile, then among those that come with Stillcut.
std::string besideProfile(const std::string& file, const std::string& profilePath) {
  return foundFile(file, std::filesystem::path(profilePath).parent_path());
}

Result<std::optional<milling::Scenario>> scenarioOf(const config::Profile& profile, const std::string& path) {
  const auto setting = profile.source.settings.find("scenario");
  if (setting == profile.source.settings.end()) return std::optional<milling::Scenario>();
  auto scenario = milling::loadScenario(besideProfile(setting->second, path));
  if (!scenario) return scenario.error();
  return std::optional(std::move(scenario).value());
}

}  // namespace

config::KnownIds knownIds() {
  config::KnownIds known;
  for (const auto& row : daq::sourceTable()) known.sources.push_back(row.id);
  for (const auto& row : cnc::linkTable()) known.links.push_back(row.id);
  for (const auto& row : detect::detectorTable()) known.detectors.push_back(row.id);
  for (const auto& row : control::strategyTable()) known.strategies.push_back(row.id);
  known.actives = {"alsa"};
  return known;
}

cnc::LinkRequest linkRequest(const config::Profile& profile, const std::string& path, const Clock& clock,
                             AnalogOutputs outputs) {
  cnc::LinkRequest request;
  request.settings = profile.link.settings;
  request.folder = std::filesystem::path(path).parent_path().string();
  if (const auto map = request.settings.find("map"); map != request.settings.end()) {
    const std::string file = besideProfile(map->second, path);
    if (std::filesystem::path(file).is_absolute()) map->second = file;  // ours, or as given
  }
  request.wires = makeWire;
  request.buses = busMaker();
  request.analog = outputs == AnalogOutputs::Written ? makeComediOutput : makeSilentOutput;
  request.programmedSpeed = profile.cut.nominalSpeed;
  request.programmedFeed = profile.cut.nominalFeed;
  request.clock = &clock;
  return request;
}

Result<ProfileParts> makeProfileParts(const config::Profile& profile, const std::string& path,
                                      std::vector<config::SettingDecl>* asked, AnalogOutputs outputs) {
  if (profile.source.id.empty()) return Error{path, message("'source.id' is missing"), message("a run needs a device")};
  auto scenario = scenarioOf(profile, path);
  if (!scenario) return scenario.error();
  const milling::Scenario* simulated = *scenario ? &**scenario : nullptr;
  auto port = std::make_shared<milling::PlantPort>();

  ProfileParts parts;
  const auto clock = std::make_shared<SteadyClock>();
  parts.clock = clock;
  daq::SourceRequest source;
  source.scenario = simulated;
  source.port = port;
  source.pace.realTime = true;
  source.settings = profile.source.settings;
  if (const auto file = source.settings.find("file"); file != source.settings.end()) {
    file->second = besideProfile(file->second, path);
  }
  source.channels = profile.cut.channels;
  source.wires = makeWire;
  source.pcm = makeAlsaDriver;
  source.iio = makeIioDriver;
  source.comedi = makeComediDriver;
  source.clock = clock.get();
  auto device = daq::makeSource(profile.source.id, source);
  if (!device) return device.error();
  parts.device = std::move(device).value();
  if (profile.link.id.empty()) return parts;
  cnc::LinkRequest request = linkRequest(profile, path, *clock, outputs);
  request.scenario = simulated;
  request.port = port;
  request.asked = asked;
  auto link = makeKeptLink(profile.link.id, request, outputs);
  if (!link) return link.error();
  parts.link = std::move(link).value();
  return parts;
}

Result<std::unique_ptr<Rig>> buildProfileRig(const config::Profile& profile, const std::string& path,
                                             SetUpFault* fault) {
  auto parts = makeProfileParts(profile, path);
  if (!parts) return parts.error();
  RigSpec spec;
  spec.device = std::move(parts->device);
  spec.clock = std::move(parts->clock);
  spec.left = std::make_shared<cnc::SentOverridesCell>();
  spec.link = remembered(std::move(parts->link), profile, defaultLeftFolder().string(), spec.left);
  spec.linkEffect = cnc::savedDelay(profile.link.settings, cnc::kSavedEffect);
  spec.setup = profile.cut;
  auto known = stableSpeeds(profile, modelFile(profile, path));
  if (!known) return known.error();
  spec.setup.stableSpeeds = std::move(known).value();
  spec.params = profile.params;
  spec.autoAllowed = profile.allowAuto;
  spec.operatorName = profile.operatorName;
  spec.job = profile.recording.job;
  spec.methods.detectors = {profile.detector};
  if (!profile.fallback.empty() && profile.fallback != profile.detector) {
    spec.methods.detectors.push_back(profile.fallback);
    spec.methods.fallback = profile.fallback;
  }
  spec.methods.strategy = profile.strategy;
  spec.watched = true;
  return Rig::build(std::move(spec), fault);
}

std::string modelFile(const config::Profile& profile, const std::string& path) {
  return profile.model.empty() ? "" : besideProfile(profile.model, path);
}

std::string profileOrigin(const config::Profile& profile, const std::string& path) {
  config::Profile whole = profile;
  if (!whole.model.empty()) whole.model = std::filesystem::absolute(modelFile(profile, path)).string();
  return config::profileText(whole, pipeline::fullCatalog());
}

std::string recordingFolder(const config::Profile& profile, const std::string& path) {
  return profile.recording.folder.empty() ? "" : besideProfile(profile.recording.folder, path);
}

Status recordAsProfileSays(Rig& rig, const config::Profile& profile, const std::string& path,
                           std::function<void(const record::Deleted&)> told) {
  const std::string folder = recordingFolder(profile, path);
  if (folder.empty()) return Done{};
  return rig.recordInto(folder, profileOrigin(profile, path), std::move(told));
}

}  // namespace stillcut::app
