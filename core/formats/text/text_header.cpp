#include "core/formats/text/text_header.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "core/formats/time_stamps.h"
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

// "time_ms", "Time us", "t_s", "seconds_elapsed", "milliseconds": the unit of a time that is part of its name.
std::string timeUnitInName(const std::string& name) {
  if (meaningOfName(name) != NameMeaning::Time) return "";
  constexpr std::string_view kGaps = "_ ";
  const auto unit = [](const std::string& word) {
    const std::optional<UnitMeaning> meaning = unitFromText(word);
    return meaning && meaning->kind == UnitKind::Time && word != "min" ? word : "";
  };
  const std::size_t last = name.find_last_of(kGaps);
  if (last == std::string::npos) return name.size() > 1 ? unit(name) : "";
  const std::string end = unit(name.substr(last + 1));
  const std::string begin = name.substr(0, name.find_first_of(kGaps));
  return end.empty() && begin.size() > 1 ? unit(begin) : end;
}

// "#time", "% Time (s)": the sign of a comment, not part of the first name.
std::string_view withoutCommentSign(std::string_view line) {
  const std::size_t at = line.find_first_not_of("#%/! ");
  if (at == 0 || at == std::string_view::npos) return line;
  const auto c = static_cast<unsigned char>(line[at]);
  return std::isalpha(c) != 0 || c >= 0x80 || c == '"' ? line.substr(at) : line;
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

std::optional<Header> findHeader(std::span<const std::string> lines, std::size_t firstData, const TextLayout& layout) {
  const auto cellsOf = [&](std::size_t line) {
    Cells cells;
    splitCells(withoutCommentSign(lines[line]), layout.cells.delimiter, cells);
    return cells;
  };
  bool apart = false;
  const std::optional<std::size_t> nearest = lineAbove(lines, firstData, apart);
  if (!nearest) return std::nullopt;
  Header header{cellsOf(*nearest), {}, *nearest + 1};
  if (!isHeaderLine(header.names, layout) || (apart && header.names.size() < 2)) return std::nullopt;
  if (!isUnitsLine(header.names, layout)) return header;
  const std::optional<std::size_t> above = lineAbove(lines, *nearest, apart);
  if (!above) return header;
  Cells names = cellsOf(*above);
  if (!isHeaderLine(names, layout) || names.size() < static_cast<std::size_t>(layout.minCells)) return header;
  return Header{std::move(names), std::move(header.names), *above + 1};
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
  const auto named = static_cast<std::size_t>(std::count_if(
      header.names.begin(), header.names.end(), [](std::string_view c) { return !c.empty() && c != "Comment"; }));
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
  const std::optional<Header> header = findHeader(lines, firstData, layout);
  if (!header) return Done{};
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
    }
  }
  layout.maxCells = std::max(layout.maxCells, static_cast<int>(header->names.size()));
  return Done{};
}

}  // namespace stillcut::record
