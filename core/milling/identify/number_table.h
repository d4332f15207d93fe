// Columns of numbers from text: tab, comma, semicolon or blanks between them, header lines before the first row.
// Strict: every row has as many columns as the first, every value is finite; a decimal comma is refused by name.
// Thread: any, set-up path. Memory: at most four times the text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stillcut::identify {

struct NumberTable {
  std::vector<std::string> header;           // lines before the first row, at most 64
  std::vector<std::vector<double>> columns;  // [column][row]
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

// At least `leastColumns` columns and two rows, or an error with file and line.
Result<NumberTable> parseNumberTable(std::string_view text, const std::string& where, std::size_t leastColumns);

}  // namespace stillcut::identify
