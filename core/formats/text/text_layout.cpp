#include "core/formats/text/text_layout.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

using Cells = std::vector<std::string_view>;

bool isNumeric(std::string_view cell, bool decimalComma) {
  return parseNumber(cell, decimalComma).has_value();
}

// At least one number, and nothing that is neither a number nor empty.
bool isDataLine(const Cells& cells, bool decimalComma) {
  int numbers = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    if (!isNumeric(cell, decimalComma)) return false;
    ++numbers;
  }
  return numbers > 0;
}

struct Candidate {
  CellFormat format;
  std::size_t first = 0;  // index into lines
  std::size_t cells = 0;
  bool found = false;
};

// Numbers begin where three lines in a row (or all that are left) are data lines with the same number of cells. The
// last cell may be missing from later lines: LabVIEW puts a comment on the first.
Candidate findData(std::span<const std::string> lines, bool complete, CellFormat format) {
  Candidate c{format, 0, 0, false};
  Cells cells;
  std::size_t run = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (isSkippedLine(lines[i])) continue;
    splitCells(lines[i], format.delimiter, cells);
    if (!isDataLine(cells, format.decimalComma)) {
      run = 0;
      continue;
    }
    if (run == 0 || cells.size() != c.cells) {
      c.first = i;
      c.cells = cells.size();
      run = 1;
    } else if (++run == 3) {
      c.found = true;
      return c;
    }
  }
  c.found = run >= 2 && complete;
  return c;
}

Candidate findBestData(std::span<const std::string> lines, bool complete) {
  constexpr auto kFormats = std::to_array<CellFormat>(
      {{'\t', false}, {';', false}, {'\t', true}, {';', true}, {',', false}, {' ', false}, {' ', true}});
  Candidate best;
  for (const CellFormat format : kFormats) {
    const Candidate c = findData(lines, complete, format);
    if (c.found && (!best.found || c.cells > best.cells)) best = c;
  }
  return best;
}

// A word, not a number or a date: "Fx", "[N]", "%".
bool looksLikeHeaderCell(std::string_view cell) {
  const auto c = static_cast<unsigned char>(cell.front());
  return std::isalpha(c) != 0 || c >= 0x80 || c == '[' || c == '(' || c == '%' || c == '_' || c == '#';
}

bool isHeaderLine(const Cells& cells, std::size_t columns) {
  if (cells.size() < columns) return false;
  std::size_t words = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    if (!looksLikeHeaderCell(cell)) return false;
    ++words;
  }
  return words > 0;
}

bool isUnitsLine(const Cells& cells) {
  return std::all_of(cells.begin(), cells.end(),
                     [](std::string_view c) { return c.empty() || unitFromText(c).has_value(); });
}

// "time_ms", "Time us", "t_s": the unit of a time that stands at the end of its name.
std::string timeUnitAtEnd(const std::string& name) {
  const std::size_t gap = name.find_last_of("_ ");
  if (gap == std::string::npos || meaningOfName(name) != NameMeaning::Time) return "";
  const std::string end = name.substr(gap + 1);
  const std::optional<UnitMeaning> unit = unitFromText(end);
  return unit && unit->kind == UnitKind::Time ? end : "";
}

// Names, and units from brackets or from a line of their own, out of the lines just above the numbers.
Status readHeader(std::span<const std::string> lines, std::size_t firstData, TextLayout& layout,
                  const std::string& where) {
  if (firstData == 0) return Done{};
  std::string_view nearest = lines[firstData - 1];
  if (nearest.starts_with("# ")) nearest.remove_prefix(2);
  Cells header;
  splitCells(nearest, layout.cells.delimiter, header);
  if (!isHeaderLine(header, layout.columns.size())) return Done{};
  Cells units;
  if (firstData >= 2 && isUnitsLine(header)) {
    Cells above;
    splitCells(lines[firstData - 2], layout.cells.delimiter, above);
    if (isHeaderLine(above, layout.columns.size())) {
      units = header;
      header = above;
    }
  }
  // Names would stand over the wrong numbers. LabVIEW's column of comments is one that most rows leave out.
  const auto named = static_cast<std::size_t>(
      std::count_if(header.begin(), header.end(), [](std::string_view c) { return !c.empty() && c != "Comment"; }));
  if (named > layout.columns.size()) {
    return Error{where + ":" + std::to_string(firstData),
                 message("names %1 columns where the rows have %2", std::to_string(named),
                         std::to_string(layout.columns.size())),
                 message("put names that hold the delimiter in quotes")};
  }
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const NameAndUnit both = splitNameAndUnit(header[i]);
    layout.columns[i].name = both.name;
    layout.columns[i].unit = both.unit.empty() ? timeUnitAtEnd(both.name) : both.unit;
    if (i < units.size() && !units[i].empty()) {
      const std::string cell(units[i]);
      const NameAndUnit bracketed = splitNameAndUnit("x " + cell);
      layout.columns[i].unit = bracketed.unit.empty() ? cell : bracketed.unit;
    }
  }
  layout.maxCells = std::max(layout.maxCells, static_cast<int>(header.size()));
  return Done{};
}

