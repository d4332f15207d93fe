#include "core/cnc/registry.h"

#include <array>
#include <string>

#include "core/cnc/simulated_machine.h"

namespace stillcut::cnc {

namespace {

Result<std::unique_ptr<CncLink>> makeSimulated(const LinkRequest& r) {
  if (r.scenario == nullptr) return Error{"link 'simulated'", "a scenario is needed", ""};
  return std::unique_ptr<CncLink>(std::make_unique<SimulatedMachine>(*r.scenario, r.port));
}

constexpr std::array<LinkEntry, 1> kLinks{{
    {"simulated", "The control of the simulated mill; the only one that takes commands from a replay", makeSimulated},
}};

}  // namespace

std::span<const LinkEntry> linkTable() {
  return kLinks;
}

Result<std::unique_ptr<CncLink>> makeLink(std::string_view id, const LinkRequest& request) {
  std::string known;
  for (const LinkEntry& e : kLinks) {
    if (e.id == id) return e.make(request);
    known += (known.empty() ? "" : ", ") + std::string(e.id);
  }
  return Error{"link", "'" + std::string(id) + "' is not known", "known: " + known};
}

}  // namespace stillcut::cnc
