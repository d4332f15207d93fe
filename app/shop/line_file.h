// LineFile: the lines that another program appends to a file, or writes to our standard input ("-"). A file may be
// renamed (log rotation) and a new one take its name: the old one is read to its end first, then those that came
// between (NAME.1, NAME-20261128, uncompressed), in the order in which they were last written, also when all that
// happened while nobody was reading, as long as they lie in the same folder. One that was begun anew meanwhile is known
// by its first bytes, and read from its beginning. The file is only ever read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "app/shop/line_source.h"

namespace stillcut::shop {

class LineFile final : public LineSource {
 public:
  // `cursor`: of the last line that was taken; "": from the beginning. The file need not be there yet.
  LineFile(std::string path, const std::string& cursor);
  ~LineFile() override;
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  Result<std::vector<SourceLine>> read(std::size_t atMost) override;
  int descriptor() const override;
  bool goesOn() const override { return goesOn_; }
  bool atEnd() const override { return standardInput_ ? over_ && buffer_.empty() : idle_; }

  static constexpr std::size_t kLongestLine = 1U << 20U;  // what is longer is no line of a run and is passed over

 private:
  bool openOld(std::uint64_t inode, std::int64_t offset, const std::string& head);
  bool openNew();
  std::string rotatedAfter() const;
  bool fill();
  void takeLines(std::vector<SourceLine>& lines, std::size_t atMost);
  std::string cursor();

  std::string path_;
  bool standardInput_;
  int file_ = -1, watch_ = -1;
  std::uint64_t inode_ = 0;
  std::int64_t offset_ = 0;  // of the first byte of buffer_ in the file
  std::string head_;         // what stands for the first bytes of the file in a cursor,
  std::int64_t headAt_ = 0;  // as it was when so many had been read
  std::string buffer_;
  std::size_t searched_ = 0;  // no newline before it
  bool over_ = false, skipping_ = false, idle_ = false, goesOn_ = false;
};

}  // namespace stillcut::shop
