// AnalogMap: which analog output stands for which override, with its calibration. A TOML file; resources/machines has
// examples for the published machines.
//   version = 1
//   label = "Hand terminal"
//   [device]   file = "/dev/comedi0", subdevice, range
//   [speed]    channel, meaning = "percent" | "rpm", table = [[volts, value], ...]      either may be left out
//   [feed]     channel, table = [[volts, percent], ...]
// Thread: set-up; values afterwards.
#pragma once

#include <optional>
#include <string>

#include "core/cnc/analog/calibration_table.h"

namespace stillcut::cnc {

struct AnalogChannel {
  int channel = 0;
  bool absolute = false;  // the value is rev/min, else percent of the programmed value
  CalibrationTable table;
};

struct AnalogDevice {
  std::string file = "/dev/comedi0";
  int subdevice = 1;
  int range = 0;
};

struct AnalogMap {
  std::string label;
  AnalogDevice device;
  std::optional<AnalogChannel> speed, feed;
};

Result<AnalogMap> loadAnalogMap(const std::string& path);
// The same from text; `name` stands for the file.
Result<AnalogMap> parseAnalogMap(std::string_view content, const std::string& name);

}  // namespace stillcut::cnc
