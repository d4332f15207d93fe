// The shop's tools in one TOML file of the user's data folder. Thread: GUI; small file.
//   [[tool]]  name, holder, teeth, diameter_mm, pitch, modes, material, response, stick_out_mm, deepest_mm,
//   lowest_speed_rpm,
//             highest_speed_rpm, notes
//   [[tool.chattered]]  speed_rpm, depth_mm, frequency_hz, note      "chattered here before"
//   [[tool.history]]  day, what
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/facade/tool_entry.h"

namespace stillcut::app {

// No file: no tools. What cannot be read is an error with its place.
Result<std::vector<ui::ToolEntry>> loadTools(const std::string& path);
// Whole or not at all.
Status saveTools(const std::vector<ui::ToolEntry>& tools, const std::string& path);

// Whether a file holds modes, alone or in a whole cut; or a frequency response, or hammer records that give one. One
// line where it does not.
Status checkModesFile(const std::string& path);
Status checkResponseFile(const std::string& path);

}  // namespace stillcut::app
