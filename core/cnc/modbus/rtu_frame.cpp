#include "core/cnc/modbus/rtu_frame.h"

#include <algorithm>

namespace stillcut::cnc {
namespace {

constexpr std::size_t kShortest = 5;  // unit, function, one byte, checksum
constexpr std::size_t kRepeated = 8;  // the answer to a write
constexpr int kException = 0x80;
constexpr int kWriteCoil = 5, kWriteWord = 6, kWriteCoils = 15, kWriteWords = 16;

int byteAt(std::string_view bytes, std::size_t at) noexcept {
  return static_cast<unsigned char>(bytes[at]);
}

std::uint16_t checksum(std::string_view bytes) noexcept {
  unsigned sum = 0xFFFFU;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? (sum >> 1U) ^ 0xA001U : sum >> 1U;
  }
  return static_cast<std::uint16_t>(sum);
}

int readFunction(RegisterTable table) noexcept {
  switch (table) {
    case RegisterTable::Coil:
      return 1;
    case RegisterTable::Discrete:
      return 2;
    case RegisterTable::Input:
      return 4;
    case RegisterTable::Holding:
      break;
  }
  return 3;
}

}  // namespace

RtuQuestion::RtuQuestion(int unit, int function, int first) noexcept {
  put(unit);
  put(function);
  putWord(first);
}

void RtuQuestion::putWord(int word) noexcept {
  put((word >> 8) & 0xFF);
  put(word & 0xFF);
}

void RtuQuestion::close() noexcept {
  const int sum = checksum(bytes());
  put(sum & 0xFF);
  put(sum >> 8);
}

RtuQuestion RtuQuestion::read(int unit, RegisterTable table, int first, int count) noexcept {
  RtuQuestion q(unit, readFunction(table), first);
  q.putWord(count);
  q.close();
  const bool bits = table == RegisterTable::Coil || table == RegisterTable::Discrete;
  q.dataBytes_ = bits ? 1 : 2 * count;
  return q;
}

RtuQuestion RtuQuestion::write(int unit, RegisterTable table, int first, int count,
                               const RegisterWords& words) noexcept {
  const bool coil = table == RegisterTable::Coil;
  RtuQuestion q(unit, coil ? kWriteCoil : count == 1 ? kWriteWord : kWriteWords, first);
  if (coil) {
    q.putWord(words[0] != 0 ? 0xFF00 : 0);
  } else if (count == 1) {
    q.putWord(words[0]);
  } else {
    q.putWord(count);
    q.put(2 * count);
    for (const std::uint16_t word : words) q.putWord(word);
  }
  q.close();
  return q;
}

bool RtuQuestion::isAnsweredBy(std::string_view frame) const noexcept {
  if (frame.size() < kShortest || frame[0] != bytes_[0]) return false;
  const int asked = byteAt(bytes(), 1), answered = byteAt(frame, 1);
  if (answered == (asked | kException)) return frame.size() == kShortest;
  if (answered != asked) return false;
  if (dataBytes_ > 0) return byteAt(frame, 2) == dataBytes_;
  // Unit, function and place are said again; the value may be what the register holds, and not what was written.
  return frame.size() == kRepeated && frame.substr(0, 4) == bytes().substr(0, 4);
}

BusReply RtuQuestion::replyIn(std::string_view frame) const noexcept {
  BusReply reply;
  reply.ok = (byteAt(frame, 1) & kException) == 0;
  if (!reply.ok || dataBytes_ == 0) return reply;
  if (dataBytes_ == 1) reply.words[0] = byteAt(frame, 3) & 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dataBytes_) / 2; ++i) {
    reply.words[i] = static_cast<std::uint16_t>(byteAt(frame, 3 + 2 * i) * 256 + byteAt(frame, 4 + 2 * i));
  }
  return reply;
}

void RtuReceiver::put(std::string_view bytes) noexcept {
  bytes.remove_prefix(bytes.size() - std::min(bytes.size(), bytes_.size()));
  if (end_ + bytes.size() > bytes_.size()) {
    const std::size_t kept = std::min(end_ - begin_, bytes_.size() - bytes.size());
    std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(end_ - kept),
              bytes_.begin() + static_cast<std::ptrdiff_t>(end_), bytes_.begin());
    begin_ = 0;
    end_ = kept;
  }
  std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(end_));
  end_ += bytes.size();
}

std::size_t RtuReceiver::frameAt(std::string_view bytes) const noexcept {
  if (bytes.size() < kShortest || byteAt(bytes, 0) != unit_) return 0;
  const int function = byteAt(bytes, 1);
  std::size_t size = 0;
  if ((function & kException) != 0) {
    size = kShortest;
  } else if (function >= 1 && function <= 4) {
    size = kShortest + static_cast<std::size_t>(byteAt(bytes, 2));
  } else if (function == kWriteCoil || function == kWriteWord || function == kWriteCoils || function == kWriteWords) {
    size = kRepeated;
  }
  if (size == 0 || size > bytes.size()) return 0;
  const int sum = byteAt(bytes, size - 2) + 256 * byteAt(bytes, size - 1);
  return checksum(bytes.substr(0, size - 2)) == sum ? size : 0;
}

std::optional<std::string_view> RtuReceiver::next() noexcept {
  // Something that only looks like the beginning of a frame must not hide the one behind it, so all places are tried.
  for (std::size_t at = begin_; at < end_; ++at) {
    const std::string_view rest(bytes_.data() + at, end_ - at);
    const std::size_t size = frameAt(rest);
    if (size == 0) continue;
    begin_ = at + size;
    return rest.substr(0, size);
  }
  return std::nullopt;
}

}  // namespace stillcut::cnc
