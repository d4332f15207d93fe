// The machine links there are, in one table. A link is a header, a source, a test and one line here.
// Thread: set-up.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/cnc/analog/analog_link.h"
#include "core/cnc/byte_channel.h"
#include "core/cnc/cnc_link.h"
#include "core/cnc/modbus/register_bus.h"
#include "core/config/component_settings.h"
#include "core/milling/simulation/plant_port.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::cnc {

// What a link may need to be made; each takes its part.
struct LinkRequest {
  const milling::Scenario* scenario = nullptr;  // simulated
  std::shared_ptr<milling::PlantPort> port;
  std::map<std::string, std::string> settings;            // of the profile's [link.settings]
  std::string folder;                                     // files that settings name are looked for here
  WireMaker wires;                                        // real machines
  BusMaker buses;                                         // Modbus machines
  std::function<std::unique_ptr<AnalogOutput>()> analog;  // may give null
  Rpm programmedSpeed{};                                  // of the profile, for machines that do not tell
  MetresPerSecond programmedFeed{};
  const Clock* clock = nullptr;                       // real machines; outlives the link
  std::vector<config::SettingDecl>* asked = nullptr;  // told of every setting the link asks for
};

struct LinkEntry {
  std::string_view id;           // "simulated"
  std::string_view description;  // one line for `devices` and the settings page
  Result<std::unique_ptr<CncLink>> (*make)(const LinkRequest& request);
};

// The settings every link may have, ms. How long a look at the machine took when the link was tried: for the next trial
// to compare with. How long an order took to act in the last run: until the next one has measured it anew.
inline constexpr std::string_view kSavedDelay = "delay_ms", kSavedEffect = "effect_ms";
// 0: there is none, or it is no delay (which makeLink() refuses).
Seconds savedDelay(const std::map<std::string, std::string>& settings, std::string_view which);
void saveDelay(std::map<std::string, std::string>& settings, std::string_view which, Seconds delay);

std::span<const LinkEntry> linkTable();
// Unknown id: an error that names the known ones.
Result<std::unique_ptr<CncLink>> makeLink(std::string_view id, const LinkRequest& request);

}  // namespace stillcut::cnc
