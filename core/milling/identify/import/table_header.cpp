#include "core/milling/identify/import/table_header.h"

#include <algorithm>
#include <utility>

#include "core/formats/text/text_cells.h"
#include "core/milling/identify/import/frf_columns.h"
#include "core/milling/identify/import/unit_label.h"
#include "core/units/number_scan.h"
#include "core/units/unit_names.h"

namespace stillcut::identify {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return out;
}

// Cells of a header line; where blanks part the columns, two of them or a tab part the names.
std::vector<std::string> headerCells(std::string_view line, char delimiter, std::size_t columns) {
  for (const std::string_view mark : {"#", "%", "!", "//"}) {
    if (line.starts_with(mark)) line.remove_prefix(mark.size());
  }
  std::vector<std::string_view> cells;
  record::splitCells(line, delimiter, cells);
  std::vector<std::string> out(cells.begin(), cells.end());
  if (delimiter == ' ' && out.size() != columns) {
    out.clear();
    std::string_view rest = uff::trimmed(line);
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find("  "), rest.find('\t'));
      out.emplace_back(uff::trimmed(rest.substr(0, end)));
      rest = end == std::string_view::npos ? std::string_view() : uff::trimmed(rest.substr(end));
    }
  }
  while (!out.empty() && out.back().empty()) out.pop_back();
  return out;
}

bool isUnitLine(const std::vector<std::string>& cells) {
  return !cells.empty() &&
         std::all_of(cells.begin(), cells.end(), [](const std::string& c) { return c.empty() || isColumnUnit(c); }) &&
         std::any_of(cells.begin(), cells.end(), [](const std::string& c) { return !c.empty(); });
}

// Where the bracket that closes at the end of `text` opens.
std::size_t openingOfLast(std::string_view text) {
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == ')' || text[i] == ']') ++depth;
    if (text[i] == '(' || text[i] == '[') --depth;
    if (depth == 0) return i;
  }
  return std::string_view::npos;
}

// "Real (m/N).1": how pandas names the second of two columns that are called the same.
std::string_view withoutCount(std::string_view cell) {
  const std::size_t dot = cell.find_last_not_of("0123456789");
  const bool counted = dot != std::string_view::npos && dot > 0 && dot + 1 < cell.size() && cell[dot] == '.' &&
                       (cell[dot - 1] == ')' || cell[dot - 1] == ']');
  return counted ? cell.substr(0, dot) : cell;
}

// "0.0,,": the row of a frequency of 0, at which a program had no value.
bool isRowCutShort(const std::vector<std::string>& cells) {
  return cells.size() == 1 && uff::wholeNumber(cells.front()).has_value();
}

// "Real (counts)" beside "Imag (counts)": nobody knows that unit, and it must be asked for; "Re (A)" and "Re (B)" are
// names of responses.
void keepUnknownUnits(NumberTable& table) {
  std::vector<std::pair<TableColumn*, LabelParts>> found;
  for (TableColumn& column : table.columns) {
    const std::string& name = column.name;
    const std::size_t open = name.rfind('(');
    if (!column.unit.empty() || open == std::string::npos || open == 0 || !name.ends_with(')')) continue;
    const std::string inner = name.substr(open + 1, name.size() - open - 2);
    const std::string before(uff::trimmed(std::string_view(name).substr(0, open)));
    const ColumnMeaning value = meaningOfColumn({before, "", {}, {}}), word = meaningOfColumn({inner, "", {}, {}});
    const bool named = !value.response.empty() || word.role != ColumnRole::Unknown || word.along != Axis::Unknown;
    const bool letters = inner.size() > 1 && std::all_of(inner.begin(), inner.end(), [](char c) {
                           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
                         });
    const bool hasRole = value.role != ColumnRole::Unknown && value.role != ColumnRole::Coherence;
    if (hasRole && !named && letters) found.push_back({&column, {before, inner}});
  }
  for (const auto& [column, parts] : found) {
    if (parts.unit != found.front().second.unit) return;
  }
  for (const auto& [column, parts] : found) {
    column->name = parts.name;
    column->unit = parts.unit;
  }
}

}  // namespace

