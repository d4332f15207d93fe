#include "core/formats/text/text_times.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/formats/time_stamps.h"
#include "core/formats/wall_clock.h"
#include "core/units/time_names.h"
#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

using Cells = std::vector<std::string_view>;
constexpr std::int64_t kDay_ns = std::int64_t{86'400} * 1'000'000'000;

bool isTimeUnit(const TextColumn& column) {
  const std::optional<UnitMeaning> unit = unitFromText(column.unit);
  return unit && unit->kind == UnitKind::Time;
}

// A time by its name, in a unit that is not known to be one of something else.
bool namesTime(const TextColumn& column) {
  return meaningOfName(column.name) == NameMeaning::Time && (isTimeUnit(column) || !unitFromText(column.unit));
}

// All cells of a column in the lines at hand.
std::vector<std::string> cellsOf(std::span<const std::string> lines, const DataRows& rows, std::size_t column) {
  std::vector<std::string> all;
  forEachRow(lines, rows, [&](const Cells& cells) {
    if (column < cells.size() && !cells[column].empty()) all.emplace_back(cells[column]);
  });
  return all;
}

// Columns of time stamps: what more than half of their cells say.
void findStamps(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    const std::vector<std::string> cells = cellsOf(lines, rows, k);
    const auto clocks = std::count_if(cells.begin(), cells.end(), [](const std::string& cell) {
      const auto stamp = parseTimeStamp(cell);
      return stamp && stamp->hasClock;
    });
    const auto stamps = std::count_if(cells.begin(), cells.end(),
                                      [](const std::string& cell) { return parseTimeStamp(cell).has_value(); });
    layout.columns[k].stamps = 2 * stamps > static_cast<std::ptrdiff_t>(cells.size());
    layout.columns[k].clock = 2 * clocks > static_cast<std::ptrdiff_t>(cells.size());
  }
}

std::vector<double> numbersOf(std::span<const std::string> lines, const DataRows& rows, std::size_t column) {
  std::vector<double> numbers;
  for (const std::string& cell : cellsOf(lines, rows, column)) {
    const std::optional<double> number = parseNumber(cell, rows.format.decimalComma);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

bool growsEvenly(const std::vector<double>& numbers) {
  constexpr std::size_t kFewest = 8;
  if (numbers.size() < kFewest) return false;
  const double step = (numbers.back() - numbers.front()) / static_cast<double>(numbers.size() - 1);
  return step > 0.0 && std::adjacent_find(numbers.begin(), numbers.end(), [step](double a, double b) {
                         return std::abs(b - a - step) > 0.2 * step;
                       }) == numbers.end();
}

bool countsRows(const std::vector<double>& numbers) {
  return std::adjacent_find(numbers.begin(), numbers.end(), [](double a, double b) { return b - a != 1.0; }) ==
         numbers.end();
}

// A column without a unit that counts 0, 1, 2 all the way is the number of the row, whatever its name.
void findRowNumbers(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  constexpr std::size_t kFewest = 50;
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    TextColumn& column = layout.columns[k];
    if (column.empty || column.stamps || column.words || !column.unit.empty() ||
        static_cast<int>(k) == layout.timeColumn)
      continue;
    const std::vector<double> numbers = numbersOf(lines, rows, k);
    column.rowNumber = column.rowNumber || (numbers.size() >= kFewest && countsRows(numbers));
  }
}

// Columns of labels: what more than half of their cells say.
void findWords(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  if (!rows.words) return;
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    const std::vector<std::string> cells = cellsOf(lines, rows, k);
    const auto words = std::count_if(cells.begin(), cells.end(), [&rows](const std::string& cell) {
      return !parseNumber(cell, rows.format.decimalComma) && !parseTimeStamp(cell);
    });
    layout.columns[k].words = 2 * words > static_cast<std::ptrdiff_t>(cells.size());
  }
}

// Without a header: the first column with something in it, where it grows in even steps as only time does. One that
// counts 0, 1, 2 is the number of the row.
void findUnnamed(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  const auto first =
      std::find_if(layout.columns.begin(), layout.columns.end(), [](const TextColumn& c) { return !c.empty; });
  const auto filled =
      std::count_if(layout.columns.begin(), layout.columns.end(), [](const TextColumn& c) { return !c.empty; });
  if (filled < 2) return;
  const auto index = static_cast<std::size_t>(first - layout.columns.begin());
  const std::vector<double> numbers = numbersOf(lines, rows, index);
  if (!growsEvenly(numbers)) return;
  first->rowNumber = countsRows(numbers);
  if (!first->rowNumber) layout.timeColumn = static_cast<int>(index);
}

