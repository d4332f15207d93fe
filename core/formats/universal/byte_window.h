// ByteWindow: bytes of a file (or of memory) front to back through a buffer of fixed size: lines, and runs of raw
// bytes. Thread: one at a time. A device error while reading ends the bytes early, as a truncated file does.
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stillcut::uff {

class ByteWindow {
 public:
  static constexpr std::size_t kCapacity = std::size_t{64} * 1024;  // of the buffer over a file [bytes]

  // Over bytes that outlive the window.
  explicit ByteWindow(std::string_view bytes);
  static Result<ByteWindow> open(const std::string& path);

  bool atEnd() { return left() == 0; }
  // Bytes that follow.
  std::uint64_t left() const { return size_ - position_; }
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position);
  // The next line without its end (LF or CR LF). A line longer than the buffer is skipped to its
  // end and given as words that are no data. Valid until the next call.
  std::string_view line();
  // The next `count` bytes, fewer only at the end; `count` is at most kCapacity. Valid until the next call.
  std::string_view take(std::size_t count);

 private:
  ByteWindow() = default;
  std::string_view buffered() const;
  void refill();
  void advance(std::size_t count);

  std::string_view memory_;
  std::ifstream file_;
  std::vector<char> buffer_;  // empty: over memory
  std::size_t begin_ = 0;     // unread part of buffer_
  std::size_t end_ = 0;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
};

}  // namespace stillcut::uff
