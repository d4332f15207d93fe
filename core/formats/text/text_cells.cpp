#include "core/formats/text/text_cells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string>

#include "core/formats/utf_text.h"
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

namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isAllDigits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
}

std::optional<double> plainNumber(const char* first, const char* last) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(first, last, value);
  if (end != last) return std::nullopt;
  // Too small for a double becomes zero (or subnormal), too large infinity: strtod says which.
  if (problem == std::errc::result_out_of_range) return std::strtod(std::string(first, last).c_str(), nullptr);
  if (problem != std::errc{}) return std::nullopt;
  return value;
}

// What from_chars does not take: "+ 1.5", a typographic minus, Fortran's "1.5D-03" and "1.5-103".
std::optional<double> unusualNumber(std::string_view text) {
  constexpr std::string_view kMinus = "\xE2\x88\x92";
  std::string plain;
  bool negative = false;
  if (text.starts_with('+') || text.starts_with('-') || text.starts_with(kMinus)) {
    negative = !text.starts_with('+');
    text.remove_prefix(text.starts_with(kMinus) ? kMinus.size() : 1);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  }
  if (text.empty() || (!isDigit(text.front()) && text.front() != '.')) return std::nullopt;
  const std::size_t mantissa = text.find_first_not_of("0123456789.");
  plain = text.substr(0, mantissa);
  if (mantissa != std::string_view::npos) {
    std::string_view exponent = text.substr(mantissa);
    const bool letter = exponent.starts_with('D') || exponent.starts_with('d') || exponent.starts_with('E') ||
                        exponent.starts_with('e');
    if (letter) exponent.remove_prefix(1);
    const bool sign = exponent.starts_with('+') || exponent.starts_with('-');
    const std::string_view digits = exponent.substr(sign ? 1 : 0);
    if (!isAllDigits(digits) || (!letter && (!sign || digits.size() != 3))) return std::nullopt;
    plain += "e" + std::string(exponent.starts_with('+') ? digits : exponent);
  }
  const std::optional<double> value = plainNumber(plain.data(), plain.data() + plain.size());
  return value && negative ? std::optional<double>(-*value) : value;
}

}  // namespace

std::string shownText(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string clean(cutUtf8(utf8Of(trimmed(text)), kShown));
  std::replace_if(
      clean.begin(), clean.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return clean;
}

bool isGrouped(std::string_view cell, char sign) {
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  const std::size_t at = cell.find(sign);
  if (at == std::string_view::npos || at == 0 || at > 3 || cell.front() == '0') return false;
  if (!isAllDigits(cell.substr(0, at)) || (cell.size() - at) % 4 != 0) return false;
  for (std::size_t i = at; i < cell.size(); i += 4) {
    if (cell[i] != sign || !isAllDigits(cell.substr(i + 1, 3))) return false;
  }
  return true;
}

namespace {

// A sign that parts thousands and can be no decimal sign: blanks of every width, an apostrophe.
std::size_t plainGroupSign(std::string_view text) {
  for (const std::string_view sign : {" ", "'", "\xC2\xA0", "\xE2\x80\x89", "\xE2\x80\xAF", "\xE2\x80\x99"}) {
    if (text.starts_with(sign)) return sign.size();
  }
  return 0;
}

// "-1,023.11" where decimals have a point, "-1.023,11" where they have a comma, "1 023,11": with both signs in it, or
// with one that is none of decimals, a cell can be read in one way alone. The number without them; empty: it is none
// of these.
std::string withoutThousands(std::string_view cell, bool decimalComma) {
  const char decimal = decimalComma ? ',' : '.';
  const char other = decimalComma ? '.' : ',';
  const std::size_t point = cell.find(decimal);
  std::string plain;
  std::size_t digits = 0, groups = 0;
  for (std::size_t i = 0; i < std::min(point, cell.size());) {
    if (isDigit(cell[i]) || (i == 0 && (cell[i] == '-' || cell[i] == '+'))) {
      digits += isDigit(cell[i]) ? 1 : 0;
      plain += cell[i++];
      continue;
    }
    const std::size_t sign = cell[i] == other && point != std::string_view::npos ? 1 : plainGroupSign(cell.substr(i));
    const bool blank = cell[i] == ' ' && point == std::string_view::npos;  // may part two columns
    if (sign == 0 || blank || digits == 0 || digits > 3 || (groups > 0 && digits != 3)) return "";
    ++groups;
    digits = 0;
    i += sign;
  }
  if (groups == 0 || digits != 3) return "";
  if (point == std::string_view::npos) return plain;
  const std::string_view decimals = cell.substr(point + 1);
  return isAllDigits(decimals) ? plain + "." + std::string(decimals) : "";
}

}  // namespace

std::optional<double> parseNumber(std::string_view cell, bool decimalComma) {
  constexpr std::size_t kLongest = 64;
  if (cell.empty() || cell.size() >= kLongest) return std::nullopt;
  std::array<char, kLongest> text{};
  std::copy(cell.begin(), cell.end(), text.begin());
  if (decimalComma) {
    if (isGrouped(cell, '.')) return std::nullopt;  // thousands, or a decimal point: nobody can tell
    std::replace(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(cell.size()), ',', '.');
  }
  const char* last = text.data() + cell.size();
  if (const std::optional<double> value = plainNumber(text.data(), last)) return value;
  if (const std::optional<double> value = unusualNumber({text.data(), cell.size()})) return value;
  const std::string plain = withoutThousands(cell, decimalComma);
  return plain.empty() ? std::nullopt : plainNumber(plain.data(), plain.data() + plain.size());
}

}  // namespace stillcut::record
