// Cells of one line of a text recording: splitting and numbers. Pure: any thread; set-up, not real-time.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillcut::record {

// How a line is cut: a delimiter (' ' stands for any run of blanks) and the decimal sign.
struct CellFormat {
  char delimiter = ',';
  bool decimalComma = false;
};

// Cells, trimmed of blanks and quotes; a delimiter within quotes parts nothing. `cells` is reused to keep the reading
// of long files cheap.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);
// A line without numbers of the recording, wherever it stands: blank, or a time stamp ("2016-05-26 21:15:16.881") that
// some loggers write between their buffers.
bool isSkippedLine(std::string_view line);
// A number as programs print it: sign, decimals, exponents of two or three digits, Fortran's "1.5D-03" and "1.5-103",
// "nan" and "inf" too. Where the decimal sign is a comma, "1.234" is none: it may stand for 1234; "1.234,5" and "1
// 234,5" stand for nothing else.
std::optional<double> parseNumber(std::string_view cell, bool decimalComma);

// What a message shows of a line or a cell: at most 40 bytes, fit for one line.
std::string shownText(std::string_view text);

// "1,234" or "12,345,678" with `sign` ',': thousands set apart, or decimals; the cell alone does not say which.
bool isGrouped(std::string_view cell, char sign);

}  // namespace stillcut::record
