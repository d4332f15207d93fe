// Where the scenarios, profiles, machine maps and the manual are: beside the installed program, or in the source tree.
#pragma once

#include <filesystem>

namespace stillcut::app {

// PREFIX/share/stillcut of the running program where that is a folder, so that an installed copy may be moved; else the
// source tree this program was built from. Not real-time.
std::filesystem::path resourceFolder();

}  // namespace stillcut::app
