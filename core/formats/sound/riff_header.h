// The header of a WAV file as it stands, with what is wrong with its sizes: recorders that were killed, lost their
// power, wrote into a pipe or went past 4 GiB leave headers that are not true. Thread: its caller's; not real-time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/result.h"

namespace stillcut::record {

struct RiffHeader {
  enum class Sizes {
    True,
    Short,       // the file holds less than it promises
    Unfinished,  // 0: its recorder writes the size at the end, and did not come to it
    Unknown,     // 0xFFFFFFFF: written into a pipe
    Behind,      // less than what the file holds: its recorder had not come to write the rest of it
    Wrapped,     // more than 32 bits hold: the size is what is left of it
  };
  Sizes sizes = Sizes::True;
  std::uint64_t dataAt = 0;    // [bytes] where the samples begin
  std::uint64_t promised = 0;  // [bytes]
  std::uint64_t held = 0;      // [bytes] of samples
  std::uint16_t format = 0;    // 1: whole numbers, 3: floating point
  std::uint16_t bits = 0;      // of a sample
  int channels = 0;
  int rate = 0;  // [Hz]
};

// Nothing: the file is no WAV or RF64. Error: the chunk of samples is missing.
Result<std::optional<RiffHeader>> readRiffHeader(const std::string& path);

// What is to be said of the sizes; nothing: they are true.
std::optional<Message> noteOfSizes(const RiffHeader& header);

}  // namespace stillcut::record
