#include "core/formats/text/text_cells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string>

#include "core/units/unit_names.h"

namespace stillcut::record {

namespace {

// Where the cell that begins at `at` ends, or nowhere. What stands in quotes holds no delimiter; a quote that is never
// closed is a letter.
template <class Find>
std::size_t endOfCell(std::string_view line, std::size_t at, Find find) {
  const std::size_t first = line.find_first_not_of(' ', at);
  if (first != std::string_view::npos && line[first] == '"') {
    const std::size_t closing = line.find('"', first + 1);
    if (closing != std::string_view::npos) return find(closing + 1);
  }
  return find(at);
}

}  // namespace

void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  cells.clear();
  if (delimiter == ' ') {
    constexpr std::string_view kBlank = " \t";
    for (std::size_t at = line.find_first_not_of(kBlank); at != std::string_view::npos;) {
      const std::size_t stop = endOfCell(line, at, [&](std::size_t from) { return line.find_first_of(kBlank, from); });
      cells.push_back(trimmed(line.substr(at, stop - at)));
      at = stop == std::string_view::npos ? stop : line.find_first_not_of(kBlank, stop);
    }
    return;
  }
  std::size_t at = 0;
  while (true) {
    const std::size_t stop = endOfCell(line, at, [&](std::size_t from) { return line.find(delimiter, from); });
    cells.push_back(trimmed(line.substr(at, stop - at)));
    if (stop == std::string_view::npos) return;
    at = stop + 1;
  }
}

bool isSkippedLine(std::string_view line) {
  const std::string_view text = trimmed(line);
  if (text.empty()) return true;
  constexpr std::string_view kStamp = "0000-00-00 00:00";
  if (text.size() < kStamp.size()) return false;
  for (std::size_t i = 0; i < kStamp.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    const bool separator = text[i] == kStamp[i] || (kStamp[i] == ' ' && text[i] == 'T');
    if (kStamp[i] == '0' ? !digit : !separator) return false;
  }
  return text.find_first_not_of("0123456789:.Z", kStamp.size()) == std::string_view::npos;
}

std::optional<double> parseNumber(std::string_view cell, bool decimalComma) {
  constexpr std::size_t kLongest = 64;
  if (cell.empty() || cell.size() >= kLongest) return std::nullopt;
  std::array<char, kLongest> text{};
  std::copy(cell.begin(), cell.end(), text.begin());
  if (decimalComma) std::replace(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(cell.size()), ',', '.');
  const char* first = text.data();
  const char* last = first + cell.size();
  if (*first == '+') {
    ++first;
    if (first == last || *first == '-') return std::nullopt;
  }
  double value = 0.0;
  const auto [end, problem] = std::from_chars(first, last, value);
  if (end != last) return std::nullopt;
  // Too small for a double becomes zero (or subnormal), too large infinity: strtod says which.
  if (problem == std::errc::result_out_of_range) return std::strtod(first, nullptr);
  if (problem != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace stillcut::record
