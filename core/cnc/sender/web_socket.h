// The frames of a web socket (RFC 6455), a client's side: text out, messages in. What is longer than kLongest is passed
// over without being kept: a sender hands the whole program to everybody who joins.
// Thread: link thread. Memory is bounded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stillcut::cnc {

enum class WebSocketKind : std::uint8_t { Text, Close, Ping, Other };

struct WebSocketMessage {
  WebSocketKind kind = WebSocketKind::Other;
  std::string payload;
};

// One masked frame of text (or the answer to a ping).
std::string webSocketFrame(std::string_view payload, std::uint32_t mask, bool pong = false);

class WebSocketReader {
 public:
  static constexpr std::size_t kLongest = 256 * 1024;

  void put(std::string_view bytes) { held_.append(bytes); }
  // The next whole message; nothing: more has to come.
  std::optional<WebSocketMessage> next();
  void clear();

 private:
  std::string held_;
  std::uint64_t skip_ = 0;  // bytes of a message that is too long
};

}  // namespace stillcut::cnc
