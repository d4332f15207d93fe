#include "core/formats/text/line_reader.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace stillcut::record {

LineReader::LineReader(std::string path) : path_(std::move(path)), buffer_(4 * kLongestLine) {}

Status LineReader::open() {
  auto bytes = openText(path_);
  if (!bytes) return bytes.error();
  bytes_ = std::move(bytes).value();
  return Done{};
}

Status LineReader::refill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  while (end_ < buffer_.size() && !atEnd_) {
    const auto got = bytes_->read(buffer_.data() + end_, buffer_.size() - end_);
    if (!got) return got.error();
    end_ += *got;
    atEnd_ = *got == 0;
  }
  return Done{};
}

// Lines of old Macintosh programs end with CR alone.
void LineReader::findLineEnd() {
  const std::string_view first(buffer_.data(), end_);
  if (first.find('\n') == std::string_view::npos && first.find('\r') != std::string_view::npos) lineEnd_ = '\r';
}

namespace {

// What a logger that lost its power leaves in a line: zeros, with text at most beside them.
bool isTextWithZeros(std::string_view line) {
  return std::all_of(line.begin(), line.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte == 0 || byte >= 0x20 || c == '\t' || c == '\r';
  });
}

}  // namespace

Result<bool> LineReader::next(std::string_view& line) {
  const auto findEnd = [this] {
    return static_cast<const char*>(std::memchr(buffer_.data() + begin_, lineEnd_, end_ - begin_));
  };
  const char* newline = findEnd();
  if (newline == nullptr && !atEnd_) {
    if (const Status s = refill(); !s) return s.error();
    if (number_ == 0) findLineEnd();
    newline = findEnd();
  }
  if (newline == nullptr && begin_ == end_) return false;
  const char* start = buffer_.data() + begin_;
  const char* stop = newline != nullptr ? newline : buffer_.data() + end_;
  ++number_;
  const auto length = static_cast<std::size_t>(stop - start);
  if (length > kLongestLine)
    return Error{where(), message("the line is too long"), message("this is no text recording")};
  const std::string_view raw(start, length);
  constexpr std::int64_t kSurelyText = 400;  // lines: a file of other bytes shows itself in the first of them
  const bool zeros = std::memchr(start, '\0', length) != nullptr;
  if (zeros && (number_ <= kSurelyText || !isTextWithZeros(raw)))
    return Error{where(), message("holds bytes that are no text")};
  line = raw;
  if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  if (line.ends_with('\r')) line.remove_suffix(1);
  begin_ += length + (newline != nullptr ? 1 : 0);
  return true;
}

}  // namespace stillcut::record
