#include "core/formats/matlab/mat_elements.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>

namespace stillcut::record {
namespace {

constexpr std::uint32_t kMatrix = 14, kCompressed = 15;
constexpr std::size_t kMostVariables = 4096;

// Bytes in a row: of the file, or of what is packed in it.
class ByteRow {
 public:
  virtual ~ByteRow() = default;
  // False: there are not so many.
  virtual bool take(std::span<unsigned char> out) = 0;
  virtual bool skip(std::uint64_t count) = 0;
};

class FileRow final : public ByteRow {
 public:
  FileRow(std::ifstream& file, std::uint64_t size) : file_(file), left_(size) {}
  bool take(std::span<unsigned char> out) override {
    if (out.size() > left_) return false;
    left_ -= out.size();
    file_.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()));
    return static_cast<bool>(file_);
  }
  bool skip(std::uint64_t count) override {
    if (count > left_) return false;
    left_ -= count;
    return static_cast<bool>(file_.seekg(static_cast<std::streamoff>(count), std::ios::cur));
  }
  std::uint64_t left() const { return left_; }

 private:
  std::ifstream& file_;
  std::uint64_t left_;
};

class InflatedRow final : public ByteRow {
 public:
  explicit InflatedRow(ByteRow& packed, std::uint64_t bytes) : packed_(packed), left_(bytes) {
    ready_ = inflateInit(&stream_) == Z_OK;
  }
  ~InflatedRow() override { inflateEnd(&stream_); }
  InflatedRow(const InflatedRow&) = delete;
  InflatedRow& operator=(const InflatedRow&) = delete;

  bool take(std::span<unsigned char> out) override {
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<uInt>(out.size());
    while (ready_ && stream_.avail_out > 0) {
      if (stream_.avail_in == 0 && !refill()) return false;
      const int done = inflate(&stream_, Z_NO_FLUSH);
      ready_ = done == Z_OK;
      if (done == Z_STREAM_END) return stream_.avail_out == 0;
    }
    return stream_.avail_out == 0;
  }
  bool skip(std::uint64_t count) override {
    std::array<unsigned char, 16384> away;
    while (count > 0) {
      const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, away.size()));
      if (!take(std::span(away).first(part))) return false;
      count -= part;
    }
    return true;
  }
  // What the file still has of it.
  std::uint64_t left() const { return left_; }

 private:
  bool refill() {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(left_, in_.size()));
    if (part == 0 || !packed_.take(std::span(in_).first(part))) return false;
    left_ -= part;
    stream_.next_in = in_.data();
    stream_.avail_in = static_cast<uInt>(part);
    return true;
  }

  ByteRow& packed_;
  std::uint64_t left_;
  bool ready_ = false;
  z_stream stream_{};
  std::array<unsigned char, 4096> in_{};
};

struct Tag {
  std::uint32_t type = 0;
  std::uint64_t bytes = 0;  // of content behind the tag; 0 where it stands in the tag itself
};

class Walk {
 public:
  explicit Walk(bool little) : little_(little) {}

  bool readTag(ByteRow& row, Tag& tag) const {
    std::array<unsigned char, 8> raw{};
    if (!row.take(raw)) return false;
    const std::uint32_t type = word(raw, 0);
    const bool isSmall = type >> 16U != 0;  // its few bytes stand in the tag itself
    tag = {isSmall ? type & 0xffffU : type, isSmall ? 0 : word(raw, 4)};
    return true;
  }

  // What is inside an array of `bytes`. The numbers at its end are not unpacked: they are read in parts of a known
  // size, and miss nothing but themselves where they end early.
  bool array(ByteRow& row, std::uint64_t bytes, int depth) {
    constexpr int kDeepest = 16;  // arrays in cells in structs ...
    if (depth > kDeepest) return false;
    bool numbers = false;
    for (int place = 0; bytes > 0; ++place) {
      Tag tag;
      if (bytes < 8 || ++elements_ > kMostElements) return false;
      // Some writers (matio) give a compressed variable a few bytes more than it has: no element is in them.
      if (!readTag(row, tag)) return depth == 0 && place > 3;
      if (tag.bytes > bytes - 8) return false;
      bytes -= 8;
      const std::uint64_t padded = std::min((tag.bytes + 7) / 8 * 8, bytes);
      bytes -= padded;
      if (tag.type == kMatrix) {
        if (!array(row, tag.bytes, depth + 1) || !row.skip(padded - tag.bytes)) return false;
      } else if (place == 0 && padded == 8) {
        if (!isNumbers(row, numbers)) return false;
      } else if (numbers && place > 2 && bytes == 0 && depth == 0) {
        return true;
      } else if (!row.skip(bytes == 0 && depth == 0 ? std::min(tag.bytes, padded) : padded)) {
        return false;  // the last padding is left out by some writers
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t kMostElements = std::size_t{1} << 20U;

  std::uint32_t word(std::span<const unsigned char> raw, std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | raw[at + (little_ ? 3 - i : i)];
    return value;
  }
  // The flags of an array: plain numbers are of the classes 6 (double) to 15 (uint64).
  bool isNumbers(ByteRow& row, bool& numbers) const {
    std::array<unsigned char, 8> flags{};
    if (!row.take(flags)) return false;
    const std::uint32_t kind = word(flags, 0) & 0xffU;
    numbers = kind >= 6 && kind <= 15;
    return true;
  }

  bool little_;
  std::size_t elements_ = 0;
};

// One variable as packed by zlib; `bytes` of the file.
bool compressed(Walk& walk, ByteRow& file, std::uint64_t bytes) {
  constexpr std::uint64_t kMostDeflated = 1100;  // times; zlib's own limit is 1032
  InflatedRow inflated(file, bytes);
  Tag tag;
  return walk.readTag(inflated, tag) && tag.type == kMatrix && tag.bytes <= kMostDeflated * bytes + 64 &&
         walk.array(inflated, tag.bytes, 0) && file.skip(inflated.left());
}

}  // namespace

Status checkMatElements(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<unsigned char, 128> head{};
  file.read(reinterpret_cast<char*>(head.data()), head.size());
  std::error_code problem;
  const std::uint64_t size = std::filesystem::file_size(path, problem);
  const bool little = head[126] == 'I' && head[127] == 'M';
  if (!file || problem || (!little && !(head[126] == 'M' && head[127] == 'I'))) {
    return Error{path, message("is no MATLAB file of version 5 or 7"), message("its header is damaged")};
  }
  FileRow row(file, size - head.size());
  Walk walk(little);
  for (std::size_t variable = 0; row.left() > 0; ++variable) {
    if (variable == kMostVariables) return Error{path, message("holds more than 4096 variables")};
    const std::string where = "variable " + std::to_string(variable);
    Tag tag;
    if (!walk.readTag(row, tag) || tag.bytes > row.left()) {
      return Error{path, message("%1 is longer than the file", where), message("a truncated or damaged file")};
    }
    const std::uint64_t left = row.left() - tag.bytes;
    bool sound = true;
    if (tag.type == kCompressed) sound = compressed(walk, row, tag.bytes);
    if (tag.type == kMatrix) sound = walk.array(row, tag.bytes, 0);
    if (!sound)
      return Error{path, message("%1: a length inside it is wrong", where), message("a truncated or damaged file")};
    if (!row.skip(row.left() - left)) return Error{path, message("%1 cannot be read", where)};
  }
  return Done{};
}

}  // namespace stillcut::record
