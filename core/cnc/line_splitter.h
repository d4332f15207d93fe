// LineSplitter: bytes in, lines out, in bounded memory. Any run of CR and LF ends a line (LinuxCNC ends some replies
// with CR LF and others with LF CR), empty lines are not handed on, and a line longer than the buffer is dropped whole.
// Thread: one. Real-time safe.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace stillcut::cnc {

class LineSplitter {
 public:
  static constexpr std::size_t kLongest = 2048;

  // Calls `take(std::string_view line)` for each line that `bytes` completes; the view is valid during the call.
  template <class Take>
  void feed(std::string_view bytes, Take&& take) {
    for (const char c : bytes) {
      if (c == '\r' || c == '\n') {
        if (overlong_) {
          ++dropped_;
        } else if (size_ > 0) {
          take(std::string_view(line_.data(), size_));
        }
        size_ = 0;
        overlong_ = false;
      } else if (size_ == kLongest) {
        overlong_ = true;
      } else {
        line_[size_++] = c;
      }
    }
  }

  void clear() noexcept {
    size_ = 0;
    overlong_ = false;
  }
  // Lines that were too long to be any protocol's.
  std::uint64_t dropped() const { return dropped_; }

 private:
  std::array<char, kLongest> line_;
  std::size_t size_ = 0;
  bool overlong_ = false;
  std::uint64_t dropped_ = 0;
};

}  // namespace stillcut::cnc
