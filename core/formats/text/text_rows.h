// TextRows: the rows of a table, one after the other, with what is missing between them. A row without a number where
// one belongs is missing; text below the last row is a footer; a last line that is cut off is left out.
// Thread: its owner's; not real-time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/formats/text/line_reader.h"
#include "core/formats/text/text_layout.h"
#include "core/formats/text/text_times.h"

namespace stillcut::record {

// One data line: its channels, its time, and what is missing before it.
struct TextRow {
  std::vector<float> values;  // per channel
  double time = 0.0;          // [s] since the first row, 0 without a time column
  std::int64_t lost = 0;      // frames missing between the row before and this one
};

// What was met so far.
struct TextRowCounts {
  std::int64_t rows = 0;                // good ones
  std::int64_t bad = 0;                 // without a number where one belongs
  std::optional<Error> firstBad;        // its place and cause
  std::vector<std::int64_t> badCells;   // per channel
  std::vector<std::int64_t> filledTo;   // per channel: all rows up to its last cell that is not empty
  std::optional<Error> footer;          // where it begins
  std::optional<std::int64_t> cutLine;  // the last line, from 1, where it is cut off
  std::vector<double> footerRates;      // [Hz], as the footer states them
  std::int64_t all() const { return rows + bad; }
};

class TextRows {
 public:
  // `columns`: of the channels. `timed`: the time column is read and gaps are looked for.
  TextRows(std::string path, const TextLayout& layout, std::vector<int> columns, bool timed);

  // Before the first row again.
  Status rewind();
  // The next good row. False: none is left. Error: what is there is no row of this table.
  Result<bool> next();
  const TextRow& row() const { return row_; }
  const TextRowCounts& counts();
  // Typical time between rows [s]; until it is set no gap is looked for.
  void setStep(double step_s) { step_ = step_s; }
  // Nothing is read behind so many rows, bad ones included.
  void setEnd(std::int64_t rows) { end_ = rows; }
  std::string where() const { return lines_->where(); }
  // See TimeCells; once a row was read.
  std::optional<std::int64_t> startedNs() const { return times_ ? times_->startedNs() : std::nullopt; }

 private:
  enum class Kind { Good, Bad, Odd };

  Result<bool> nextLine(std::string_view& line);
  Status passSegmentHeader(std::string_view& line);
  Status countBetween(std::optional<double> start);
  Error anotherSegment() const;
  Kind parse(std::string_view line);
  bool takeNumbers();
  bool holdsNumber() const;
  void countBadCells();
  void remember(int column, std::string_view cell);
  Status takeOddLines();
  Status settleEnd();
  void setOddAside(std::string_view line);
  // Frames missing between two neighbouring rows; an error when time stands still or runs back.
  Result<std::int64_t> missingBetween(double before, double after) const;

  std::string path_;
  const TextLayout& layout_;
  std::vector<int> columns_;
  bool timed_;
  double step_ = 0.0;
  std::int64_t end_;

  std::unique_ptr<LineReader> lines_;
  std::optional<TimeCells> times_;
  std::string formed_;  // the line at hand, where it takes another form
  std::vector<std::string_view> cells_;
  TextRow row_;
  TextRowCounts counts_;
  std::int64_t goodTo_ = 0;           // all rows up to the last good one
  std::int64_t badSince_ = 0;         // rows, since the last good one
  std::int64_t lostBefore_ = 0;       // frames between the segments, before the next row
  std::int64_t betweenSegments_ = 0;  // in all
  bool segment_ = false;              // a header of LabVIEW has passed since the last good row
  // Lines that may be a footer, until a row follows.
  std::int64_t odd_ = 0;
  std::optional<Error> firstOdd_;
  bool oddCount_ = false;  // one of them has another number of columns
  bool oddNumbers_ = false;
  std::int64_t oddLine_ = 0;  // the last of them
  std::vector<double> oddRates_;
};

}  // namespace stillcut::record
