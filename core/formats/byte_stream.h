// Bytes of a file front to back: as they stand, or out of a deflated part. Thread: one; not real-time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"

namespace stillcut::record {

class ByteStream {
 public:
  virtual ~ByteStream() = default;
  // Fills all of `out`; false: there are not so many, or they are damaged.
  virtual bool read(std::span<unsigned char> out) = 0;
  // Passes over `count` bytes.
  bool skip(std::uint64_t count);
};

// A part of a file, of which at most `size` bytes are given once it is unpacked.
struct FilePart {
  std::string path;
  std::uint64_t from = 0;    // [bytes]
  std::uint64_t packed = 0;  // [bytes] in the file
  std::uint64_t size = 0;    // [bytes] unpacked
  bool deflated = false;
};
Result<std::unique_ptr<ByteStream>> openPart(const FilePart& part);

}  // namespace stillcut::record
