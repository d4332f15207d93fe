#include "core/formats/universal/byte_window.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace stillcut::uff {

ByteWindow::ByteWindow(std::string_view bytes) : memory_(bytes), size_(bytes.size()) {}

Result<ByteWindow> ByteWindow::open(const std::string& path) {
  ByteWindow window;
  std::error_code problem;
  window.size_ = std::filesystem::file_size(path, problem);
  if (problem) return Error{path, message("cannot be read"), foreign(problem.message())};
  window.file_.open(path, std::ios::binary);
  if (!window.file_) return Error{path, message("cannot be opened"), foreign(std::strerror(errno))};
  window.buffer_.resize(kCapacity);
  return window;
}

void ByteWindow::seek(std::uint64_t position) {
  position_ = std::min(position, size_);
  begin_ = 0;
  end_ = 0;
  if (buffer_.empty()) return;
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(position_));
}

std::string_view ByteWindow::buffered() const {
  if (buffer_.empty()) return memory_.substr(static_cast<std::size_t>(position_));
  return {buffer_.data() + begin_, end_ - begin_};
}

void ByteWindow::refill() {
  if (buffer_.empty()) return;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  file_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  end_ += static_cast<std::size_t>(file_.gcount());
  // Cut short behind our back, or a device error: what is here is all there is.
  if (!file_ && !file_.eof()) size_ = position_ + end_;
  if (file_.eof()) size_ = std::min(size_, position_ + end_);
}

void ByteWindow::advance(std::size_t count) {
  begin_ += buffer_.empty() ? 0 : count;
  position_ += count;
}

std::string_view ByteWindow::line() {
  std::size_t stop = buffered().find('\n');
  if (stop == std::string_view::npos) {
    refill();
    stop = buffered().find('\n');
  }
  std::string_view text = buffered().substr(0, stop);
  advance(std::min(text.size() + 1, buffered().size()));
  if (stop == std::string_view::npos && left() > 0) {  // longer than the buffer: no line of a universal file
    std::size_t end = std::string_view::npos;
    while (end == std::string_view::npos && left() > 0) {
      refill();
      end = buffered().find('\n');
      advance(std::min(end == std::string_view::npos ? buffered().size() : end + 1, buffered().size()));
    }
    return "a line longer than any of this format";
  }
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return text;
}

std::string_view ByteWindow::take(std::size_t count) {
  if (buffered().size() < count) refill();
  const std::string_view bytes = buffered().substr(0, count);
  advance(bytes.size());
  return bytes;
}

}  // namespace stillcut::uff
