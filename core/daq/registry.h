// The devices there are, in one table. A device is a header, a source, a test and one line here.
// Thread: set-up.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/daq/daq_source.h"
#include "core/daq/simulated_source.h"

namespace stillcut::daq {

// What a source may need to be made; each takes its part.
struct SourceRequest {
  const milling::Scenario* scenario = nullptr;  // simulated
  std::uint64_t seed = 0;
  std::shared_ptr<milling::PlantPort> port;
  SimulatedPace pace;
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
