// stillcut-cli devices: the devices samples can come from and the machine links commands can go to, by their ids.

#include <cstdio>

#include "app/cli/command.h"
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

}  // namespace

void addDevices(CLI::App& app, int& exitCode) {
  CLI::App* command = app.add_subcommand("devices", "List the devices and machine links a profile can name");
  command->callback([&exitCode] {
    print("sources", daq::sourceTable());
    print("links", cnc::linkTable());
    exitCode = kExitDone;
  });
}

}  // namespace stillcut::app