// 1990 to 2100 in days since 1900, in steps far below a second.
bool looksLikeDays(const std::vector<double>& numbers) {
  constexpr double kFrom = 32'874.0, kTo = 73'051.0, kSecond = 1.0 / 86'400.0;
  const double step =
      (numbers.back() - numbers.front()) / static_cast<double>(std::max<std::size_t>(numbers.size(), 2) - 1);
  return numbers.front() >= kFrom && numbers.front() < kTo && step > 0.0 && step < kSecond;
}

void settleUnit(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  const auto index = static_cast<std::size_t>(layout.timeColumn);
  const TextColumn& column = layout.columns[index];
  const std::optional<UnitMeaning> unit = unitFromText(column.unit);
  if (unit && unit->kind == UnitKind::Time) {
    layout.secondsPerTime = unit->toSi;
    return;
  }
  layout.unknownTimeUnit = column.unit;
  layout.timeUnitAssumed = true;
  const std::vector<double> numbers = numbersOf(lines, rows, index);
  if (numbers.empty()) return;
  layout.days = looksLikeDays(numbers);
  if (const auto epoch = epochUnit(numbers.front())) {
    layout.secondsPerTime = *epoch;
    layout.timeUnitAssumed = false;
    return;
  }
  // A number of UTC that is none since 1970 may be a time of day without its colons.
  const std::string name = column.name;
  if (layout.unknownTimeUnit.empty() && (name == "UTC" || name == "utc")) layout.unknownTimeUnit = name;
}

// Seconds per unit of a column of times; empty: nothing tells.
std::optional<double> unitOfTime(const TextColumn& column, const std::vector<double>& numbers,
                                 const TextLayout& layout) {
  const std::optional<UnitMeaning> unit = unitFromText(column.unit);
  if (unit && unit->kind == UnitKind::Time) return unit->toSi;
  if (const auto epoch = epochUnit(numbers.front())) return epoch;
  return layout.timeUnitAssumed ? std::optional(layout.secondsPerTime) : std::nullopt;
}

// Two clocks in one table, each over its own columns: the samples of one of them are not those of the other's moments.
void findOtherTime(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  if (layout.timeStamps) return;
  const auto stepOf = [&](std::size_t k) {
    const std::vector<double> numbers = numbersOf(lines, rows, k);
    if (!growsEvenly(numbers)) return 0.0;
    const bool main = static_cast<int>(k) == layout.timeColumn;
    const std::optional<double> unit = main ? layout.secondsPerTime : unitOfTime(layout.columns[k], numbers, layout);
    return unit.value_or(0.0) * (numbers.back() - numbers.front()) / static_cast<double>(numbers.size() - 1);
  };
  const double step = stepOf(static_cast<std::size_t>(layout.timeColumn));
  if (!(step > 0.0)) return;
  for (std::size_t k = 0; k < layout.columns.size(); ++k) {
    const TextColumn& column = layout.columns[k];
    const bool time = isTimeUnit(column) || namesTime(column);
    if (static_cast<int>(k) == layout.timeColumn || column.empty || column.stamps || !time) continue;
    constexpr double kApart = 0.01;
    const double other = stepOf(k);
    if (other > 0.0 && std::abs(other - step) > kApart * step) layout.otherTime = column.name;
  }
}

// Frequencies in even steps where times would be: a spectrum.
void findFrequencies(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  const auto first = std::find_if(layout.columns.begin(), layout.columns.end(),
                                  [](const TextColumn& c) { return !c.empty && !c.rowNumber; });
  if (first == layout.columns.end()) return;
  const std::string name = first->name.substr(0, first->name.find_first_of(" _[("));
  constexpr auto kNames = std::to_array<std::string_view>({"f", "freq", "freq.", "frequency", "frequenz", "hz"});
  const bool named = std::any_of(kNames.begin(), kNames.end(), [&name](std::string_view known) {
    return std::equal(name.begin(), name.end(), known.begin(), known.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
  });
  const bool frequencies = first->unit == "Hz" || first->unit == "kHz" || (named && first->unit.empty());
  const auto index = static_cast<std::size_t>(first - layout.columns.begin());
  if (frequencies && growsEvenly(numbersOf(lines, rows, index))) layout.frequencies = first->name;
}

// Of a column of dates alone beside one of times of day.
int findDates(const TextLayout& layout) {
  const auto dates = std::find_if(layout.columns.begin(), layout.columns.end(),
                                  [](const TextColumn& c) { return c.stamps && !c.clock; });
  return dates == layout.columns.end() ? -1 : static_cast<int>(dates - layout.columns.begin());
}

}  // namespace

