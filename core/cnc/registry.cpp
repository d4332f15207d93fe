#include "core/cnc/registry.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include "core/cnc/grbl/grbl_link.h"
#include "core/cnc/linuxcnc/linuxcnc_link.h"
#include "core/cnc/modbus/modbus_link.h"
#include "core/cnc/modbus/register_map.h"
#include "core/cnc/sender/sender_wire.h"
#include "core/cnc/simulated_machine.h"
#include "core/cnc/wire_number.h"
#include "core/config/component_settings.h"

namespace stillcut::cnc {

namespace {

Result<std::unique_ptr<CncLink>> makeSimulated(const LinkRequest& r) {
  const config::ComponentSettings settings(r.settings, "link 'simulated'", r.asked);
  if (Status known = settings.finish(); !known) return known.error();
  if (r.scenario == nullptr) return Error{message("link 'simulated'"), message("a scenario is needed")};
  return std::unique_ptr<CncLink>(std::make_unique<SimulatedMachine>(*r.scenario, r.port));
}

Status realMachine(const LinkRequest& r, const std::string& where) {
  if (!r.wires || r.clock == nullptr) return Error{where, message("there is no wire to a real machine here")};
  return Done{};
}

Result<std::unique_ptr<CncLink>> makeLinuxCnc(const LinkRequest& r) {
  const std::string where = "link 'linuxcnc'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  LinuxCncSettings s;
  s.rsh.host = settings.text("host", s.rsh.host);
  s.rsh.port = settings.whole("port", s.rsh.port, 1, 65535);
  s.hal.host = s.rsh.host;
  s.hal.port = settings.whole("hal_port", s.hal.port, 1, 65535);
  if (settings.has("status_port")) s.rsh.port = s.hal.port = settings.whole("status_port", 5009, 1, 65535);
  s.component.host = s.rsh.host;
  if (settings.has("hal_component_port")) s.component.port = settings.whole("hal_component_port", 5008, 1, 65535);
  s.adaptiveFeed = settings.flag("adaptive_feed", s.adaptiveFeed);
  s.inches = settings.flag("machine_in_inches", s.inches);
  s.password = settings.text("password", s.password);
  s.controlPassword = settings.text("control_password", s.controlPassword);
  s.lowestSpeed = settings.whole("lowest_speed_percent", s.lowestSpeed, 1, 100);
  s.highestSpeed = settings.whole("highest_speed_percent", s.highestSpeed, 100, 400);
  s.lowestFeed = settings.whole("lowest_feed_percent", s.lowestFeed, 0, 100);
  s.highestFeed = settings.whole("highest_feed_percent", s.highestFeed, 100, 400);
  if (Status known = settings.finish(); !known) return known.error();
  if (Status real = realMachine(r, where); !real) return real.error();
  if (s.adaptiveFeed && s.component.port == 0) {
    return Error{where, message("'adaptive_feed' needs 'hal_component_port'"), message("it goes through stillcut-hal")};
  }
  if (settings.has("status_port") && s.component.port == 0) {
    return Error{where, message("'status_port' needs 'hal_component_port'"),
                 message("stillcut-status only tells; the overrides go through stillcut-hal")};
  }
  LinuxCncLink::Wires wires;
  const WireAddress& control = s.component.port > 0 ? s.component : s.rsh;
  for (auto [wire, address] : {std::pair{&wires.control, &control}, {&wires.watch, &s.rsh}, {&wires.hal, &s.hal}}) {
    auto made = r.wires(*address);
    if (!made) return made.error();
    *wire = std::move(made).value();
  }
  return std::unique_ptr<CncLink>(std::make_unique<LinuxCncLink>(s, std::move(wires), *r.clock));
}

Result<std::unique_ptr<CncLink>> makeGrbl(const LinkRequest& r) {
  const std::string where = "link 'grbl'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  GrblSettings s;
  SenderSettings sender;
  s.sender = settings.flag("sender", false);
  if (s.sender) {
    sender.host = settings.text("host", sender.host);
    sender.port = settings.text("sender_port", "");
    sender.name = settings.text("sender_name", "");
    sender.password = settings.text("sender_password", "");
    s.wire = {.host = sender.host, .port = settings.whole("port", 8000, 1, 65535), .device = {}};
  } else if (settings.has("host")) {
    s.wire = {.host = settings.text("host", ""), .port = settings.whole("port", 23, 1, 65535), .device = {}};
  } else {
    s.wire.device = settings.text("device", s.wire.device);
    s.wire.baud = settings.whole("baud", s.wire.baud, 1200, 4'000'000);
  }
  s.inches = settings.flag("reports_in_inches", s.inches);
  s.askWords = settings.flag("ask_words", s.askWords);
  if (Status known = settings.finish(); !known) return known.error();
  if (Status real = realMachine(r, where); !real) return real.error();
  auto wire = r.wires(s.wire);
  if (!wire) return wire.error();
  if (s.sender) {
    wire = std::unique_ptr<ByteChannel>(std::make_unique<SenderWire>(sender, std::move(wire).value(), *r.clock));
  }
  return std::unique_ptr<CncLink>(std::make_unique<GrblLink>(s, std::move(wire).value(), *r.clock));
}

Result<std::unique_ptr<CncLink>> makeModbus(const LinkRequest& r) {
  const std::string where = "link 'modbus'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  const std::string file = settings.text("map", "");
  if (Status known = settings.finish(); !known) return known.error();
  if (file.empty())
    return Error{where, message("'map' is missing"), message("it names the file with the machine's registers")};
  auto map = loadRegisterMap((std::filesystem::path(r.folder) / file).string());
  if (!map) return map.error();
  if (Status real = realMachine(r, where); !real) return real.error();
  if (!r.buses)
    return Error{where, message("Modbus is not part of this build"), message("configure with STILLCUT_DESKTOP=ON")};
  auto bus = r.buses(map->bus, *r.clock);
  if (!bus) return bus.error();
  return std::unique_ptr<CncLink>(
      std::make_unique<ModbusLink>(std::move(map).value(), std::move(bus).value(), *r.clock));
}

Result<std::unique_ptr<CncLink>> makeAnalog(const LinkRequest& r) {
  const std::string where = "link 'analog'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  const std::string file = settings.text("map", "");
  if (Status known = settings.finish(); !known) return known.error();
  if (file.empty())
    return Error{where, message("'map' is missing"), message("it names the file with outputs and calibration tables")};
  if (r.programmedSpeed.value <= 0.0 || r.programmedFeed.value <= 0.0) {
    return Error{where, message("[cut] speed_rpm or feed_mm_min is missing"),
                 message("such a machine tells nothing of its program")};
  }
  auto map = loadAnalogMap((std::filesystem::path(r.folder) / file).string());
  if (!map) return map.error();
  std::unique_ptr<AnalogOutput> output = r.analog ? r.analog() : nullptr;
  if (!output)
    return Error{where, message("analog outputs are not part of this build"),
                 message("install libcomedi-dev and build again")};
  return std::unique_ptr<CncLink>(
      std::make_unique<AnalogLink>(std::move(map).value(), std::move(output), r.programmedSpeed, r.programmedFeed));
}

constexpr std::array<LinkEntry, 5> kLinks{{
    {"simulated", "The control of the simulated mill; the only one that takes commands from a replay", makeSimulated},
    {"linuxcnc", "LinuxCNC through linuxcncrsh and halrmt: host, port, hal_port", makeLinuxCnc},
    {"grbl", "GRBL 1.1 or grblHAL on a serial port or a host: device, baud; host, port", makeGrbl},
    {"modbus", "A spindle drive or PLC by Modbus TCP or RTU: map, a file of registers", makeModbus},
    {"analog", "Override voltages through a Comedi card: map, a file of calibration tables", makeAnalog},
}};

bool isDelay(const std::string& text) {
  const auto ms = wireNumber(text);
  return ms && *ms >= 0.0;
}

}  // namespace

Seconds savedDelay(const std::map<std::string, std::string>& settings, std::string_view which) {
  const auto text = settings.find(std::string(which));
  return text != settings.end() && isDelay(text->second) ? Seconds(1e-3 * *wireNumber(text->second)) : Seconds();
}

void saveDelay(std::map<std::string, std::string>& settings, std::string_view which, Seconds delay) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", 1e3 * delay.value);
  settings[std::string(which)] = text.data();
}

std::span<const LinkEntry> linkTable() {
  return kLinks;
}

Result<std::unique_ptr<CncLink>> makeLink(std::string_view id, const LinkRequest& request) {
  std::string known;
  for (const LinkEntry& e : kLinks) {
    if (e.id == id) {
      LinkRequest its = request;
      for (const std::string_view which : {kSavedDelay, kSavedEffect}) {
        const auto delay = its.settings.extract(std::string(which));
        if (delay.empty() || isDelay(delay.mapped())) continue;
        return Error{"link '" + std::string(id) + "'", message("'%1' is no delay", which), foreign(delay.mapped())};
      }
      return e.make(its);
    }
    known += (known.empty() ? "" : ", ") + std::string(e.id);
  }
  return Error{message("link"), message("'%1' is not known", id), message("known: %1", known)};
}

}  // namespace stillcut::cnc
