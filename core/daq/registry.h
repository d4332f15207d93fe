// The devices there are, in one table. A device is a header, a source, a test and one line here.
// Thread: set-up.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_channel.h"
#include "core/base/time.h"
#include "core/config/component_settings.h"
#include "core/daq/daq_source.h"
#include "core/daq/pcm_driver.h"
#include "core/daq/simulated/simulated_source.h"

namespace stillcut::daq {

// What a source may need to be made; each takes its part.
struct SourceRequest {
  const milling::Scenario* scenario = nullptr;  // simulated
  std::uint64_t seed = 0;
  std::shared_ptr<milling::PlantPort> port;
  SimulatedPace pace;
  std::map<std::string, std::string> settings;      // of the profile's [source.settings]
  std::vector<ChannelInfo> channels;                // of the profile
  WireMaker wires;                                  // serial lines and sockets
  std::function<std::unique_ptr<PcmDriver>()> pcm;  // audio-class devices; may give null
  // IIO devices at an address, with a trigger; may give null.
  std::function<std::unique_ptr<PcmDriver>(const std::string& uri, const std::string& trigger)> iio;
  // Comedi cards; reference: 0 ground, 1 common, 2 differential; may give null.
  std::function<std::unique_ptr<PcmDriver>(int range, int reference)> comedi;
  const Clock* clock = nullptr;                       // real devices; outlives the source
  std::vector<config::SettingDecl>* asked = nullptr;  // receives every setting the source asks for
};

struct SourceEntry {
  std::string_view id;           // "simulated"
  std::string_view description;  // one line for `devices` and the settings page
  Result<std::unique_ptr<DaqSource>> (*make)(const SourceRequest& request);
};

std::span<const SourceEntry> sourceTable();
// Unknown id: an error that names the known ones.
Result<std::unique_ptr<DaqSource>> makeSource(std::string_view id, const SourceRequest& request);

}  // namespace stillcut::daq
