#include "core/formats/text/line_reader.h"

#include <cerrno>
#include <cstring>
#include <utility>

namespace stillcut::record {

LineReader::LineReader(std::string path) : path_(std::move(path)), buffer_(4 * kLongestLine) {}

Status LineReader::open() {
  file_.open(path_, std::ios::binary);
  if (!file_) return Error{path_, message("cannot be opened"), foreign(std::strerror(errno))};
  return Done{};
}

Status LineReader::refill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  file_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  if (file_.bad()) return Error{path_, message("cannot be read"), message("input/output error")};
  end_ += static_cast<std::size_t>(file_.gcount());
  atEnd_ = file_.eof();
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
  if (number_ == 1 && (raw.starts_with("\xFF\xFE") || raw.starts_with("\xFE\xFF"))) {
    return Error{path_, message("is text in UTF-16"), message("save it as UTF-8")};
  }
  if (std::memchr(start, '\0', length) != nullptr) return Error{where(), message("holds bytes that are no text")};
  line = raw;
  if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  if (line.ends_with('\r')) line.remove_suffix(1);
  begin_ += length + (newline != nullptr ? 1 : 0);
  return true;
}

}  // namespace stillcut::record
