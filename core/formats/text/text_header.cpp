#include "core/formats/text/text_header.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "core/formats/time_stamps.h"
#include "core/units/time_names.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

using Cells = std::vector<std::string_view>;

// A word, not a number or a date: "Fx", "[N]", "%".
bool looksLikeHeaderCell(std::string_view cell) {
  constexpr std::size_t kLongestName = 80;
  const auto c = static_cast<unsigned char>(cell.front());
  const bool begins = std::isalpha(c) != 0 || c >= 0x80 || c == '[' || c == '(' || c == '%' || c == '_' || c == '#';
  return begins && cell.size() <= kLongestName;
}

bool isUnit(std::string_view cell) {
  return unitFromText(cell).has_value();
}

bool namesTime(std::string_view cell) {
  return meaningOfName(splitNameAndUnit(cell).name) == NameMeaning::Time;
}

// Only the columns that hold something count: Rigol's header has numbers over those that hold nothing. Beside a column
// of time a name may begin with a digit: repeats are named by their dates.
bool isHeaderLine(const Cells& cells, const TextLayout& layout) {
  const bool time = std::any_of(cells.begin(), cells.end(), namesTime);
  std::size_t words = 0;
  for (std::size_t k = 0; k < std::min(cells.size(), layout.columns.size()); ++k) {
    if (cells[k].empty() || layout.columns[k].empty) continue;
    const bool word = looksLikeHeaderCell(cells[k]);
    if (!word && (!time || parseNumber(cells[k], false))) return false;
    words += word ? 1 : 0;
  }
  return words > 0;
}

bool isUnitsLine(const Cells& cells, const TextLayout& layout) {
  for (std::size_t k = 0; k < std::min(cells.size(), layout.columns.size()); ++k) {
    if (!cells[k].empty() && !layout.columns[k].empty && !isUnit(cells[k])) return false;
  }
  return true;
}

// "#time", "% Time (s)": the sign of a comment, not part of the first name.
std::string_view withoutCommentSign(std::string_view line) {
  const std::size_t at = line.find_first_not_of("#%/! ");
  if (at == 0 || at == std::string_view::npos) return line;
  const auto c = static_cast<unsigned char>(line[at]);
  return std::isalpha(c) != 0 || c >= 0x80 || c == '"' ? line.substr(at) : line;
}

// "t0 = -4.5s" beside the names is none of them.
void dropStatements(Cells& names, std::size_t columns) {
  while (names.size() > columns && (names.back().empty() || names.back().find('=') != std::string_view::npos)) {
    const bool statement = !names.back().empty();
    const bool before = std::any_of(names.begin(), names.end(),
                                    [](std::string_view cell) { return cell.find('=') != std::string_view::npos; });
    if (!statement && !before) return;
    names.pop_back();
  }
}

bool isBlank(const std::string& line) {
  return isSkippedLine(line) || line.starts_with("sep=");
}

struct Header {
  Cells names;
  Cells units;           // empty: none
  std::size_t line = 0;  // of the names, from 1
};

// The line above `below` (from 1) that holds something, split; `apart`: blank lines lie between.
std::optional<std::size_t> lineAbove(std::span<const std::string> lines, std::size_t below, bool& apart) {
  for (std::size_t i = below; i > 0; --i) {
    if (!isBlank(lines[i - 1])) return i - 1;
    apart = true;
  }
  return std::nullopt;
}

// Numbers over every column with something in it, and a word over one without: "Nr;0;1;2", "Werte;90000;90000".
bool isCountLine(const Cells& cells, const TextLayout& layout) {
  bool word = false;
  for (std::size_t k = 0; k < std::min(cells.size(), layout.columns.size()); ++k) {
    if (cells[k].empty()) continue;
    const bool number = parseNumber(cells[k], layout.cells.decimalComma).has_value();
    if (number == layout.columns[k].empty) return false;
    word = word || !number;
  }
  return word;
}

std::optional<Header> findHeader(std::span<const std::string> lines, std::size_t firstData, const TextLayout& layout) {
  const auto cellsOf = [&](std::size_t line) {
    Cells cells;
    splitCells(withoutCommentSign(lines[line]), layout.cells.delimiter, cells);
    dropStatements(cells, layout.columns.size());
    return cells;
  };
  // Campbell's loggers: names, units, and what was done with the samples.
  constexpr std::size_t kCampbellRows = 4;
  if (firstData == kCampbellRows && trimmed(lines[0]).starts_with("TOA5")) return Header{cellsOf(1), cellsOf(2), 2};
  bool apart = false;
  std::optional<std::size_t> nearest = lineAbove(lines, firstData, apart);
  while (nearest && isCountLine(cellsOf(*nearest), layout)) nearest = lineAbove(lines, *nearest, apart);
  if (!nearest) return std::nullopt;
  Header header{cellsOf(*nearest), {}, *nearest + 1};
  if (!isHeaderLine(header.names, layout) || (apart && header.names.size() < 2)) return std::nullopt;
  std::size_t line = *nearest;
  while (isUnitsLine(header.names, layout)) {
    const std::optional<std::size_t> above = lineAbove(lines, line, apart);
    if (!above) break;
    Cells names = cellsOf(*above);
    if (!isHeaderLine(names, layout) || names.size() < static_cast<std::size_t>(layout.minCells)) break;
    header =
        Header{std::move(names), header.units.empty() ? std::move(header.names) : std::move(header.units), *above + 1};
    line = *above;
    if (!layout.columns.front().empty) break;  // a key before each line: there may be units of several kinds
  }
  return header;
}

