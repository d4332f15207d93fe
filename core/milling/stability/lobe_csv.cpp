#include "core/milling/stability/lobe_csv.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/json_schema.h"
#include "core/storage/atomic_file.h"

namespace stillcut::milling {

std::string lobeCsv(const LobeSweep& sweep, std::span<const LimitBand> bands) {
  std::string csv = "speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz";
  csv += bands.empty() ? "\n" : ",depth_low_mm,depth_high_mm\n";
  char line[200];
  for (std::size_t k = 0; k < sweep.speeds.size(); ++k) {
    const SpeedLimits& limits = sweep.speeds[k];
    std::string band;
    if (k < bands.size()) {
      std::snprintf(line, sizeof line, ",%.6g,%.6g", 1e3 * bands[k].low.value, 1e3 * bands[k].high.value);
      band = limits.searchedTo.value > 0.0 ? line : ",,";
    }
    if (!limits.hasLimit()) {
      std::snprintf(line, sizeof line, "%.12g,0,,0,0,%s,", limits.speed.value,
                    sweep.complete(limits) ? "none" : "unknown");
      csv += line + band + "\n";
    }
    for (const StabilityLimit& l : limits.crossings) {
      std::snprintf(line, sizeof line, "%.12g,%d,%.12g,%d,%d,%s,%.9g", l.speed.value, l.crossing, 1e3 * l.depth.value,
                    l.before, l.after, crossingName(l.kind), l.frequency.value);
      csv += line;
      if (!band.empty()) csv += l.crossing == 0 ? band : ",,";
      csv += "\n";
    }
  }
  return csv;
}

std::string lobeJson(const LobeSweep& sweep, const std::string& name, std::span<const LimitBand> bands) {
  using nlohmann::json;
  json speeds = json::array();
  for (std::size_t k = 0; k < sweep.speeds.size(); ++k) {
    const SpeedLimits& limits = sweep.speeds[k];
    json crossings = json::array();
    for (const StabilityLimit& l : limits.crossings) {
      crossings.push_back({{"depth_mm", 1e3 * l.depth.value},
                           {"before", l.before},
                           {"after", l.after},
                           {"kind", crossingName(l.kind)},
                           {"frequency_hz", l.frequency.value}});
    }
    speeds.push_back({{"speed_rpm", limits.speed.value},
                      {"searched_to_mm", 1e3 * limits.searchedTo.value},
                      {"verified", limits.verified},
                      {"crossings", std::move(crossings)}});
    if (k < bands.size()) speeds.back()["band_mm"] = {1e3 * bands[k].low.value, 1e3 * bands[k].high.value};
  }
  json warnings = json::array();
  for (const Message& warning : sweep.warnings) warnings.push_back(text(warning));
  const json all{{"schema", kJsonSchema},
                 {"command", "lobes"},
                 {"type", "answer"},
                 {"case", name},
                 {"max_depth_mm", 1e3 * sweep.maxAxialDepth.value},
                 {"warnings", warnings},
                 {"speeds", std::move(speeds)}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

std::vector<std::string> lobeSummary(const LobeSweep& sweep) {
  std::size_t limited = 0;
  std::size_t free = 0;
  std::size_t unknown = 0;
  std::vector<const SpeedLimits*> cutShort;
  for (const SpeedLimits& limits : sweep.speeds) {
    if (limits.hasLimit()) ++limited;
    if (!limits.hasLimit() && sweep.complete(limits)) ++free;
    if (limits.hasLimit() || sweep.complete(limits)) continue;
    if (limits.searchedTo.value > 0.0) {
      cutShort.push_back(&limits);
    } else {
      ++unknown;
    }
  }
  char line[240];
  std::snprintf(line, sizeof line, "%zu speeds: %zu with a limit, %zu without one down to %.6g mm", sweep.speeds.size(),
                limited, free, 1e3 * sweep.maxAxialDepth.value);
  std::vector<std::string> lines{line};
  if (unknown > 0) lines.push_back(std::to_string(unknown) + " speeds are unknown: they lie too low to be searched");
  if (cutShort.empty()) return lines;
  const auto [low, high] = std::minmax_element(
      cutShort.begin(), cutShort.end(), [](const auto* a, const auto* b) { return a->searchedTo < b->searchedTo; });
  std::snprintf(line, sizeof line,
                "%zu speeds from %.6g rpm on: nothing found down to %.4g .. %.4g mm, and double precision ends there; "
                "take a higher speed",
                cutShort.size(), cutShort.front()->speed.value, 1e3 * (*low)->searchedTo.value,
                1e3 * (*high)->searchedTo.value);
  lines.emplace_back(line);
  return lines;
}

Status saveLobeCsv(const LobeSweep& sweep, const std::string& path, std::span<const LimitBand> bands) {
  return writeFileAtomically(path, lobeCsv(sweep, bands));
}

}  // namespace stillcut::milling
