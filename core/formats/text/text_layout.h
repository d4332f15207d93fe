// TextLayout: how a text recording is laid out, found from its first lines by content alone: delimiter, decimal sign,
// where the numbers begin, names and units, the time column. The rules are in resources/manual/recordings.md.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/formats/recording_reader.h"
#include "core/formats/text/line_form.h"
#include "core/formats/text/text_cells.h"

namespace stillcut::record {

struct TextColumn {
  std::string name;        // empty: no header
  std::string unit;        // empty: not said
  bool empty = false;      // no cell of it holds anything
  bool stamps = false;     // holds dates or times of day
  bool clock = false;      // of them, times of day
  bool words = false;      // holds words in every row, as labels are
  bool rowNumber = false;  // counts the rows
};

struct TextLayout {
  std::string kind = "text";
  CellFormat cells;
  std::int64_t firstDataLine = 1;
  int minCells = 0;  // a data line has at least so many cells
  int maxCells = 0;  // and at most so many; those over the columns are comments
  std::vector<TextColumn> columns;
  int timeColumn = -1;                  // -1: none
  bool timeStamps = false;              // the time column holds times of day, not numbers
  double secondsPerTime = 1.0;          // unit of the time column
  bool timeUnitAssumed = false;         // nothing says that its numbers are seconds
  std::string unknownTimeUnit;          // as the file spells it; empty: none, or known
  std::string otherTime;                // a column of times in other steps than the time column; empty: none
  std::string frequencies;              // a column of frequencies where times would be; empty: none
  int dateColumn = -1;                  // of dates beside a time column of times of day; -1: none
  bool days = false;                    // times without a unit that look like days, as spreadsheets count them
  LineForm form;                        // what is done with a line before it is cut into cells
  std::optional<double> segmentStart;   // of LabVIEW's first segment [s], see LabViewSegment
  std::string unclearRate;              // of the header, as it stands there; empty: none, or clear
  std::optional<Hertz> rateFromHeader;  // where the header declares it, and never in two ways
};

// `lines` are the first lines of the file (all of them when `complete`); a few hundred are enough.
Result<TextLayout> detectTextLayout(std::span<const std::string> lines, bool complete, const std::string& where);

// The columns that are channels, in the order of the file, and the names of those that are not.
struct TextChannels {
  std::vector<int> columns;
  std::vector<RecordedChannel> channels;
  std::vector<std::string> skipped;
  std::vector<Message> skippedWhy;  // of each of them
};
Result<TextChannels> chooseTextChannels(const TextLayout& layout, const ReadOptions& options, const std::string& where);

}  // namespace stillcut::record
