#include "core/daq/binary_frames.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr std::size_t kFramesHeld = 8;

int bytesOf(SampleKind kind) {
  switch (kind) {
    case SampleKind::I8:
    case SampleKind::U8:
      return 1;
    case SampleKind::I16:
    case SampleKind::U16:
      return 2;
    case SampleKind::I24:
      return 3;
    default:
      return 4;
  }
}

std::uint32_t crc16(std::string_view bytes) {
  std::uint32_t crc = 0xFFFF;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint32_t>(static_cast<unsigned char>(c)) << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 0x8000) != 0 ? (crc << 1) ^ 0x1021 : crc << 1;
    crc &= 0xFFFF;
  }
  return crc;
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
  }
  return ~crc;
}

}  // namespace

int checksumBytes(Checksum kind) noexcept {
  constexpr int kBytes[] = {0, 1, 1, 2, 4};
  return kBytes[static_cast<int>(kind)];
}

std::uint32_t checksumOf(Checksum kind, std::string_view bytes) noexcept {
  std::uint32_t all = 0;
  switch (kind) {
    case Checksum::None:
      return 0;
    case Checksum::Sum8:
      for (const char c : bytes) all += static_cast<unsigned char>(c);
      return all & 0xFF;
    case Checksum::Xor8:
      for (const char c : bytes) all ^= static_cast<unsigned char>(c);
      return all;
    case Checksum::Crc16:
      return crc16(bytes);
    case Checksum::Crc32:
      return crc32(bytes);
  }
  return 0;
}

std::size_t FrameFormat::size() const {
  const int payload = channels * instants * bytesOf(sample);
  return sync.size() + static_cast<std::size_t>(counterBytes + payload + checksumBytes(checksum));
}

BinaryFrames::BinaryFrames(FrameFormat format)
    : format_(std::move(format)),
      size_(format_.size()),
      payload_(format_.sync.size() + static_cast<std::size_t>(format_.counterBytes)),
      sampleBytes_(bytesOf(format_.sample)),
      buffer_(std::max<std::size_t>(kFramesHeld * size_, 4096)) {}

std::uint64_t BinaryFrames::lossUnit() const noexcept {
  return format_.counterBytes == 1 ? 256U * static_cast<unsigned>(format_.instants) : 1U;
}

void BinaryFrames::reset() noexcept {
  begin_ = end_ = 0;
  left_ = 0;
  counted_ = searching_ = false;
  lost_ = 0;
}

std::size_t BinaryFrames::feed(std::string_view bytes) noexcept {
  if (begin_ > 0) {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  const std::size_t n = std::min(bytes.size(), buffer_.size() - end_);
  std::copy_n(bytes.begin(), n, buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
  end_ += n;
  return n;
}

std::uint32_t BinaryFrames::whole(std::size_t at, int bytes) const noexcept {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) {
    const int place = format_.bigEndian ? bytes - 1 - i : i;
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(buffer_[at + static_cast<std::size_t>(i)]))
             << (8 * place);
  }
  return value;
}

float BinaryFrames::sample(std::size_t at) const noexcept {
  const std::uint32_t raw = whole(at, sampleBytes_);
  switch (format_.sample) {
    case SampleKind::I8:
      return static_cast<float>(static_cast<std::int8_t>(raw));
    case SampleKind::I16:
      return static_cast<float>(static_cast<std::int16_t>(raw));
    case SampleKind::I24:
      return static_cast<float>(static_cast<std::int32_t>(raw << 8) >> 8);
    case SampleKind::I32:
      return static_cast<float>(static_cast<std::int32_t>(raw));
    case SampleKind::F32:
      return std::bit_cast<float>(raw);
    default:
      return static_cast<float>(raw);
  }
}

// A frame at begin_, whole and sound; what is before it is skipped. Without a checksum the next sync word has to tell
// that no byte was lost inside.
bool BinaryFrames::findFrame() noexcept {
  const std::string& sync = format_.sync;
  const std::size_t needed = size_ + (format_.checksum == Checksum::None ? sync.size() : 0);
  while (end_ - begin_ >= needed) {
    const char* at = buffer_.data() + begin_;
    const bool followed = needed == size_ || std::memcmp(at + size_, sync.data(), sync.size()) == 0;
    if (followed && std::memcmp(at, sync.data(), sync.size()) == 0) {
      const int sumBytes = checksumBytes(format_.checksum);
      const std::size_t sum = begin_ + size_ - static_cast<std::size_t>(sumBytes);
      const std::string_view covered(at + sync.size(), sum - begin_ - sync.size());
      if (whole(sum, sumBytes) == checksumOf(format_.checksum, covered)) {
        if (searching_ && format_.counterBytes == 0) lost_ = kUnknown;
        searching_ = false;
        return true;
      }
    }
    damaged_ += searching_ ? 0 : 1;
    searching_ = true;
    ++begin_;
  }
  return false;
}

void BinaryFrames::count() noexcept {
  if (format_.counterBytes == 0) return;
  const std::uint32_t number = whole(begin_ + format_.sync.size(), format_.counterBytes);
  const std::uint32_t mask = format_.counterBytes == 4 ? 0xFFFFFFFFU : (1U << (8 * format_.counterBytes)) - 1U;
  const std::uint32_t missing = (number - expected_) & mask;
  if (counted_ && format_.counterBytes > 1 && missing > mask / 2) {
    lost_ = kUnknown;  // it has gone back: the sender was started again
  } else if (counted_) {
    lost_ += std::uint64_t{missing} * static_cast<unsigned>(format_.instants);
  }
  counted_ = true;
  expected_ = (number + 1) & mask;
}

bool BinaryFrames::take(std::span<float> values, std::uint64_t& lost) noexcept {
  if (left_ == 0) {
    if (!findFrame()) return false;
    count();
    left_ = format_.instants;
  }
  const std::size_t step = static_cast<std::size_t>(sampleBytes_);
  const std::size_t first =
      begin_ + payload_ +
      static_cast<std::size_t>(format_.instants - left_) * static_cast<std::size_t>(format_.channels) * step;
  for (std::size_t c = 0; c < static_cast<std::size_t>(format_.channels); ++c) values[c] = sample(first + c * step);
  lost = std::exchange(lost_, 0);
  if (--left_ == 0) begin_ += size_;
  return true;
}

}  // namespace stillcut::daq
