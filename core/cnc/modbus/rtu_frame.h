// The frames of Modbus RTU: a question as bytes, and whether a frame that came is its answer. A frame is an answer when
// its checksum is right and unit, function and byte count (of a write: the place) are those of the question. Nothing
// in it names the question, so an answer that comes late may still look like one to the next: RtuBus sees to that.
// Thread: link thread. Real-time safe; memory is bounded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/cnc/modbus/register_bus.h"

namespace stillcut::cnc {

class RtuQuestion {
 public:
  // `count` as RegisterBus says; `unit` 0..247.
  static RtuQuestion read(int unit, RegisterTable table, int first, int count) noexcept;
  // To Coil (one) or Holding.
  static RtuQuestion write(int unit, RegisterTable table, int first, int count, const RegisterWords& words) noexcept;

  std::string_view bytes() const noexcept { return {bytes_.data(), size_}; }
  // A frame with its checksum, as RtuReceiver gives it. An exception is an answer too, and not ok.
  bool isAnsweredBy(std::string_view frame) const noexcept;
  BusReply replyIn(std::string_view frame) const noexcept;

 private:
  RtuQuestion(int unit, int function, int first) noexcept;
  void put(int byte) noexcept { bytes_[size_++] = static_cast<char>(byte); }
  void putWord(int word) noexcept;
  void close() noexcept;

  std::array<char, 16> bytes_{};
  std::size_t size_ = 0;
  int dataBytes_ = 0;  // of a read's answer
};

// The stream that comes back, cut into frames of one unit. Whatever is none is passed over, a byte at a time.
class RtuReceiver {
 public:
  explicit RtuReceiver(int unit) : unit_(unit) {}
  // What does not fit pushes the oldest out.
  void put(std::string_view bytes) noexcept;
  // The next whole frame, with its checksum; valid until put() or clear().
  std::optional<std::string_view> next() noexcept;
  void clear() noexcept { begin_ = end_ = 0; }

 private:
  // Of the frame that begins with these bytes; 0: none does.
  std::size_t frameAt(std::string_view bytes) const noexcept;

  int unit_;
  std::array<char, 512> bytes_{};
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace stillcut::cnc
