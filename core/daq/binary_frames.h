// Binary frames of any microcontroller or bridge: sync word, counter, samples, checksum. Samples are interleaved:
// every channel of the first instant, then of the second. Integers are handed on as they are; the channel's scale makes
// SI of them.
//
// A frame whose checksum is wrong, or, where there is none, that is not followed by the next, is no frame: the search
// for the sync word goes on one byte after it, so that a sync word inside the samples costs nothing. Missing frames
// show in the counter; without one, what was searched through is a gap of unknown length. Thread: driver; real-time
// after construction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/daq/stream_decoder.h"

namespace stillcut::daq {

enum class SampleKind : std::uint8_t { I8, U8, I16, U16, I24, I32, F32 };
enum class Checksum : std::uint8_t { None, Sum8, Xor8, Crc16, Crc32 };  // Crc16: CCITT, from FFFF; Crc32: IEEE 802.3

struct FrameFormat {
  std::string sync;      // 1 to 8 bytes
  int counterBytes = 0;  // 0, 1, 2 or 4
  int instants = 1;      // in a frame
  SampleKind sample = SampleKind::I16;
  bool bigEndian = false;
  Checksum checksum = Checksum::None;  // over counter and samples, at the end, in the same byte order
  int channels = 1;

  std::size_t size() const;  // bytes
};

// Of the bytes between sync word and checksum; bytes of the result: checksumBytes().
std::uint32_t checksumOf(Checksum kind, std::string_view bytes) noexcept;
int checksumBytes(Checksum kind) noexcept;

class BinaryFrames final : public StreamDecoder {
 public:
  explicit BinaryFrames(FrameFormat format);

  std::size_t feed(std::string_view bytes) noexcept override;
  bool take(std::span<float> values, std::uint64_t& lost) noexcept override;
  void reset() noexcept override;
  bool countsLosses() const noexcept override { return format_.counterBytes > 1; }
  std::uint64_t lossUnit() const noexcept override;
  std::uint64_t damaged() const noexcept override { return damaged_; }

 private:
  bool findFrame() noexcept;
  std::uint32_t whole(std::size_t at, int bytes) const noexcept;
  float sample(std::size_t at) const noexcept;
  void count() noexcept;

  FrameFormat format_;
  std::size_t size_ = 0, payload_ = 0;
  int sampleBytes_ = 2;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  int left_ = 0;  // instants of the frame at begin_
  bool counted_ = false;
  std::uint32_t expected_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t damaged_ = 0;
  bool searching_ = false;  // inside bytes that are no frame
};

}  // namespace stillcut::daq
