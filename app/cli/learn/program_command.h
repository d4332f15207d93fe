// stillcut-cli learn program: the G-code of a guided trial.
#pragma once

#include "app/cli/command.h"

namespace stillcut::app {

void addTrialProgram(CLI::App& learn, int& exitCode);

}  // namespace stillcut::app
