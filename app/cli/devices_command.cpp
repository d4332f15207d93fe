// stillcut-cli devices: the devices samples can come from and the machine links commands can go to, by their ids; finds
// what is plugged in or reachable, and tries a link step by step. It moves nothing unless --measure-effect asks for it.

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/compose/effect_trial.h"
#include "app/compose/ending/interruption.h"
#include "app/compose/profile_rig.h"
#include "app/io/alsa_driver.h"
#include "app/io/comedi_driver.h"
#include "app/io/find_machines.h"
#include "app/io/iio_driver.h"
#include "app/io/kept_link.h"
#include "app/io/wires.h"
#include "core/cnc/link_trial.h"
#include "core/cnc/registry.h"
#include "core/daq/device_messages.h"
#include "core/daq/registry.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

constexpr Seconds kFindTime{0.5};

struct DeviceOptions {
  bool find = false, save = false, effect = false;
  std::vector<std::string> hosts, with, iio;
  std::string link, profile;
};

template <class Table>
void print(const char* heading, const Table& table) {
  std::printf("%s\n", heading);
  for (const auto& row : table) {
    std::printf("  %-14.*s %.*s\n", static_cast<int>(row.id.size()), row.id.data(),
                static_cast<int>(row.description.size()), row.description.data());
  }
}

void printFound(const char* heading, const std::vector<daq::PcmDevice>& devices) {
  std::printf("%s\n", heading);
  for (const daq::PcmDevice& d : devices) {
    std::printf("  %-14s %s: %s\n", d.name.c_str(), d.label.c_str(), d.range.c_str());
  }
  if (devices.empty()) std::printf("  none\n");
}

void printPorts() {
  std::printf("serial ports here, for the source 'serial' (any other path can be named)\n");
  const auto ports = serialPorts();
  for (const SerialPort& p : ports) {
    std::printf("  %-14s %s: 1200 to 12000000 baud\n", p.device.c_str(), p.label.c_str());
  }
  if (ports.empty()) std::printf("  none\n");
}

// Here, where libiio finds some on USB and the network, and where one was named.
int printIio(const std::vector<std::string>& named) {
  const auto here = iioDevices("local:");
  printFound("industrial I/O devices here", here ? *here : std::vector<daq::PcmDevice>());
  int code = kExitDone;
  std::vector<std::string> contexts = iioContexts();
  contexts.insert(contexts.end(), named.begin(), named.end());
  for (const std::string& uri : contexts) {
    const auto devices = iioDevices(uri);
    if (devices) {
      printFound(("industrial I/O devices, uri = \"" + uri + "\"").c_str(), *devices);
    } else {
      code = fail(devices.error(), kExitDevice);
    }
  }
  return code;
}

int find(const DeviceOptions& o) {
  std::vector<std::string> hosts{"localhost"};
  for (const std::string& typed : o.hosts) {
    const auto more = hostsIn(typed);
    if (!more) return fail(more.error());
    hosts.insert(hosts.end(), more->begin(), more->end());
  }
  const auto found = findMachines(hosts, kFindTime);
  for (const FoundMachine& f : found) std::printf("%-20s %s\n", f.where.c_str(), f.what.c_str());
  if (found.empty()) std::puts("nothing found");
  return kExitDone;
}

// The profile with the link to try.
Result<config::Profile> wanted(const DeviceOptions& o, const config::ParamCatalog& catalog) {
  config::Profile profile;
  if (!o.profile.empty()) {
    auto loaded = config::loadProfile(o.profile, catalog, knownIds());
    if (!loaded) return loaded.error();
    profile = std::move(loaded).value();
  }
  if (!o.link.empty() && o.link != profile.link.id) profile.link = {};
  if (!o.link.empty()) profile.link.id = o.link;
  if (profile.link.id.empty()) return Error{o.profile, message("'link.id' is missing"), message("name one with --try")};
  for (const std::string& pair : o.with) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string::npos || equals == 0) return Error{"--with " + pair, message("is not KEY=VALUE")};
    profile.link.settings[pair.substr(0, equals)] = pair.substr(equals + 1);
  }
  return profile;
}

bool printEffect(const EffectTrial& moved) {
  if (!moved.problem.empty()) {
    std::printf("no   Measure the effect: %s\n", moved.problem.c_str());
    return false;
  }
  std::printf("ok   Measure the effect: an order acts after %.1f ms, seen in %d moves\n", 1e3 * moved.effect.value,
              moved.moves);
  return true;
}

