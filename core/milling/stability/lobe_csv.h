// Limits as the table `stillcut-cli lobes --out` writes:
// speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz. A speed without a limit has crossing 0, an empty
// depth and the kind "none" when the whole depth was searched, "unknown" when not (LobeSweep::complete).
// Pure: any thread; set-up, not real-time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/stability/limit_band.h"
#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {

// With `bands`, one a speed, two columns more: depth_low_mm,depth_high_mm of the first limit.
std::string lobeCsv(const LobeSweep& sweep, std::span<const LimitBand> bands = {});
// The same with what the columns leave out: warnings, and for each speed how deep was searched and whether the argument
// principle agreed. {"case", "max_depth_mm", "warnings", "speeds": [{"speed_rpm", "searched_to_mm", "verified",
// "crossings": [{"depth_mm", "before", "after", "kind", "frequency_hz"}],
// "band_mm": [low, high]}]}; the band where there are bands.
std::string lobeJson(const LobeSweep& sweep, const std::string& name, std::span<const LimitBand> bands = {});
// In words: speeds with a limit and without, and those that could not be searched to the full depth.
std::vector<std::string> lobeSummary(const LobeSweep& sweep);
Status saveLobeCsv(const LobeSweep& sweep, const std::string& path,
                   std::span<const LimitBand> bands = {});  // whole or not at all

}  // namespace stillcut::milling