bool isColumnUnit(std::string_view label) {
  if (label == "-" || label == "1") return true;
  if (frfUnit(label) || inverseFrfUnit(label) || decibels(label) || frequencyUnit(label) || angleUnit(label) ||
      responseUnit(label) || forceUnit(label))
    return true;
  return record::unitFromText(label).has_value();
}

LabelParts splitLabel(std::string_view label) {
  const std::string_view text = uff::trimmed(label);
  if (!text.empty() && (text.back() == ')' || text.back() == ']')) {
    const std::size_t open = openingOfLast(text);
    if (open != std::string_view::npos && open > 0) {
      const std::string_view inner = text.substr(open + 1, text.size() - open - 2);
      const std::string_view before = uff::trimmed(text.substr(0, open));
      // "Amplitude dB (g/N)"
      const std::size_t word = before.find_last_of(" _,") + 1;
      if (word > 0 && lower(before.substr(word)) == "db" && frfUnit(inner)) {
        return {std::string(uff::trimmed(before.substr(0, word - 1))), "dB " + std::string(inner)};
      }
      // "Re(Gxx)" names a thing, "Real (m/N)" a unit; what is no unit we know stays said where it cannot be a name.
      if (isColumnUnit(inner) || text.back() == ']' || inner.find('/') != std::string_view::npos) {
        return {std::string(before), std::string(inner)};
      }
    }
  }
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (std::string_view(" _([,").find(text[i]) == std::string_view::npos) continue;
    const std::string_view end = text.substr(text[i] == '(' || text[i] == '[' ? i : i + 1);
    if (frfUnit(end) || frequencyUnit(end) || angleUnit(end) || decibels(end)) {
      return {std::string(uff::trimmed(text.substr(0, i))), std::string(uff::trimmed(end))};
    }
  }
  return {std::string(text), ""};
}

void nameColumns(NumberTable& table, char delimiter) {
  std::vector<std::string> units;
  for (std::size_t back = 0; back < std::min<std::size_t>(table.header.size(), 3); ++back) {
    const std::string& line = table.header[table.header.size() - 1 - back];
    const std::vector<std::string> cells = headerCells(line, delimiter, table.columns.size());
    if (isRowCutShort(cells)) continue;
    if (cells.size() != table.columns.size()) {
      if (units.empty()) return;
      break;
    }
    if (units.empty() && isUnitLine(cells)) {
      units = cells;
      continue;
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const LabelParts parts = splitLabel(withoutCount(cells[c]));
      table.columns[c].name = parts.name;
      table.columns[c].unit = parts.unit;
    }
    keepUnknownUnits(table);
    break;
  }
  for (std::size_t c = 0; c < units.size(); ++c) {
    if (!units[c].empty()) table.columns[c].unit = units[c];
  }
}

std::string unitOfAxis(const NumberTable& table, char axis) {
  for (const std::string& line : table.header) {
    const std::string text = lower(line);
    const std::size_t word = text.find("unit");
    if (word == std::string::npos) continue;
    const std::string before = text.substr(0, word);
    const bool x = before.starts_with("x") || before.find("abscissa") != std::string::npos;
    const bool y = before.starts_with("y") || before.find("ordinate") != std::string::npos;
    if (axis == 'x' ? !x : !y) continue;
    const std::size_t value = line.find_first_of(":=\t", word);
    if (value == std::string::npos) continue;
    std::string_view rest = std::string_view(line).substr(value);
    while (!rest.empty() && std::string_view(":=\t \"").find(rest.front()) != std::string_view::npos) {
      rest.remove_prefix(1);
    }
    return std::string(uff::trimmed(rest.substr(0, rest.find('\t'))));
  }
  return "";
}

}  // namespace stillcut::identify
