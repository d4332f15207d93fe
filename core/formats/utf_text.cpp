#include "core/formats/utf_text.h"

#include <optional>

namespace stillcut::record {
namespace {

constexpr std::uint32_t kNoLetter = '?';
constexpr std::uint32_t kHighHalves = 0xD800, kLowHalves = 0xDC00, kAfterHalves = 0xE000;
constexpr std::uint32_t kBeyond16 = 0x10000, kLast = 0x10FFFF;

bool isBetween(std::uint32_t value, std::uint32_t from, std::uint32_t end) {
  return value >= from && value < end;
}

void append(std::string& text, std::uint32_t letter) {
  const auto tail = [&text, letter](unsigned shift) { text += static_cast<char>(0x80U | (letter >> shift & 0x3FU)); };
  if (letter < 0x80) {
    text += static_cast<char>(letter);
  } else if (letter < 0x800) {
    text += static_cast<char>(0xC0U | letter >> 6U);
    tail(0);
  } else if (letter < kBeyond16) {
    text += static_cast<char>(0xE0U | letter >> 12U);
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xF0U | letter >> 18U);
    tail(12);
    tail(6);
    tail(0);
  }
}

// The first letter, and its bytes taken from `utf8`; nothing: it is none, and nothing is taken.
std::optional<std::uint32_t> takeLetter(std::string_view& utf8) {
  const auto byte = [&utf8](std::size_t i) { return static_cast<unsigned char>(utf8[i]); };
  const unsigned first = byte(0);
  const std::size_t length = 1U + (first >= 0xC2U) + (first >= 0xE0U) + (first >= 0xF0U);
  if (isBetween(first, 0x80, 0xC2) || first >= 0xF5U || utf8.size() < length) return std::nullopt;
  std::uint32_t letter = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return std::nullopt;
    letter = letter << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0x80, 0x800, kBeyond16};  // a longer form than needed is none
  if (letter < kLeast[length - 1] || letter > kLast || isBetween(letter, kHighHalves, kAfterHalves))
    return std::nullopt;
  utf8.remove_prefix(length);
  return letter;
}

}  // namespace

std::string fromUtf16(std::span<const std::uint16_t> letters) {
  std::string text;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const std::uint32_t letter = letters[i];
    const bool pair = isBetween(letter, kHighHalves, kLowHalves) && i + 1 < letters.size() &&
                      isBetween(letters[i + 1], kLowHalves, kAfterHalves);
    if (pair) {
      append(text, kBeyond16 + ((letter - kHighHalves) << 10U) + (letters[++i] - kLowHalves));
    } else {
      append(text, isBetween(letter, kHighHalves, kAfterHalves) ? kNoLetter : letter);
    }
  }
  return text;
}

std::vector<std::uint16_t> toUtf16(std::string_view utf8) {
  std::vector<std::uint16_t> letters;
  while (!utf8.empty()) {
    const std::optional<std::uint32_t> letter = takeLetter(utf8);
    if (!letter) utf8.remove_prefix(1);
    const std::uint32_t value = letter.value_or(kNoLetter);
    if (value < kBeyond16) {
      letters.push_back(static_cast<std::uint16_t>(value));
    } else {
      letters.push_back(static_cast<std::uint16_t>(kHighHalves + ((value - kBeyond16) >> 10U)));
      letters.push_back(static_cast<std::uint16_t>(kLowHalves + ((value - kBeyond16) & 0x3FFU)));
    }
  }
  return letters;
}

std::string utf8Of(std::string_view bytes) {
  for (std::string_view left = bytes; !left.empty();) {
    if (takeLetter(left)) continue;
    std::string text;
    for (const char c : bytes) append(text, static_cast<unsigned char>(c));
    return text;
  }
  return std::string(bytes);
}

std::string_view cutUtf8(std::string_view utf8, std::size_t most) {
  if (utf8.size() <= most) return utf8;
  while (most > 0 && (static_cast<unsigned char>(utf8[most]) & 0xC0U) == 0x80U) --most;
  return utf8.substr(0, most);
}

}  // namespace stillcut::record
