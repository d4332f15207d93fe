// stillcut-cli devices: the devices samples can come from and the machine links commands can go to, by their ids, and
// what is plugged in, with its ranges.

#include <cstdio>
#include <vector>

#include "app/cli/command.h"
#include "app/io/alsa_driver.h"
#include "app/io/iio_driver.h"
#include "core/cnc/registry.h"
#include "core/daq/registry.h"

namespace stillcut::app {
namespace {

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

}  // namespace

void addDevices(CLI::App& app, int& exitCode) {
  CLI::App* command = app.add_subcommand("devices", "List the devices and machine links a profile can name");
  command->callback([&exitCode] {
    print("sources", daq::sourceTable());
    printFound("audio-class devices here", alsaDevices());
    printFound("industrial I/O devices here", iioDevices("local:"));
    print("links", cnc::linkTable());
    exitCode = kExitDone;
  });
}

}  // namespace stillcut::app
