#include "core/daq/stream_decoder.h"

#include <cctype>
#include <string>

#include "core/daq/binary_frames.h"
#include "core/daq/text_lines.h"

namespace stillcut::daq {
namespace {

constexpr std::size_t kLongestSync = 8;

// "AA 55" or "aa55"; empty when it is no such thing.
std::string bytesOfHex(const std::string& text) {
  std::string digits;
  for (const char c : text) {
    if (std::isxdigit(static_cast<unsigned char>(c)) != 0) {
      digits += c;
    } else if (c != ' ') {
      return {};
    }
  }
  std::string bytes;
  if (digits.size() % 2 != 0) return {};
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return bytes.size() <= kLongestSync ? bytes : std::string();
}

std::unique_ptr<StreamDecoder> binary(config::ComponentSettings& settings, int channels) {
  FrameFormat f;
  f.channels = channels;
  const std::string sync = settings.text("sync", "");
  f.sync = bytesOfHex(sync);
  if (f.sync.empty()) {
    settings.fault("sync", sync.empty() ? message("is missing") : message("is '%1'", sync),
                   message("binary frames begin with 1 to 8 bytes in hexadecimal, for example AA55"));
  }
  constexpr int kCounters[] = {0, 1, 2, 4};
  f.counterBytes = kCounters[settings.choice("counter", 0, {"none", "u8", "u16", "u32"})];
  f.instants = settings.whole("instants", 1, 1, 4096);
  f.sample = static_cast<SampleKind>(settings.choice("sample", 2, {"i8", "u8", "i16", "u16", "i24", "i32", "f32"}));
  f.bigEndian = settings.choice("byte_order", 0, {"little", "big"}) == 1;
  f.checksum = static_cast<Checksum>(settings.choice("checksum", 0, {"none", "sum8", "xor8", "crc16", "crc32"}));
  return std::make_unique<BinaryFrames>(std::move(f));
}

}  // namespace

std::unique_ptr<StreamDecoder> makeDecoder(config::ComponentSettings& settings, int channels) {
  if (settings.choice("format", 0, {"binary", "text"}) == 0) return binary(settings, channels);
  return std::make_unique<TextLines>(channels, settings.flag("counted", false));
}

}  // namespace stillcut::daq
