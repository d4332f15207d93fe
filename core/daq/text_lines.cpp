#include "core/daq/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr std::size_t kBuffer = 8192;
constexpr std::string_view kBetween = ",; \t\r";

// The next word, taken off the front; empty: none.
std::string_view nextWord(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(kBetween);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  const std::size_t end = std::min(line.find_first_of(kBetween, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

}  // namespace

TextLines::TextLines(int channels, bool counted) : channels_(channels), counted_(counted), buffer_(kBuffer) {}

void TextLines::reset() noexcept {
  begin_ = end_ = 0;
  whole_ = started_ = false;
  lost_ = 0;
}

std::size_t TextLines::feed(std::string_view bytes) noexcept {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
            buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) {  // no line is that long
    end_ = 0;
    whole_ = false;
  }
  const std::size_t n = std::min(bytes.size(), buffer_.size() - end_);
  std::copy_n(bytes.begin(), n, buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
  end_ += n;
  return n;
}

bool TextLines::parse(std::string_view line, std::span<float> values, std::uint64_t& number) const noexcept {
  if (counted_) {
    const std::string_view word = nextWord(line);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || error != std::errc() || end != word.data() + word.size()) return false;
  }
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    std::string_view word = nextWord(line);
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), values[c]);
    if (word.empty() || error != std::errc() || end != word.data() + word.size() || !std::isfinite(values[c])) {
      return false;
    }
  }
  return nextWord(line).empty();
}

bool TextLines::take(std::span<float> values, std::uint64_t& lost) noexcept {
  while (true) {
    const auto from = buffer_.begin() + static_cast<std::ptrdiff_t>(begin_);
    const auto to = buffer_.begin() + static_cast<std::ptrdiff_t>(end_);
    const auto newline = std::find(from, to, '\n');
    if (newline == to) return false;
    const std::string_view line(&*from, static_cast<std::size_t>(newline - from));
    begin_ += line.size() + 1;
    if (!std::exchange(whole_, true)) continue;
    if (line.find_first_not_of(kBetween) == std::string_view::npos) continue;
    std::uint64_t number = 0;
    if (!parse(line, values, number)) {
      ++damaged_;
      if (!counted_) ++lost_;
      continue;
    }
    if (counted_) {
      if (started_ && number != expected_) lost_ = number > expected_ ? number - expected_ : kUnknown;
      started_ = true;
      expected_ = number + 1;
    }
    lost = std::exchange(lost_, 0);
    return true;
  }
}

}  // namespace stillcut::daq
