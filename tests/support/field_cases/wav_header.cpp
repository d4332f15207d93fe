#include "tests/support/field_cases/wav_header.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace stillcut::field {
namespace {

constexpr std::uint32_t kHeadBytes = 36;  // of the RIFF chunk before the samples

void put(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xffU);
}

struct Announced {
  std::uint32_t riff, data;  // bytes
};

Announced announced(WavHeader header, std::uint32_t bytes) {
  switch (header) {
    case WavHeader::Killed:
      return {0x80000000U + kHeadBytes, 0x80000000U};
    case WavHeader::Largest:
      return {0x7ffff000U + kHeadBytes, 0x7ffff000U};
    case WavHeader::Zero:
      return {0, 0};
    case WavHeader::CutOff:
      return {kHeadBytes + bytes + 100, bytes + 100};
    case WavHeader::Streamed:
      break;
  }
  return {0xffffffffU, 0xffffffffU};
}

}  // namespace

FileCase wavFile(FieldCase cut, WavHeader header) {
  const Signal& signal = cut.signal;
  const auto channels = static_cast<std::uint32_t>(signal.channels.size());
  const auto rate = static_cast<std::uint32_t>(signal.rate);
  const std::size_t frames = signal.channels.front().size();
  const Announced size = announced(header, static_cast<std::uint32_t>(2 * channels * frames));
  std::string bytes = "RIFF";
  put(bytes, size.riff, 4);
  bytes += "WAVEfmt ";
  put(bytes, 16, 4);
  put(bytes, 1, 2);  // PCM
  put(bytes, channels, 2);
  put(bytes, rate, 4);
  put(bytes, 2 * channels * rate, 4);
  put(bytes, 2 * channels, 2);
  put(bytes, 16, 2);
  bytes += "data";
  put(bytes, size.data, 4);
  for (std::size_t f = 0; f < frames; ++f) {
    for (const auto& channel : signal.channels) {
      put(bytes, static_cast<std::uint32_t>(std::lround(32768.0 * static_cast<double>(channel[f]))), 2);
    }
  }
  return {std::move(cut), ".wav", std::move(bytes)};
}

}  // namespace stillcut::field
