#include "core/cnc/sender/web_socket.h"

#include <algorithm>
#include <array>
#include <utility>

namespace stillcut::cnc {
namespace {

constexpr unsigned kFinal = 0x80, kText = 0x1, kClose = 0x8, kPing = 0x9, kPong = 0xA;
constexpr unsigned kMasked = 0x80, kTwoBytes = 126, kEightBytes = 127;

unsigned byteAt(std::string_view s, std::size_t at) {
  return static_cast<unsigned char>(s[at]);
}

}  // namespace

std::string webSocketFrame(std::string_view payload, std::uint32_t mask, bool pong) {
  std::string frame;
  frame += static_cast<char>(kFinal | (pong ? kPong : kText));
  if (payload.size() < kTwoBytes) {
    frame += static_cast<char>(kMasked | static_cast<unsigned>(payload.size()));
  } else {  // what is said here fits into two bytes
    payload = payload.substr(0, 0xFFFF);
    frame += static_cast<char>(kMasked | kTwoBytes);
    frame += static_cast<char>(payload.size() >> 8U);
    frame += static_cast<char>(payload.size() & 0xFFU);
  }
  std::array<char, 4> key{};
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = static_cast<char>((mask >> (8U * i)) & 0xFFU);
  frame.append(key.data(), key.size());
  for (std::size_t i = 0; i < payload.size(); ++i) frame += static_cast<char>(payload[i] ^ key[i % key.size()]);
  return frame;
}

void WebSocketReader::clear() {
  held_.clear();
  skip_ = 0;
}

std::optional<WebSocketMessage> WebSocketReader::next() {
  while (true) {
    const auto passed = static_cast<std::size_t>(std::min<std::uint64_t>(skip_, held_.size()));
    held_.erase(0, passed);
    skip_ -= passed;
    if (held_.size() < 2) return std::nullopt;
    std::uint64_t size = byteAt(held_, 1) & 0x7FU;
    const std::size_t more = size == kEightBytes ? 8 : size == kTwoBytes ? 2 : 0;
    const bool masked = (byteAt(held_, 1) & kMasked) != 0;  // a server does not
    const std::size_t head = 2 + more + (masked ? 4 : 0);
    if (held_.size() < head) return std::nullopt;
    if (more > 0) size = 0;
    for (std::size_t i = 0; i < more; ++i) size = (size << 8U) | byteAt(held_, 2 + i);
    if (size > kLongest) {
      held_.erase(0, head);
      skip_ = size;
      continue;
    }
    if (held_.size() < head + size) return std::nullopt;
    const unsigned code = byteAt(held_, 0) & 0xFU;
    WebSocketMessage message;
    message.payload = held_.substr(head, static_cast<std::size_t>(size));
    message.kind = code == kText    ? WebSocketKind::Text
                   : code == kClose ? WebSocketKind::Close
                   : code == kPing  ? WebSocketKind::Ping
                                    : WebSocketKind::Other;
    held_.erase(0, head + static_cast<std::size_t>(size));
    return message;
  }
}

}  // namespace stillcut::cnc
