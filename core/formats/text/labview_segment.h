// When a segment of a LabVIEW measurement file begins, as the header above it tells.
// Pure: any thread; file reading, not real-time.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/formats/text/text_cells.h"

namespace stillcut::record {

class LabViewSegment {
 public:
  explicit LabViewSegment(CellFormat format) : format_(format) {}
  // A line of the header: a key, then a value for each channel. A later one counts.
  void take(std::string_view line);
  // Of its first sample, s since 1970 on the clock of the file; empty: not told.
  std::optional<double> start() const;

 private:
  CellFormat format_;
  std::string date_, clock_;
  std::optional<double> offset_;  // X0 [s]
};

}  // namespace stillcut::record
