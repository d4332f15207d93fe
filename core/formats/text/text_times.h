// The time column of a table: which one it is, in which unit, and a cell of it in seconds.
// Thread: one; set-up and file reading, not real-time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/formats/text/data_rows.h"
#include "core/formats/text/text_layout.h"

namespace stillcut::record {

// Sets layout.timeColumn and what belongs to it, and marks the columns that are times or row numbers.
void findTimeColumn(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout);

// Cells of the time column, in their order, as seconds from the first.
class TimeCells {
 public:
  explicit TimeCells(const TextLayout& layout)
      : stamps_(layout.timeStamps), secondsPerTime_(layout.secondsPerTime), decimalComma_(layout.cells.decimalComma) {}
  // The day of the first cell, where its own column of dates tells it.
  void beginOn(std::string_view date);
  // Nothing: the cell holds no time. A clock that jumps back by half a day or more has passed midnight.
  std::optional<double> seconds(std::string_view cell);
  // Of the first cell, ns since 1970 UTC; empty: it has no date. A stamp that does not say its zone is of this
  // computer's, as those of a logger beside it are.
  std::optional<std::int64_t> startedNs() const { return started_ns_; }

 private:
  std::optional<double> stampSeconds(std::string_view cell);
  std::optional<double> numberSeconds(std::string_view cell);

  bool stamps_;
  double secondsPerTime_;
  bool decimalComma_;
  bool begun_ = false;
  std::int64_t origin_ = 0;  // whole units of the column, or ns of a stamp
  double originPart_ = 0.0;
  std::int64_t before_ns_ = 0;       // last stamp, midnights included
  std::optional<std::int64_t> day_;  // since 1970
  std::optional<std::int64_t> started_ns_;
};

}  // namespace stillcut::record