// Key, then one value per channel, up to the numbers.
Status readLabViewHeader(std::span<const std::string> lines, std::size_t firstData, TextLayout& layout,
                         const std::string& where) {
  layout.kind = "LabVIEW measurement text";
  const std::size_t shift = !layout.columns.empty() && layout.columns[0].name == "X_Value" ? 1 : 0;
  Cells cells;
  for (std::size_t i = 0; i < firstData; ++i) {
    splitCells(lines[i], layout.cells.delimiter, cells);
    if (cells.size() < 2) continue;
    const std::string lineWhere = where + ":" + std::to_string(i + 1);
    if (cells[0] == "X_Columns" && cells[1] == "Multi") {
      return Error{lineWhere, message("every channel has a time column of its own"),
                   message("export with one X column")};
    }
    if (cells[0] == "Y_Unit_Label") {
      for (std::size_t k = 1; k < cells.size() && k - 1 + shift < layout.columns.size(); ++k) {
        if (!cells[k].empty()) layout.columns[k - 1 + shift].unit = std::string(cells[k]);
      }
    }
    if (cells[0] == "Delta_X") {
      const std::optional<double> step = parseNumber(cells[1], layout.cells.decimalComma);
      if (!step || !(*step > 0.0) || !std::isfinite(*step)) {
        return Error{lineWhere, message("Delta_X holds '%1'", cells[1]),
                     message("a time step above zero was expected")};
      }
      layout.rateFromHeader = Hertz(1.0 / *step);
    }
  }
  return Done{};
}

bool namesTime(const TextColumn& column) {
  if (column.empty) return false;
  const std::optional<UnitMeaning> unit = unitFromText(column.unit);
  if (unit && unit->kind != UnitKind::Time) return false;
  return meaningOfName(column.name) == NameMeaning::Time || (unit && unit->kind == UnitKind::Time);
}

// Without a header: the first column, where it grows in even steps as only time does.
bool growsEvenly(std::span<const std::string> lines, const Candidate& data) {
  constexpr std::size_t kFewest = 8;
  Cells cells;
  std::vector<double> times;
  for (std::size_t i = data.first; i < lines.size(); ++i) {
    if (isSkippedLine(lines[i])) continue;
    splitCells(lines[i], data.format.delimiter, cells);
    if (cells.size() < 2) continue;
    const std::optional<double> t = parseNumber(cells[0], data.format.decimalComma);
    if (!t) return false;
    times.push_back(*t);
  }
  if (times.size() < kFewest) return false;
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  return step > 0.0 && std::adjacent_find(times.begin(), times.end(), [step](double a, double b) {
                         return std::abs(b - a - step) > 0.2 * step;
                       }) == times.end();
}

void findTimeColumn(std::span<const std::string> lines, const Candidate& data, TextLayout& layout) {
  const auto named = std::find_if(layout.columns.begin(), layout.columns.end(), namesTime);
  const bool header =
      std::any_of(layout.columns.begin(), layout.columns.end(), [](const TextColumn& c) { return !c.name.empty(); });
  if (named != layout.columns.end()) {
    layout.timeColumn = static_cast<int>(named - layout.columns.begin());
    const std::optional<UnitMeaning> unit = unitFromText(named->unit);
    if (unit && unit->kind == UnitKind::Time) layout.secondsPerTime = unit->toSi;
  } else if (!header && layout.columns.size() >= 2 && growsEvenly(lines, data)) {
    layout.timeColumn = 0;
  }
}

void findEmptyColumns(std::span<const std::string> lines, const Candidate& data, TextLayout& layout) {
  for (TextColumn& column : layout.columns) column.empty = true;
  Cells cells;
  for (std::size_t i = data.first; i < lines.size(); ++i) {
    if (isSkippedLine(lines[i])) continue;
    splitCells(lines[i], data.format.delimiter, cells);
    for (std::size_t k = 0; k < std::min(cells.size(), layout.columns.size()); ++k) {
      if (!cells[k].empty()) layout.columns[k].empty = false;
    }
  }
  layout.minCells = layout.maxCells = static_cast<int>(layout.columns.size());
  while (layout.minCells > 1 && layout.columns[static_cast<std::size_t>(layout.minCells - 1)].empty) --layout.minCells;
}

}  // namespace

Result<TextLayout> detectTextLayout(std::span<const std::string> lines, bool complete, const std::string& where) {
  if (lines.empty()) return Error{where, message("the file is empty")};
  const Candidate data = findBestData(lines, complete);
  if (!data.found) {
    return Error{where, message("no rows of numbers found in its first %1 lines", std::to_string(lines.size())),
                 message("is this a recording?")};
  }
  TextLayout layout;
  layout.cells = data.format;
  layout.firstDataLine = static_cast<std::int64_t>(data.first) + 1;
  layout.columns.resize(data.cells);
  findEmptyColumns(lines, data, layout);
  if (const Status s = readHeader(lines, data.first, layout, where); !s) return s.error();
  findTimeColumn(lines, data, layout);
  if (trimmed(lines[0]).starts_with("DynoWare")) layout.kind = "DynoWare text";
  if (trimmed(lines[0]).starts_with("LabVIEW Measurement")) {
    if (const Status s = readLabViewHeader(lines, data.first, layout, where); !s) return s.error();
  }
  return layout;
}

}  // namespace stillcut::record
