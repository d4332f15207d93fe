// stillcut-cli learn margin: how far a recorded stable cut is from chatter.
#pragma once

#include "app/cli/command.h"

namespace stillcut::app {

void addMargin(CLI::App& learn, int& exitCode);

}  // namespace stillcut::app