void findTimeColumn(std::span<const std::string> lines, const DataRows& rows, TextLayout& layout) {
  findStamps(lines, rows, layout);
  findWords(lines, rows, layout);
  const auto find = [&layout](auto is) {
    const auto found = std::find_if(layout.columns.begin(), layout.columns.end(), is);
    return found == layout.columns.end() ? -1 : static_cast<int>(found - layout.columns.begin());
  };
  layout.timeColumn = find([](const TextColumn& c) { return !c.empty && !c.stamps && isTimeUnit(c); });
  if (layout.timeColumn < 0) layout.timeColumn = find([](const TextColumn& c) { return c.clock; });
  if (layout.timeColumn < 0)
    layout.timeColumn = find([](const TextColumn& c) { return !c.empty && !c.stamps && namesTime(c); });
  const bool header =
      std::any_of(layout.columns.begin(), layout.columns.end(), [](const TextColumn& c) { return !c.name.empty(); });
  if (layout.timeColumn < 0 && !header) findUnnamed(lines, rows, layout);
  findRowNumbers(lines, rows, layout);
  if (layout.timeColumn < 0) {
    findFrequencies(lines, rows, layout);
    return;
  }
  layout.timeStamps = layout.columns[static_cast<std::size_t>(layout.timeColumn)].clock;
  if (layout.timeStamps) {
    layout.dateColumn = findDates(layout);
  } else {
    settleUnit(lines, rows, layout);
  }
  findOtherTime(lines, rows, layout);
}

std::optional<double> TimeCells::seconds(std::string_view cell) {
  return stamps_ ? stampSeconds(cell) : numberSeconds(cell);
}

void TimeCells::beginOn(std::string_view date) {
  const std::optional<TimeStamp> stamp = parseTimeStamp(date);
  if (!begun_ && stamp) day_ = stamp->day;
}

std::optional<double> TimeCells::stampSeconds(std::string_view cell) {
  const std::optional<TimeStamp> stamp = parseTimeStamp(cell);
  if (!stamp || !stamp->hasClock) return std::nullopt;
  std::int64_t ns = stamp->clock_ns - stamp->zone_ns.value_or(0);
  if (stamp->day) {
    ns += *stamp->day * kDay_ns;
  } else if (begun_) {
    ns += (before_ns_ - ns) / kDay_ns * kDay_ns;  // days passed so far
    if (before_ns_ - ns > kDay_ns / 2) ns += kDay_ns;
  }
  if (!begun_) {
    origin_ = ns;
    if (stamp->day) {
      started_ns_ = stamp->zone_ns ? ns : localTime(ns);
    } else if (day_) {
      started_ns_ = stamp->zone_ns ? ns + *day_ * kDay_ns : localTime(ns + *day_ * kDay_ns);
    }
  }
  begun_ = true;
  before_ns_ = ns;
  return static_cast<double>(ns - origin_) * 1e-9;
}

// Nanoseconds since 1970 have more digits than a double: whole numbers are subtracted as such.
std::optional<double> TimeCells::numberSeconds(std::string_view cell) {
  std::int64_t whole = 0;
  double part = 0.0;
  const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), whole);
  if (end != cell.data() + cell.size() || problem != std::errc{}) {
    const std::optional<double> number = parseNumber(cell, decimalComma_);
    constexpr double kLargest = 9e15;
    if (!number || !std::isfinite(*number)) return std::nullopt;
    whole = std::abs(*number) < kLargest ? static_cast<std::int64_t>(std::floor(*number)) : 0;
    part = *number - static_cast<double>(whole);
  }
  if (!begun_) {
    origin_ = whole;
    originPart_ = part;
    begun_ = true;
    const double since1970 = (static_cast<double>(whole) + part) * secondsPerTime_;
    if (isEpoch(since1970)) started_ns_ = static_cast<std::int64_t>(since1970 * 1e9);
  }
  // Unsigned, for what a damaged cell holds may overflow.
  const auto steps = static_cast<std::int64_t>(static_cast<std::uint64_t>(whole) - static_cast<std::uint64_t>(origin_));
  return (static_cast<double>(steps) + (part - originPart_)) * secondsPerTime_;
}

}  // namespace stillcut::record
