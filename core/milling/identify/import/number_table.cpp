#include "core/milling/identify/import/number_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>

#include "core/base/units.h"
#include "core/formats/text/text_cells.h"
#include "core/formats/utf_text.h"
#include "core/milling/identify/import/table_header.h"
#include "core/units/number_scan.h"

namespace stillcut::identify {
namespace {

constexpr std::size_t kMaxHeaderLines = 512;
constexpr std::size_t kMaxColumns = 256;
constexpr std::size_t kLongestHeaderLine = 4096;

constexpr auto kFormats = std::to_array<record::CellFormat>(
    {{'\t', false}, {'\t', true}, {';', false}, {';', true}, {',', false}, {' ', false}, {' ', true}});

struct Cell {
  double real = 0.0;
  double imaginary = 0.0;
  bool complex = false;
};

std::optional<double> realNumber(std::string_view cell, bool decimalComma) {
  if (!decimalComma) return uff::wholeNumber(cell);
  if (cell.find('.') != std::string_view::npos) return std::nullopt;
  std::string text(cell);
  std::replace(text.begin(), text.end(), ',', '.');
  return uff::wholeNumber(text);
}

bool isOneOf(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

// Where the imaginary part of "a+b" begins: its last sign that is none of an exponent; the end where there is none.
std::size_t signOfSecond(std::string_view text) {
  for (std::size_t i = text.size(); i-- > 1;) {
    if (isOneOf(text[i], "+-") && !isOneOf(text[i - 1], "eEdD")) return i;
  }
  return text.size();
}

// "a+bi", "(a-bj)", "bi", "a+jb"; blanks and '*' anywhere; and as numpy writes a negative one, "a+-bj".
std::optional<Cell> cartesianNumber(std::string_view cell, bool decimalComma) {
  std::string text;
  for (const char c : cell) {
    if (!isOneOf(c, " ()*")) text += c;
  }
  if (text.size() < 2) return std::nullopt;
  std::size_t sign = signOfSecond(text);
  if (isOneOf(text.back(), "ijIJ")) {
    text.pop_back();
    sign = signOfSecond(text);
  } else if (sign + 1 < text.size() && isOneOf(text[sign + 1], "ijIJ")) {
    text.erase(sign + 1, 1);
  } else {
    return std::nullopt;
  }
  std::string imaginary = sign < text.size() ? text.substr(sign) : text;
  if (imaginary.starts_with('+')) imaginary.erase(0, 1);
  std::string first = sign < text.size() ? text.substr(0, sign) : "0";
  if (first.size() > 1 && first.back() == '+' && imaginary.starts_with('-')) first.pop_back();
  const auto real = realNumber(first, decimalComma);
  const auto second = realNumber(imaginary, decimalComma);
  if (!real || !second) return std::nullopt;
  return Cell{*real, *second, true};
}

// "(a,b)".
std::optional<Cell> pairNumber(std::string_view cell, bool decimalComma) {
  const std::size_t comma = cell.find(',');
  if (decimalComma || comma == std::string_view::npos || !cell.starts_with('(') || !cell.ends_with(')')) {
    return std::nullopt;
  }
  const auto real = realNumber(cell.substr(1, comma - 1), false);
  const auto imaginary = realNumber(cell.substr(comma + 1, cell.size() - comma - 2), false);
  if (!real || !imaginary) return std::nullopt;
  return Cell{*real, *imaginary, true};
}

// "a∠b°", "a<b deg", "a∠b rad": an angle without a unit could be either.
std::optional<Cell> polarNumber(std::string_view cell, bool decimalComma) {
  constexpr std::string_view kAngle = "\xE2\x88\xA0";
  std::size_t mark = cell.find(kAngle), length = kAngle.size();
  if (mark == std::string_view::npos) {
    mark = cell.find('<');
    length = 1;
  }
  if (mark == std::string_view::npos) return std::nullopt;
  std::string_view angle = uff::trimmed(cell.substr(mark + length));
  double factor = 0.0;
  for (const auto& [unit, radians] : {std::pair{std::string_view("\xC2\xB0"), kTwoPi / 360.0},
                                      {std::string_view("\xB0"), kTwoPi / 360.0},
                                      {std::string_view("deg"), kTwoPi / 360.0},
                                      {std::string_view("rad"), 1.0}}) {
    if (factor != 0.0 || !angle.ends_with(unit)) continue;
    angle.remove_suffix(unit.size());
    factor = radians;
  }
  const auto size = realNumber(cell.substr(0, mark), decimalComma);
  const auto turned = realNumber(angle, decimalComma);
  if (!size || !turned || factor == 0.0) return std::nullopt;
  const std::complex<double> value = std::polar(std::abs(*size), factor * *turned) * (*size < 0.0 ? -1.0 : 1.0);
  return Cell{value.real(), value.imag(), true};
}

std::optional<Cell> numberIn(std::string_view cell, bool decimalComma) {
  if (cell.empty()) return std::nullopt;
  if (const auto real = realNumber(cell, decimalComma)) return Cell{*real, 0.0, false};
  if (const auto cartesian = cartesianNumber(cell, decimalComma)) return cartesian;
  if (const auto pair = pairNumber(cell, decimalComma)) return pair;
  return polarNumber(cell, decimalComma);
}

// One line cut into its leading numbers and what follows them.
struct Row {
  std::vector<Cell> numbers;
  std::vector<std::string_view> words;  // from the first cell that is no number on
};

void cut(std::string_view line, record::CellFormat format, std::vector<std::string_view>& cells, Row& row) {
  record::splitCells(line, format.delimiter, cells);
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  row.numbers.clear();
  row.words.clear();
  for (const std::string_view cell : cells) {
    const auto number = row.words.empty() ? numberIn(cell, format.decimalComma) : std::nullopt;
    if (number) {
      row.numbers.push_back(*number);
    } else {
      row.words.push_back(cell);
    }
  }
}

std::size_t weight(const Row& row) {
  std::size_t numbers = 0;
  for (const Cell& cell : row.numbers) numbers += cell.complex ? 2 : 1;
  return numbers;
}

std::string_view nextFullLine(std::string_view rest) {
  while (!rest.empty()) {
    const std::string_view line = uff::takeLine(rest);
    if (!uff::trimmed(line).empty()) return line;
  }
  return {};
}

// The format in which this line and the next are rows; only the first may have words behind its numbers.
std::optional<record::CellFormat> formatOfRows(std::string_view line, std::string_view rest, std::size_t least) {
  std::vector<std::string_view> cells;
  Row first;
  Row second;
  const std::string_view next = nextFullLine(rest);
  for (const record::CellFormat format : kFormats) {
    cut(line, format, cells, first);
    if (weight(first) < least || first.numbers.size() > kMaxColumns) continue;
    cut(next, format, cells, second);
    // What is no number in the second row is said by whoever reads it; here it is enough that it is as long.
    const bool alike = second.numbers.size() + second.words.size() == first.numbers.size();
    if (alike && (second.words.empty() || first.words.empty())) return format;
    if (first.words.empty() && weight(second) > 0) return format;
  }
  return std::nullopt;
}

Error badRow(const std::string& where, std::size_t line, Message what, Message why = {}) {
  return Error{where + ":" + std::to_string(line), std::move(what), std::move(why)};
}

Status addRow(NumberTable& table, const Row& row, const std::string& where, std::size_t line) {
  if (row.numbers.size() != table.columns.size()) {
    return badRow(where, line, message("has %1 columns", std::to_string(row.numbers.size())),
                  message("the rows before have %1", std::to_string(table.columns.size())));
  }
  const auto finite = [](const Cell& cell) { return std::isfinite(cell.real) && std::isfinite(cell.imaginary); };
  if (!std::all_of(row.numbers.begin(), row.numbers.end(), finite)) {
    ++table.leftOut;
    return Done{};
  }
  for (std::size_t c = 0; c < row.numbers.size(); ++c) {
    const Cell& cell = row.numbers[c];
    TableColumn& column = table.columns[c];
    if (cell.complex && column.imaginary.empty()) column.imaginary.assign(column.real.size(), 0.0);
    column.real.push_back(cell.real);
    if (cell.complex || !column.imaginary.empty()) column.imaginary.push_back(cell.imaginary);
  }
  return Done{};
}

struct Parser {
  const std::string& where;
  std::size_t least;
  NumberTable table;
  record::CellFormat format;
  std::vector<std::string_view> cells;
  Row row;

  Status line(std::string_view text, std::string_view rest, std::size_t number) {
    const bool first = table.columns.empty();
    if (first) {
      const auto found = formatOfRows(text, rest, least);
      if (!found) return header(text);
      format = *found;
    }
    cut(text, format, cells, row);
    if (first) {
      table.columns.resize(row.numbers.size());
      for (const std::string_view word : row.words) table.remarks.push_back(record::utf8Of(word));
    } else if (!row.words.empty()) {
      return badRow(where, number, message("'%1' is not a number", uff::printable(row.words.front())));
    }
    return addRow(table, row, where, number);
  }

  Status header(std::string_view text) {
    if (table.header.size() == kMaxHeaderLines) {
      return Error{where, message("holds no rows of %1 numbers", std::to_string(least)),
                   message("none in its first %1 lines", std::to_string(kMaxHeaderLines))};
    }
    table.header.push_back(record::utf8Of(text.substr(0, kLongestHeaderLine)));
    return Done{};
  }
};

// numpy writes frequencies beside complex values as complex ones, "(5+0j)".
void dropEmptyImaginary(TableColumn& column) {
  const bool any = std::any_of(column.imaginary.begin(), column.imaginary.end(), [](double v) { return v != 0.0; });
  if (!any) column.imaginary.clear();
}

}  // namespace

Result<NumberTable> parseNumberTable(std::string_view text, const std::string& where, std::size_t leastNumbers) {
  Parser parser{where, leastNumbers, {}, {}, {}, {}};
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = uff::takeLine(text);
    if (uff::trimmed(line).empty()) continue;
    if (const Status read = parser.line(line, text, number); !read) return read.error();
  }
  if (parser.table.rows() < 2) {
    return Error{where, message("holds no rows of %1 numbers", std::to_string(leastNumbers)),
                 message("not a table of numbers")};
  }
  dropEmptyImaginary(parser.table.columns.front());
  nameColumns(parser.table, parser.format.delimiter);
  return std::move(parser.table);
}

}  // namespace stillcut::identify
