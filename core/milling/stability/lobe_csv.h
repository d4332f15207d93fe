// Limits as the table `stillcut-cli lobes --out` writes:
// speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz. A speed without a limit has crossing 0, an empty
// depth and the kind "none".
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {

std::string lobeCsv(const LobeSweep& sweep);
Status saveLobeCsv(const LobeSweep& sweep, const std::string& path);  // whole or not at all

}  // namespace stillcut::milling
