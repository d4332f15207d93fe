#include "core/formats/text/labview_segment.h"

#include <vector>

#include "core/formats/time_stamps.h"

namespace stillcut::record {

void LabViewSegment::take(std::string_view line) {
  std::vector<std::string_view> cells;
  splitCells(line, format_.delimiter, cells);
  if (cells.size() < 2 || cells[1].empty()) return;
  if (cells[0] == "Date") date_ = cells[1];
  if (cells[0] == "Time") clock_ = cells[1];
  if (cells[0] == "X0") offset_ = parseNumber(cells[1], format_.decimalComma);
}

std::optional<double> LabViewSegment::start() const {
  const std::optional<TimeStamp> stamp = parseTimeStamp(date_ + " " + clock_);
  if (!offset_ || !stamp || !stamp->day || !stamp->hasClock) return std::nullopt;
  constexpr double kDay = 86'400.0;
  return kDay * static_cast<double>(*stamp->day) + 1e-9 * static_cast<double>(stamp->clock_ns) + *offset_;
}

}  // namespace stillcut::record
