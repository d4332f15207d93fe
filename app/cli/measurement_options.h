// What commands share that measure a sensor: from a recording of it, or from the device of a profile that is then set
// right.
// Thread: main; hearing waits for the device.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/compose/rig.h"
#include "core/base/result.h"
#include "core/config/profile.h"
#include "core/daq/measured_samples.h"
#include "core/formats/recording_reader.h"

namespace stillcut::app {

struct MeasurementOptions {
  std::string recording, profile;  // one of them
  double seconds = 5.0;
  bool save = false;  // in the profile
};

// RECORDING, --profile and --seconds; `heard`: "the tone".
void addMeasurementOptions(CLI::App& command, MeasurementOptions& o, const std::string& heard);
// `heard`: "tone"; `whose`: the machine of the profile.
Status checkMeasurementOptions(const MeasurementOptions& o, const std::string& command, const std::string& heard,
                               const std::string& whose);
// The profile that is named; an empty one where a recording is.
Result<config::Profile> profileOf(const MeasurementOptions& o, const config::ParamCatalog& catalog);
// From the recording, or all channels of the profile's device, which has to have `channel`. `fault`: as of
// measureDevice().
Result<daq::MeasuredSamples> measure(const MeasurementOptions& o, const config::Profile& profile,
                                     const record::ReadOptions& reading, int channel, SetUpFault& fault);
// Writes the profile back and says so; the exit code.
int saveProfileOf(const MeasurementOptions& o, const config::Profile& profile, const config::ParamCatalog& catalog);
// The same for a profile that has no such [[channels]].
int failWithoutChannels(const MeasurementOptions& o);

}  // namespace stillcut::app
