// Numbers out of a peer's text: the whole word, finite, or nothing. Thread: any. Real-time safe.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace stillcut::cnc {

inline std::optional<double> wireNumber(std::string_view word) noexcept {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Takes the first word off `text`; words are parted by `separator`, several count as one.
inline std::string_view takeToken(std::string_view& text, char separator = ' ') noexcept {
  while (!text.empty() && text.front() == separator) text.remove_prefix(1);
  const std::size_t end = text.find(separator);
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end);
  return word;
}

}  // namespace stillcut::cnc
