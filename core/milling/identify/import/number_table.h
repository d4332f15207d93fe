// Columns of numbers from text: tab, semicolon, comma or blanks between them, a point or a comma as decimal sign, whole
// complex numbers ("1.2e-7-3e-9i", "(1+2j)", "(1,2)", "1∠2°"), header lines of any length before the first row, in
// UTF-8 or Latin-1. Strict: every row has as many columns as the first. Rows with a value that is not finite are left
// out and counted: a response divided by a frequency of 0 is none. Thread: any, set-up path. Memory: at most six times
// the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stillcut::identify {

struct TableColumn {
  std::string name;  // of the header; empty: not named
  std::string unit;  // as written; empty: not said
  std::vector<double> real;
  std::vector<double> imaginary;  // as many; empty where the column is real
};

struct NumberTable {
  std::vector<std::string> header;   // lines before the first row, at most 512, UTF-8
  std::vector<std::string> remarks;  // words behind the numbers of the first row, as CutPro puts its header there
  std::vector<TableColumn> columns;
  std::size_t leftOut = 0;  // rows
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().real.size(); }
};

// At least `leastNumbers` numbers a row (a complex one counts twice) and two rows, or an error with file and line.
Result<NumberTable> parseNumberTable(std::string_view text, const std::string& where, std::size_t leastNumbers);

// "Real [(m/s^2)/N]", "H (m/s^2)/N", "f_kHz": name, and the unit at its end.
struct LabelParts {
  std::string name, unit;
};
LabelParts splitLabel(std::string_view label);

}  // namespace stillcut::identify
