// The libraries behind the drivers and wires of this build, with their versions. Thread: any.
#pragma once

#include <string>
#include <vector>

namespace stillcut::app {

// "ALSA 1.2.8": the version loaded, where the library can tell, else the one compiled against.
std::vector<std::string> deviceLibraries();

}  // namespace stillcut::app
