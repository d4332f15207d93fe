#include "core/daq/registry.h"

#include <array>
#include <string>

namespace stillcut::daq {

namespace {

Result<std::unique_ptr<DaqSource>> makeSimulated(const SourceRequest& r) {
  if (r.scenario == nullptr) return Error{"source 'simulated'", "a scenario is needed", ""};
  return std::unique_ptr<DaqSource>(std::make_unique<SimulatedSource>(*r.scenario, r.seed, r.port, r.pace));
}

constexpr std::array<SourceEntry, 1> kSources{{
    {"simulated", "A simulated cut from a scenario file, in real time or as fast as possible", makeSimulated},
}};

}  // namespace

std::span<const SourceEntry> sourceTable() {
  return kSources;
}

Result<std::unique_ptr<DaqSource>> makeSource(std::string_view id, const SourceRequest& request) {
  std::string known;
  for (const SourceEntry& e : kSources) {
    if (e.id == id) return e.make(request);
    known += (known.empty() ? "" : ", ") + std::string(e.id);
  }
  return Error{"source", "'" + std::string(id) + "' is not known", "known: " + known};
}

}  // namespace stillcut::daq
