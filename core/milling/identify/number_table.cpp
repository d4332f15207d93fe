#include "core/milling/identify/number_table.h"

#include <cmath>
#include <optional>

#include "core/units/number_scan.h"

namespace stillcut::identify {
namespace {

constexpr std::size_t kMaxHeaderLines = 64;
constexpr std::size_t kMaxColumns = 64;

// The character between fields of this line: the first of tab, semicolon, comma it holds, else blanks.
char separatorOf(std::string_view line) {
  for (const char c : {'\t', ';', ','}) {
    if (line.find(c) != std::string_view::npos) return c;
  }
  return ' ';
}

// Splits a line; an empty last field (a trailing separator) does not count.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  line = uff::trimmed(line);
  while (!line.empty() && fields.size() <= kMaxColumns) {
    const std::size_t end = separator == ' ' ? line.find_first_of(" \t") : line.find(separator);
    fields.push_back(uff::trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) break;
    line = separator == ' ' ? uff::trimmed(line.substr(end)) : line.substr(end + 1);
  }
}

// The row's numbers, or which field is none.
std::optional<std::size_t> numbersOf(const std::vector<std::string_view>& fields, std::vector<double>& row) {
  row.clear();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto value = uff::wholeNumber(fields[i]);
    if (!value) return i;
    row.push_back(*value);
  }
  return std::nullopt;
}

Error badRow(const std::string& where, std::size_t line, Message what, Message why = {}) {
  return Error{where + ":" + std::to_string(line), std::move(what), std::move(why)};
}

Status addRow(NumberTable& table, const std::vector<double>& row, const std::string& where, std::size_t line) {
  if (row.size() != table.columns.size()) {
    return badRow(where, line, message("has %1 columns", std::to_string(row.size())),
                  message("the rows before have %1", std::to_string(table.columns.size())));
  }
  for (std::size_t c = 0; c < row.size(); ++c) {
    if (!std::isfinite(row[c])) return badRow(where, line, message("column %1 is not finite", std::to_string(c + 1)));
    table.columns[c].push_back(row[c]);
  }
  return Done{};
}

}  // namespace

Result<NumberTable> parseNumberTable(std::string_view text, const std::string& where, std::size_t leastColumns) {
  NumberTable table;
  std::vector<std::string_view> fields;
  std::vector<double> row;
  char separator = ' ';
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte order mark
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = uff::takeLine(text);
    if (uff::trimmed(line).empty()) continue;
    const bool inHeader = table.columns.empty();
    if (inHeader) separator = separatorOf(uff::trimmed(line));
    split(line, separator, fields);
    const auto bad = numbersOf(fields, row);
    if (inHeader) {
      if (!bad && row.size() >= leastColumns && row.size() <= kMaxColumns) {
        table.columns.resize(row.size());
      } else {
        if (table.header.size() == kMaxHeaderLines) {
          return Error{where, message("holds no rows of %1 numbers", std::to_string(leastColumns)),
                       message("none in its first %1 lines", std::to_string(kMaxHeaderLines))};
        }
        table.header.emplace_back(uff::trimmed(line).substr(0, 256));
        continue;
      }
    }
    if (bad) {
      const bool comma = fields[*bad].find(',') != std::string_view::npos;
      return badRow(where, number, message("'%1' is not a number", uff::printable(fields[*bad])),
                    comma ? message("a decimal comma is not read") : Message());
    }
    Status added = addRow(table, row, where, number);
    if (!added) return added.error();
  }
  if (table.rows() < 2) {
    return Error{where, message("holds no rows of %1 numbers", std::to_string(leastColumns)),
                 message("not a table of numbers")};
  }
  return table;
}

}  // namespace stillcut::identify
