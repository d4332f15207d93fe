#include "core/formats/byte_stream.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

namespace stillcut::record {
namespace {

class PlainBytes final : public ByteStream {
 public:
  PlainBytes(std::ifstream file, std::uint64_t size) : file_(std::move(file)), left_(size) {}

  bool read(std::span<unsigned char> out) override {
    if (out.size() > left_) return false;
    left_ -= out.size();
    file_.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
    return static_cast<std::size_t>(file_.gcount()) == out.size();
  }
  std::uint64_t left() const { return left_; }

 private:
  std::ifstream file_;
  std::uint64_t left_;
};

class InflatedBytes final : public ByteStream {
 public:
  InflatedBytes(std::ifstream file, std::uint64_t packed) : packed_(std::move(file), packed) {
    ready_ = inflateInit2(&stream_, -MAX_WBITS) == Z_OK;
  }
  ~InflatedBytes() override { inflateEnd(&stream_); }
  InflatedBytes(const InflatedBytes&) = delete;
  InflatedBytes& operator=(const InflatedBytes&) = delete;

  bool read(std::span<unsigned char> out) override {
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<uInt>(out.size());
    while (ready_ && stream_.avail_out > 0) {
      if (stream_.avail_in == 0 && !refill()) return false;
      ready_ = inflate(&stream_, Z_NO_FLUSH) == Z_OK;
    }
    return stream_.avail_out == 0;
  }

 private:
  bool refill() {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(packed_.left(), in_.size()));
    if (part == 0 || !packed_.read(std::span(in_).first(part))) return false;
    stream_.next_in = in_.data();
    stream_.avail_in = static_cast<uInt>(part);
    return true;
  }

  PlainBytes packed_;
  bool ready_ = false;
  z_stream stream_{};
  std::array<unsigned char, 16384> in_{};
};

}  // namespace

bool ByteStream::skip(std::uint64_t count) {
  std::array<unsigned char, 16384> away;
  while (count > 0) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, away.size()));
    if (!read(std::span(away).first(part))) return false;
    count -= part;
  }
  return true;
}

Result<std::unique_ptr<ByteStream>> openPart(const FilePart& part) {
  std::ifstream file(part.path, std::ios::binary);
  if (!file) return Error{part.path, message("cannot be opened"), foreign(std::strerror(errno))};
  file.seekg(static_cast<std::streamoff>(part.from));
  if (part.deflated) return std::unique_ptr<ByteStream>(new InflatedBytes(std::move(file), part.packed));
  return std::unique_ptr<ByteStream>(new PlainBytes(std::move(file), part.packed));
}

}  // namespace stillcut::record
