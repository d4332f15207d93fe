// stillcut-cli path: see path_command.cpp.
#pragma once

#include <CLI/CLI.hpp>

namespace stillcut::app {

// Adds the subcommand; its callback sets `exitCode`.
void addPath(CLI::App& app, int& exitCode);

}  // namespace stillcut::app
