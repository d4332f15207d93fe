// LineReader: a text file line by line, with bounded memory whatever the file holds.
// Thread: its owner's; not real-time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/formats/text/text_bytes.h"

namespace stillcut::record {

class LineReader {
 public:
  // A line longer than this is no line of numbers.
  static constexpr std::size_t kLongestLine = std::size_t{64} * 1024;

  explicit LineReader(std::string path);
  Status open();
  // The next line without its end (LF, CR LF, or CR alone) and without a byte-order mark; valid until the next call.
  // False: the end. Error: unreadable, a line too long, or bytes that are no text; zeros far behind the first lines are
  // what a loss of power leaves, and given as they are.
  Result<bool> next(std::string_view& line);
  // Of the line last returned, counted from 1.
  std::int64_t number() const { return number_; }
  // "file:12", for errors about the line last returned.
  std::string where() const { return path_ + ":" + std::to_string(number_); }

 private:
  Status refill();
  void findLineEnd();

  std::string path_;
  std::unique_ptr<TextBytes> bytes_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // unread part of buffer_
  std::size_t end_ = 0;
  bool atEnd_ = false;
  char lineEnd_ = '\n';
  std::int64_t number_ = 0;
};

}  // namespace stillcut::record
