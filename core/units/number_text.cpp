#include "core/units/number_text.h"

#include <charconv>
#include <cmath>

namespace stillcut::config {

std::string numberText(double value) {
  constexpr double kSmallestPlain = 1e-4;
  constexpr double kLargestPlain = 1e15;
  const double size = std::abs(value);
  const bool plain = size == 0.0 || (size >= kSmallestPlain && size < kLargestPlain);
  char digits[48];
  const auto end = plain ? std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed)
                         : std::to_chars(digits, digits + sizeof digits, value);
  return {digits, end.ptr};
}

}  // namespace stillcut::config
