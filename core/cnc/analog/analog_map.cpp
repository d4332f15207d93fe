#include "core/cnc/analog/analog_map.h"

#include "core/config/toml_reader.h"

namespace stillcut::cnc {
namespace {

using config::TomlReader;
using config::TomlTable;

constexpr double kFastestSpindle = 1e6;  // rev/min
constexpr double kMostPercent = 400.0;

std::optional<AnalogChannel> readChannel(const TomlTable& root, const char* name, bool mayBeAbsolute,
                                         std::optional<Error>& wrong) {
  const TomlTable table = root.tableOr(name);
  if (!table.present()) return std::nullopt;
  const int channel = table.integer("channel", 0, 255);
  const bool absolute = mayBeAbsolute && table.choiceOr("meaning", 0, {"percent", "rpm"}) == 1;
  std::vector<CalibrationTable::Point> points;
  for (const std::vector<double>& row : table.rows("table")) {
    if (row.size() != 2) {
      table.refuse("table", message("has a row of %1 numbers", std::to_string(row.size())), message("[volts, value]"));
      return std::nullopt;
    }
    points.push_back({row[0], row[1]});
  }
  auto calibration = CalibrationTable::make(std::move(points), table.place("table"));
  if (!calibration) {
    if (!wrong) wrong = calibration.error();
    return std::nullopt;
  }
  const double most = absolute ? kFastestSpindle : kMostPercent;
  if (calibration->lowest() < 0.0 || calibration->highest() > most) {
    table.refuse("table", message("leaves what a machine can do"),
                 absolute ? message("0 to 1000000 rpm") : message("0 to 400 %"));
  }
  if (!absolute && (calibration->lowest() > 100.0 || calibration->highest() < 100.0)) {
    table.refuse("table", message("does not hold 100 %"), message("the programmed value must be reachable"));
  }
  return AnalogChannel{channel, absolute, std::move(calibration).value()};
}

Result<AnalogMap> read(TomlReader in) {
  AnalogMap map;
  std::optional<Error> wrong;
  const TomlTable root = in.root();
  root.integer("version", 1, 1);
  map.label = root.textOr("label", "Analog override");
  const TomlTable device = root.tableOr("device");
  map.device.file = device.textOr("file", map.device.file);
  map.device.subdevice = device.integerOr("subdevice", map.device.subdevice, 0, 63);
  map.device.range = device.integerOr("range", map.device.range, 0, 63);
  map.speed = readChannel(root, "speed", true, wrong);
  map.feed = readChannel(root, "feed", false, wrong);
  if (!map.speed && !map.feed && !wrong)
    root.refuse("speed", message("is missing, and so is 'feed'"), message("one of them is needed"));
  if (map.speed && map.feed && map.speed->channel == map.feed->channel) {
    root.refuse("feed", message("has the channel of 'speed'"), message("each override has an output of its own"));
  }
  if (Status done = in.finish(); !done) return done.error();
  if (wrong) return *wrong;
  return map;
}

}  // namespace

Result<AnalogMap> loadAnalogMap(const std::string& path) {
  return read(TomlReader::file(path));
}

Result<AnalogMap> parseAnalogMap(std::string_view content, const std::string& name) {
  return read(TomlReader::text(content, name));
}

}  // namespace stillcut::cnc
