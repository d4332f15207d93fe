#include "app/cli/measurement_options.h"

#include <cstdio>

#include "app/cli/command.h"
#include "app/compose/measure_samples.h"
#include "app/compose/profile_rig.h"
#include "app/io/wires.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {

void addMeasurementOptions(CLI::App& command, MeasurementOptions& o, const std::string& heard) {
  command.add_option("RECORDING", o.recording,
                     "Recording of " + heard + "; left out: the device of --profile is measured");
  command.add_option("--profile", o.profile, "Listen to the device of this profile (.toml)");
  command.add_option("--seconds", o.seconds, "How long, from 2 to 60")->capture_default_str();
}

Status checkMeasurementOptions(const MeasurementOptions& o, const std::string& command, const std::string& heard,
                               const std::string& whose) {
  if (o.recording.empty() == o.profile.empty()) {
    return Error{
        command,
        o.recording.empty() ? message("nothing to measure") : message("both a recording and a profile are named"),
        message("name a RECORDING of the %1, or --profile of the machine %2", heard, whose)};
  }
  if (o.save && o.profile.empty())
    return Error{"--save", message("needs --profile"), message("that is where it is saved")};
  if (!(o.seconds >= 2.0 && o.seconds <= 60.0)) return Error{"--seconds", message("must be from 2 to 60")};
  return Done{};
}

Result<config::Profile> profileOf(const MeasurementOptions& o, const config::ParamCatalog& catalog) {
  if (o.profile.empty()) return config::Profile{};
  return config::loadProfile(o.profile, catalog, knownIds());
}

Result<daq::MeasuredSamples> measure(const MeasurementOptions& o, const config::Profile& profile,
                                     const record::ReadOptions& reading, int channel, SetUpFault& fault) {
  const auto events = wireEvents();  // outlives the source and its wires
  fault = SetUpFault::Input;
  if (o.profile.empty()) return measureRecording(o.recording, reading);
  return measureDevice(profile, o.profile, channel, Seconds(o.seconds), fault);
}

int saveProfileOf(const MeasurementOptions& o, const config::Profile& profile, const config::ParamCatalog& catalog) {
  if (const Status saved = config::saveProfile(profile, catalog, o.profile); !saved) return fail(saved.error());
  std::printf("saved in %s\n", o.profile.c_str());
  return kExitDone;
}

int failWithoutChannels(const MeasurementOptions& o) {
  return fail(
      Error{o.profile, message("has no [[channels]] to save it in"), message("a simulated source has its own")});
}

}  // namespace stillcut::app
