#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "app/compose/recording_rig.h"

namespace stillcut::app {
namespace {

bool parseRow(const std::string& line, double& t, double& rpm) {
  const char* end = line.data() + line.size();
  const auto first = std::from_chars(line.data(), end, t);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return false;
  const auto second = std::from_chars(first.ptr + 1, end, rpm);
  return second.ec == std::errc{} && second.ptr == end && std::isfinite(t) && std::isfinite(rpm);
}

}  // namespace

Result<std::vector<pipeline::SpeedLogSource::Point>> readSpeedLog(const std::string& path) {
  std::ifstream in(path);
  if (!in) return Error{path, message("cannot be read"), foreign(std::strerror(errno))};
  std::vector<pipeline::SpeedLogSource::Point> log;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::string place = path + ":" + std::to_string(number);
    if (number == 1) {
      if (line != "t,rpm")
        return Error{place, message("the header is not 't,rpm'"), message("a row is a time in s and a speed in rpm")};
      continue;
    }
    if (line.empty()) continue;
    double t = 0.0;
    double rpm = 0.0;
    if (!parseRow(line, t, rpm)) return Error{place, message("'%1' is not a time and a speed", line)};
    if (rpm <= 0.0) return Error{place, message("the speed must be above zero")};
    if (!log.empty() && t <= log.back().time.value) return Error{place, message("the time does not rise")};
    log.push_back({Seconds(t), Rpm(rpm)});
  }
  if (log.empty()) return Error{path, message("holds no speeds")};
  return log;
}

}  // namespace stillcut::app