// "Unit:(ms)" above names of which the first is left out: OWON's oscilloscopes.
std::string unitOfUnnamed(std::span<const std::string> lines, const Header& header) {
  if (header.line < 2 || header.names.empty() || !header.names.front().empty()) return "";
  const std::string_view above = trimmed(lines[header.line - 2]);
  constexpr std::string_view kUnit = "Unit:";
  if (!above.starts_with(kUnit)) return "";
  const std::optional<UnitMeaning> unit = unitFromText(above.substr(kUnit.size()));
  if (!unit || unit->kind != UnitKind::Time) return "";
  return splitNameAndUnit("x " + std::string(trimmed(above.substr(kUnit.size())))).unit;
}

bool allWhole(std::span<const std::string> lines, std::size_t firstData, const TextLayout& layout) {
  Cells cells;
  for (std::size_t i = firstData; i < lines.size(); ++i) {
    splitCells(lines[i], layout.cells.delimiter, cells);
    for (const std::string_view cell : cells) {
      if (cell.find_first_of(".eE") != std::string_view::npos) return false;
    }
  }
  return true;
}

// "index,x,y" without the word: pandas writes the number of the row under an empty name.
bool isUnnamedRowNumber(std::span<const std::string> lines, std::size_t firstData, const Header& header,
                        const TextLayout& layout) {
  if (header.names.size() != layout.columns.size() || !header.names.front().empty()) return false;
  Cells cells;
  std::optional<double> before;
  for (std::size_t i = firstData; i < lines.size(); ++i) {
    if (isSkippedLine(lines[i])) continue;
    splitCells(lines[i], layout.cells.delimiter, cells);
    if (cells.size() != layout.columns.size()) continue;
    const std::optional<double> number = parseNumber(cells.front(), layout.cells.decimalComma);
    if (!number || (before && *number - *before != 1.0)) return false;
    before = number;
  }
  return before.has_value();
}

// Names would stand over the wrong numbers. LabVIEW's column of comments is one that most rows leave out.
Status checkCount(std::span<const std::string> lines, std::size_t firstData, const Header& header,
                  const TextLayout& layout, const std::string& where) {
  std::size_t named = 0;
  for (std::size_t k = 0; k < header.names.size(); ++k) {
    const bool leftOut = header.names[k] == "Comment" && (k >= layout.columns.size() || layout.columns[k].empty);
    named += header.names[k].empty() || leftOut ? 0 : 1;
  }
  const auto filled = static_cast<std::size_t>(
      std::count_if(layout.columns.begin(), layout.columns.end(), [](const TextColumn& c) { return !c.empty; }));
  const auto wrong = [&](Message remedy) {
    return Error{where + ":" + std::to_string(header.line),
                 message("names %1 columns where the rows have %2", std::to_string(named),
                         std::to_string(layout.columns.size())),
                 std::move(remedy)};
  };
  if (named > layout.columns.size()) return wrong(message("put names that hold the delimiter in quotes"));
  if (named >= filled || layout.cells.delimiter == ' ') return Done{};
  const bool split = layout.cells.delimiter == ',' && allWhole(lines, firstData, layout);
  if (split) return wrong(message("with decimal commas, export with semicolons between the columns"));
  return named >= 2 ? wrong(message("name every column")) : Status(Done{});
}

}  // namespace

Status readTextHeader(std::span<const std::string> lines, std::size_t firstData, TextLayout& layout,
                      const std::string& where) {
  std::optional<Header> header = findHeader(lines, firstData, layout);
  if (!header) return Done{};
  const std::string unnamed = unitOfUnnamed(lines, *header);
  if (!unnamed.empty()) header->names.front() = "time";
  if (isUnnamedRowNumber(lines, firstData, *header, layout)) {
    layout.columns.front().rowNumber = true;
  } else if (const Status s = checkCount(lines, firstData, *header, layout, where); !s) {
    return s.error();
  }
  if (header->names.size() < static_cast<std::size_t>(layout.minCells)) return Done{};
  for (std::size_t i = 0; i < std::min(layout.columns.size(), header->names.size()); ++i) {
    TextColumn& column = layout.columns[i];
    const NameAndUnit both = splitNameAndUnit(header->names[i]);
    column.name = both.name;
    column.unit = both.unit.empty() ? timeUnitInName(both.name) : both.unit;
    if (i < header->units.size() && !header->units[i].empty()) {
      const std::string cell(header->units[i]);
      const NameAndUnit bracketed = splitNameAndUnit("x " + cell);
      column.unit = bracketed.unit.empty() ? cell : bracketed.unit;
      if (column.unit == "TS" || column.unit == "RN") column.unit.clear();  // Campbell: a time stamp, a row number
    }
    if (i == 0 && !unnamed.empty()) column.unit = unnamed;
  }
  layout.maxCells = std::max(layout.maxCells, static_cast<int>(header->names.size()));
  return Done{};
}

}  // namespace stillcut::record
