// Web socket frames: the standard's own examples, pieces, messages that are too long, and bytes that are none.
#include "core/cnc/sender/web_socket.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace stillcut::cnc {
namespace {

using namespace std::string_literals;

TEST(WebSocket, AMaskedTextIsThatOfTheStandard) {
  EXPECT_EQ(webSocketFrame("Hello", 0x3D21FA37), "\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58"s);
}

TEST(WebSocket, MessagesInPiecesAreRead) {
  WebSocketReader reader;
  const std::string both = "\x81\x05Hello\x89\x02hi"s + "\x81\x7E\x01\x00"s + std::string(256, 'x');
  std::string kinds;
  for (const char c : both) {
    reader.put({&c, 1});
    while (const auto message = reader.next()) {
      kinds += message->kind == WebSocketKind::Text ? "T" : message->kind == WebSocketKind::Ping ? "P" : "?";
      kinds += std::to_string(message->payload.size());
    }
  }
  EXPECT_EQ(kinds, "T5P2T256");
}

TEST(WebSocket, OneThatIsTooLongIsPassedOverAndTheNextIsRead) {
  WebSocketReader reader;
  reader.put("\x81\x7F\x00\x00\x00\x00\x00\x10\x00\x00"s);  // 1 MiB
  for (int i = 0; i < 1024; ++i) {
    reader.put(std::string(1024, 'G'));
    EXPECT_FALSE(reader.next());
  }
  reader.put("\x81\x05Hello"s);
  const auto message = reader.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->payload, "Hello");
}

TEST(WebSocket, WhateverComesEnds) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    WebSocketReader reader;
    std::string bytes(random() % 400, '\0');
    for (char& c : bytes) c = static_cast<char>(random() % 256);
    reader.put(bytes);
    std::size_t read = 0;
    while (const auto message = reader.next()) read += message->payload.size();
    EXPECT_LE(read, bytes.size());
  }
}

}  // namespace
}  // namespace stillcut::cnc
