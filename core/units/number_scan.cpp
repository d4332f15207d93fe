#include "core/units/number_scan.h"

#include <charconv>
#include <cmath>

namespace stillcut::uff {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

// Length of the exponent at the start of `s` and its value: "E+05", "D-3", or, Fortran's way for three digits, "-103".
std::size_t takeExponent(std::string_view s, int& value) {
  std::size_t i = 0;
  const bool letter = !s.empty() && (s[0] == 'e' || s[0] == 'E' || s[0] == 'd' || s[0] == 'D');
  if (letter) ++i;
  bool negative = false;
  const bool sign = i < s.size() && (s[i] == '+' || s[i] == '-');
  if (sign) negative = s[i++] == '-';
  if (!letter && !sign) return 0;
  const std::size_t firstDigit = i;
  int exponent = 0;
  while (i < s.size() && isDigit(s[i]) && i - firstDigit < 4) exponent = exponent * 10 + (s[i++] - '0');
  const std::size_t digits = i - firstDigit;
  if (digits == 0 || digits > 3) return 0;
  // Without the letter only exactly three digits are an exponent; anything else is the next number.
  if (!letter && (digits != 3 || (i < s.size() && (s[i] == '.' || isDigit(s[i]))))) return 0;
  value = negative ? -exponent : exponent;
  return i;
}

}  // namespace

std::optional<double> takeNumber(std::string_view& text) {
  std::string_view s = text;
  if (!s.empty() && s[0] == '+') s.remove_prefix(1);
  double mantissa = 0.0;
  auto [end, ec] = std::from_chars(s.data(), s.data() + s.size(), mantissa, std::chars_format::fixed);
  if (ec != std::errc()) return std::nullopt;
  const std::size_t mantissaLength = static_cast<std::size_t>(end - s.data());
  int exponent = 0;
  const bool finite = std::isfinite(mantissa);
  const std::size_t exponentLength = finite ? takeExponent(s.substr(mantissaLength), exponent) : 0;
  double value = mantissa;
  if (exponentLength > 0) {
    // Through from_chars again, so that the value is the correctly rounded one.
    std::string exact(s.substr(0, mantissaLength));
    exact += "e" + std::to_string(exponent);
    const auto again = std::from_chars(exact.data(), exact.data() + exact.size(), value);
    if (again.ec == std::errc::result_out_of_range) value = exponent > 0 ? HUGE_VAL : 0.0;
  }
  text = s.substr(mantissaLength + exponentLength);
  return value;
}

std::optional<double> wholeNumber(std::string_view text) {
  text = trimmed(text);
  const auto value = takeNumber(text);
  return value && text.empty() ? value : std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view takeLine(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 40)) out += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > 40) out += "...";
  return out;
}

}  // namespace stillcut::uff
