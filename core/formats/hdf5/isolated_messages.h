// What goes between IsolatedProcess and its program, over a socket. Either a recording is read: first, unasked, what
// the file is; then an answer to every request. Or one thing is asked (Ask), and one answer comes. Both ends are of the
// same build on the same machine. Plain values: any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/formats/recording_reader.h"

namespace stillcut::record::apart {

enum class MessageType : std::uint32_t {
  Format = 1,  // CBOR
  Refused,     // JSON of an Error
  Block,       // BlockHead, the samples channel after channel, and the step of a session
  End,         // no block is left; it cannot be read from there
  Answer,      // CBOR
};
constexpr std::uint32_t kLongestMessage = 1U << 30U;

struct MessageHeader {
  MessageType word = MessageType::End;
  std::uint32_t bytes = 0;  // that follow
};
struct Request {
  enum class Kind : std::int32_t { Block, Seek };
  Kind kind = Kind::Block;
  std::int32_t capacity = 0;  // frames, of a block
  std::int64_t time_ns = 0;   // to seek
};
struct BlockHead {
  std::uint64_t sequence = 0, lostFrames = 0;
  std::int64_t firstSample_ns = 0;
  double rate = 0.0;
  std::int32_t frames = 0;
  std::uint32_t flags = 0, source = 0;
  std::uint32_t hasStep = 0, stepFlags = 0;  // of its block, as recorded: the reader marks the last one
};
// A step without its block, which goes before it.
constexpr std::size_t kStepBytes = sizeof(MachineState) + sizeof(int) + sizeof(StepInput::inputs) + sizeof(StepOutput);
void packStep(const StepRecord& step, std::span<std::byte, kStepBytes> out);
void unpackStep(std::string_view bytes, StepRecord& step);

// One thing that is asked of a file.
struct Ask {
  std::string what;       // "markers"
  std::string arguments;  // JSON
  Seconds patience{};     // of processor time; 0: as long as anything may take
};

// False: the other end is gone.
bool send(int peer, std::span<const std::byte> bytes) noexcept;
bool receive(int peer, std::span<std::byte> bytes) noexcept;

std::string toJson(const ReadOptions& options);
std::string toJson(const Ask& ask);
std::string toJson(const Error& error);
std::string toCbor(const RecordingFormat& format);
// Throw on what the other end never sends.
ReadOptions optionsFrom(const std::string& json);
std::optional<Ask> askFrom(const std::string& json);  // nothing: the recording is to be read
RecordingFormat formatFrom(const std::string& cbor);
Error errorFrom(const std::string& json);

}  // namespace stillcut::record::apart
