// Where the rows of a text recording are: found from its first lines by what stands in their cells.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/formats/text/text_cells.h"

namespace stillcut::record {

struct DataRows {
  CellFormat format;
  std::size_t first = 0;  // index into the lines
  std::size_t clean = 0;  // the first with nothing of a header beside it
  std::size_t cells = 0;  // of a row
  bool words = false;     // one of them holds a word in every row
  bool found = false;
};

// The format that gives the most columns; `complete`: no line follows those given.
DataRows findDataRows(std::span<const std::string> lines, bool complete);

// Error: the numbers could be read in two ways ("1,234" everywhere), so nobody may choose one. `where` names the file.
Status checkUnclearNumbers(std::span<const std::string> lines, const DataRows& rows, const std::string& where);

// Where no rows were found: a cell as "1.234" beside decimal commas, which may be thousands or decimals; empty: that is
// not why.
std::string unclearPoint(std::span<const std::string> lines);

// Every line from `rows.clean` on that can be a row: visit(cells).
template <class Visit>
void forEachRow(std::span<const std::string> lines, const DataRows& rows, Visit visit) {
  std::vector<std::string_view> cells;
  for (std::size_t i = rows.clean; i < lines.size(); ++i) {
    if (isSkippedLine(lines[i])) continue;
    splitCells(lines[i], rows.format.delimiter, cells);
    if (cells.size() > 1 || rows.cells == 1) visit(cells);
  }
}

}  // namespace stillcut::record
