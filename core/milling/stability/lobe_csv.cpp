#include "core/milling/stability/lobe_csv.h"

#include <cstdio>

#include "core/base/atomic_file.h"

namespace stillcut::milling {

std::string lobeCsv(const LobeSweep& sweep) {
  std::string csv = "speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz\n";
  char line[200];
  for (const SpeedLimits& limits : sweep.speeds) {
    if (!limits.hasLimit()) {
      std::snprintf(line, sizeof line, "%.12g,0,,0,0,none,\n", limits.speed.value);
      csv += line;
    }
    for (const StabilityLimit& l : limits.crossings) {
      std::snprintf(line, sizeof line, "%.12g,%d,%.12g,%d,%d,%s,%.9g\n", l.speed.value, l.crossing, 1e3 * l.depth.value,
                    l.before, l.after, crossingName(l.kind), l.frequency.value);
      csv += line;
    }
  }
  return csv;
}

Status saveLobeCsv(const LobeSweep& sweep, const std::string& path) {
  return writeFileAtomically(path, lobeCsv(sweep));
}

}  // namespace stillcut::milling
