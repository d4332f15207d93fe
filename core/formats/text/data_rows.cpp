#include "core/formats/text/data_rows.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/formats/time_stamps.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

using Cells = std::vector<std::string_view>;

// At least one number, and nothing that is neither a number nor a time stamp nor empty. With a column of labels: at
// least two numbers, and one word.
bool isDataLine(const Cells& cells, bool decimalComma, bool label) {
  int numbers = 0, words = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    if (parseNumber(cell, decimalComma)) {
      ++numbers;
    } else if (!parseTimeStamp(cell)) {
      const auto first = static_cast<unsigned char>(cell.front());
      if (std::isalpha(first) == 0 && first < 0x80) return false;  // "0,12" beside points is no label
      ++words;
    }
  }
  return label ? numbers >= 2 && words == 1 : numbers > 0 && words == 0;
}

// Numbers begin where three lines in a row (or all that are left) are data lines with the same number of cells. The
// last cell may be missing from later lines: LabVIEW puts a comment on the first.
DataRows findRows(std::span<const std::string> lines, bool complete, CellFormat format, bool label) {
  constexpr std::size_t kFew = 3, kManyOfLabels = 8;  // lines in a row that are rows of a table and no header
  const std::size_t enough = label ? kManyOfLabels : kFew;
  DataRows c{.format = format, .words = label};
  Cells cells;
  std::size_t run = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (isSkippedLine(lines[i])) continue;
    splitCells(lines[i], format.delimiter, cells);
    if (!isDataLine(cells, format.decimalComma, label)) {
      run = 0;
      continue;
    }
    if (run == 0 || cells.size() != c.cells) {
      c.first = c.clean = i;
      c.cells = cells.size();
      run = 1;
    } else if (++run == enough) {
      c.found = true;
      return c;
    }
  }
  c.found = !label && run >= 2 && complete;
  return c;
}

// Some writers put their header beside the first rows ("Sample Interval,3.125e-04,,-4.000,0.02,"): these are rows as
// well, where they hold a number in every column that is filled further down.
void takeRowsBesideTheHeader(std::span<const std::string> lines, DataRows& rows) {
  std::vector<bool> filled(rows.cells, false);
  forEachRow(lines, rows, [&filled](const Cells& cells) {
    for (std::size_t k = 0; k < std::min(cells.size(), filled.size()); ++k) filled[k] = filled[k] || !cells[k].empty();
  });
  // A key and its value need two columns; with one, the values stand in those of the samples.
  if (std::count(filled.begin(), filled.end(), false) < 2) return;
  Cells cells;
  while (rows.first > 0) {
    splitCells(lines[rows.first - 1], rows.format.delimiter, cells);
    if (cells.size() != rows.cells) return;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (filled[k] && !parseNumber(cells[k], rows.format.decimalComma)) return;
    }
    --rows.first;
  }
}

bool isInteger(std::string_view cell) {
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  return !cell.empty() && std::all_of(cell.begin(), cell.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

// With commas between the columns: whole numbers alone, some of which begin with a nought ("0,0612,5,4690").
bool looksLikeSplitDecimals(std::span<const std::string> lines, const DataRows& rows) {
  bool whole = true;
  bool nought = false;
  forEachRow(lines, rows, [&](const Cells& cells) {
    for (const std::string_view cell : cells) {
      whole = whole && (cell.empty() || isInteger(cell));
      nought = nought || (cell.size() > 1 && cell.front() == '0' && isInteger(cell));
    }
  });
  return whole && nought;
}

// The first cell that could be thousands or decimals, where no other cell of the file tells which.
std::string unclearComma(std::span<const std::string> lines, const DataRows& rows) {
  std::string unclear;
  bool clear = false;
  forEachRow(lines, rows, [&](const Cells& cells) {
    for (const std::string_view cell : cells) {
      if (cell.find(',') == std::string_view::npos || parseTimeStamp(cell)) continue;
      if (!isGrouped(cell, ',')) clear = true;
      if (unclear.empty()) unclear = cell;
    }
  });
  return clear ? "" : unclear;
}

// A comment that LabVIEW has written behind the first row.
void takeCommentedRow(std::span<const std::string> lines, DataRows& rows) {
  if (rows.first == 0 || !trimmed(lines[0]).starts_with("LabVIEW Measurement")) return;
  Cells cells;
  splitCells(lines[rows.first - 1], rows.format.delimiter, cells);
  if (cells.size() != rows.cells + 1) return;
  cells.pop_back();
  if (isDataLine(cells, rows.format.decimalComma, false)) --rows.first;
}

DataRows findDataRowsOf(std::span<const std::string> lines, bool complete, bool label) {
  constexpr auto kFormats = std::to_array<CellFormat>({{'\t', false},
                                                       {';', false},
                                                       {'|', false},
                                                       {'\t', true},
                                                       {';', true},
                                                       {'|', true},
                                                       {',', false},
                                                       {',', true},
                                                       {' ', false},
                                                       {' ', true}});
  DataRows best;
  for (const CellFormat format : kFormats) {
    if (format.delimiter == ' ' && best.found && best.cells > 1) break;  // blanks stand beside other delimiters
    const DataRows c = findRows(lines, complete, format, label);
    if (c.found && (!best.found || c.cells > best.cells)) best = c;
  }
  return best;
}

}  // namespace

DataRows findDataRows(std::span<const std::string> lines, bool complete) {
  DataRows best = findDataRowsOf(lines, complete, false);
  if (!best.found) best = findDataRowsOf(lines, complete, true);
  if (best.found) takeRowsBesideTheHeader(lines, best);
  if (best.found) takeCommentedRow(lines, best);
  return best;
}

std::string unclearPoint(std::span<const std::string> lines) {
  constexpr int kFew = 3;
  Cells cells;
  for (const char delimiter : {';', '\t', '|'}) {
    int rows = 0;
    std::string unclear;
    for (const std::string& line : lines) {
      splitCells(line, delimiter, cells);
      const auto point = std::find_if(cells.begin(), cells.end(), [](std::string_view c) { return isGrouped(c, '.'); });
      const bool numbers = std::all_of(cells.begin(), cells.end(), [](std::string_view c) {
        return c.empty() || isGrouped(c, '.') || parseNumber(c, true).has_value();
      });
      if (!numbers || point == cells.end()) continue;
      if (++rows == 1) unclear = *point;
    }
    if (rows >= kFew) return unclear;
  }
  return {};
}

Status checkUnclearNumbers(std::span<const std::string> lines, const DataRows& rows, const std::string& where) {
  const std::string line = where + ":" + std::to_string(rows.first + 1);
  if (rows.format.delimiter == ',' && !rows.format.decimalComma && looksLikeSplitDecimals(lines, rows)) {
    return Error{line, message("commas seem to be both decimal signs and delimiters"),
                 message("export with decimal points, or with semicolons between the columns")};
  }
  if (!rows.format.decimalComma) return Done{};
  if (const std::string cell = unclearComma(lines, rows); !cell.empty()) {
    return Error{line, message("it is not clear whether '%1' has a decimal comma or thousands set apart", cell),
                 message("export with decimal points and without signs between thousands")};
  }
  return Done{};
}

}  // namespace stillcut::record
