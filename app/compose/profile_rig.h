// A rig from a machine's profile: its device, its link, its methods and limits. Live.
// Thread: set-up.
#pragma once

#include <memory>

#include "app/compose/rig.h"
#include "app/io/kept_link.h"
#include "core/cnc/registry.h"
#include "core/config/component_settings.h"
#include "core/config/profile.h"

namespace stillcut::app {

// Ids that a profile may name.
config::KnownIds knownIds();

// Device and link of a profile, made and not yet opened. A simulated pair shares its plant.
struct ProfileParts {
  std::shared_ptr<const Clock> clock;  // outlives both
  std::unique_ptr<daq::DaqSource> device;
  std::unique_ptr<cnc::CncLink> link;  // empty: no machine
};
// `asked`, where given, receives every setting the link asks for.
Result<ProfileParts> makeProfileParts(const config::Profile& profile, const std::string& path,
                                      std::vector<config::SettingDecl>* asked = nullptr,
                                      AnalogOutputs outputs = AnalogOutputs::Written);
// What the profile's link is made from, on real wires; files that settings name are looked for beside `path`. `clock`
// outlives the link.
cnc::LinkRequest linkRequest(const config::Profile& profile, const std::string& path, const Clock& clock,
                             AnalogOutputs outputs = AnalogOutputs::Written);

// The source "simulated" takes the setting `scenario`, a file; its machine is the link "simulated".
// `fault`: as for Rig::build.
Result<std::unique_ptr<Rig>> buildProfileRig(const config::Profile& profile, const std::string& path,
                                             SetUpFault* fault = nullptr);

// The profile as a recording tells what it was made from: files that are named beside `path` by their whole path, for
// the recording lies elsewhere.
std::string profileOrigin(const config::Profile& profile, const std::string& path);
// The file of the cut's modes, as above; empty: it names none.
std::string modelFile(const config::Profile& profile, const std::string& path);

// Before the first step: `rig` is recorded below the profile's folder, if it names one. `told`: see Rig::recordInto.
Status recordAsProfileSays(Rig& rig, const config::Profile& profile, const std::string& path,
                           std::function<void(const record::Deleted&)> told);
// Where that is; empty: nowhere.
std::string recordingFolder(const config::Profile& profile, const std::string& path);

}  // namespace stillcut::app