int tryLink(const DeviceOptions& o) {
  if (o.save && o.profile.empty())
    return fail(Error{"--save", message("needs --profile"), message("that is where it is saved")});
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  auto profile = wanted(o, catalog);
  if (!profile) return fail(profile.error());
  const auto events = wireEvents();  // outlives the link and its wires
  const SteadyClock clock;
  auto link = makeKeptLink(profile->link.id, linkRequest(*profile, o.profile, clock, AnalogOutputs::LeftAlone),
                           AnalogOutputs::LeftAlone);
  if (!link) return fail(link.error());
  mindInterruption();
  cnc::LinkTrial trial(**link, clock);
  const Seconds before = cnc::savedDelay(profile->link.settings, cnc::kSavedDelay);
  const Seconds effect = cnc::savedDelay(profile->link.settings, cnc::kSavedEffect);
  trial.proved(effect);
  Seconds measured{};
  while (!interrupted()) {
    // An order is tried before it is said what orders can do.
    if (o.effect && trial.atLast()) {
      const EffectTrial moved = measureEffect(**link, clock, interrupted);
      if (!printEffect(moved)) return kExitDevice;
      measured = moved.effect;
      trial.proved(measured);
    }
    if (!trial.next()) break;
    const cnc::LinkTrialStep& step = trial.steps().back();
    std::printf("%-4s %s: %s\n", step.good ? "ok" : "no", step.what.c_str(), text(step.said).c_str());
    std::fflush(stdout);
  }
  if (interrupted()) std::puts("no   interrupted");
  if (interrupted() || !trial.passed()) return kExitDevice;
  if (before.value > 0.0) std::printf("     a look took %.2f ms when this was saved\n", 1e3 * before.value);
  if (effect.value > 0.0) std::printf("     an order took %.1f ms to act in the last run\n", 1e3 * effect.value);
  if (!o.save) return kExitDone;
  if (const auto port = profile->link.settings.find("device"); port != profile->link.settings.end())
    port->second = lastingName(port->second);
  cnc::saveDelay(profile->link.settings, cnc::kSavedDelay, trial.look());
  if (measured.value > 0.0) cnc::saveDelay(profile->link.settings, cnc::kSavedEffect, measured);
  if (const Status written = config::saveProfile(*profile, catalog, o.profile); !written) return fail(written.error());
  std::printf("saved in %s\n", o.profile.c_str());
  return kExitDone;
}

int run(const DeviceOptions& o) {
  if (!o.link.empty() || !o.profile.empty()) return tryLink(o);
  if (o.find || !o.hosts.empty()) return find(o);
  for (const auto& [given, name] :
       {std::pair{o.save, "--save"}, {o.effect, "--measure-effect"}, {!o.with.empty(), "--with"}}) {
    if (given) return fail(Error{name, message("needs --try or --profile")});
  }
  print("sources", daq::sourceTable());
  printFound("audio-class devices here", alsaDevices());
  printFound("data acquisition cards here (Comedi)", comediDevices());
  const int code = printIio(o.iio);
  printPorts();
  std::printf("losses\n  %s: serial and tcp without a counter, iio without time stamps\n",
              text(daq::uncounted()).c_str());
  print("links", cnc::linkTable());
  return code;
}

}  // namespace

void addDevices(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<DeviceOptions>();
  CLI::App* command = app.add_subcommand("devices", "List what a profile can name, find machines, try a link");
  command->add_flag("--find", o->find, "Look for serial ports, and for machines on this computer");
  command->add_option("--host", o->hosts, "Look there as well: a host, or a subnet as 192.168.1.0/24");
  command->add_option("--iio", o->iio, "List the industrial I/O devices there too: ip:HOST, usb:");
  command->add_option("--try", o->link, "Try this link step by step; nothing moves");
  command->add_option("--with", o->with, "A setting of the link, KEY=VALUE");
  command->add_option("--profile", o->profile, "Try the link of this profile (.toml)");
  command->add_flag(
      "--measure-effect", o->effect,
      "Then move both overrides to 95 % and back and see how long that takes: in air, with a program running");
  command->add_flag("--save", o->save, "Write the link into the profile once it has passed");
  command->callback([o, &exitCode] { exitCode = run(*o); });
}

}  // namespace stillcut::app
