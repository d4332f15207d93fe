#include "core/formats/text/line_reader.h"

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

Result<bool> LineReader::next(std::string_view& line) {
  const auto findEnd = [this] {
    return static_cast<const char*>(std::memchr(buffer_.data() + begin_, '\n', end_ - begin_));
  };
  const char* newline = findEnd();
  if (newline == nullptr && !atEnd_) {
    if (const Status s = refill(); !s) return s.error();
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
  if (std::memchr(start, '\0', length) != nullptr) return Error{where(), message("holds bytes that are no text")};
  line = raw;
  if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  if (line.ends_with('\r')) line.remove_suffix(1);
  begin_ += length + (newline != nullptr ? 1 : 0);
  return true;
}

}  // namespace stillcut::record
