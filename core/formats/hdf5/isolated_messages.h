// What goes between openIsolated() and its process, over a socket: first, unasked, what the file is; then, for every
// block capacity that is sent (a 32-bit number), one block. Both ends are of the same build on the same machine. Plain
// values: any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::record::apart {

enum class MessageType : std::uint32_t {
  Session = 1,  // one of ours: nothing follows, ever
  Format,       // JSON
  Refused,      // JSON of an Error: nothing follows
  Block,        // BlockHead and the samples, channel after channel
  End,          // no block is left
};

struct MessageHeader {
  MessageType word = MessageType::End;
  std::uint32_t bytes = 0;  // that follow
};
struct BlockHead {
  std::uint64_t sequence = 0, lostFrames = 0;
  std::int64_t firstSample_ns = 0;
  std::int32_t frames = 0;
  std::uint32_t flags = 0;
};

// False: the other end is gone.
bool send(int peer, std::span<const std::byte> bytes) noexcept;
bool receive(int peer, std::span<std::byte> bytes) noexcept;

std::string toJson(const ReadOptions& options);
std::string toJson(const RecordingFormat& format);  // what a foreign file can say
std::string toJson(const Error& error);
// Throw on what the other end never sends.
ReadOptions optionsFrom(const std::string& json);
RecordingFormat formatFrom(const std::string& json);
Error errorFrom(const std::string& json);

}  // namespace stillcut::record::apart
